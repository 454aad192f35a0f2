#pragma once

#include "BoundaryCorners.h"
#include "Progress.h"
#include "Singularity.h"

#include <optional>

namespace crossfield
{
struct SpreadOptions
{
  double cornerAngle = DefaultCornerAngle;
  /// Chosen quarter indices of corners; the others count by the smallest rotation.
  std::vector<CornerChoice> corners;
  /// Singularities that stay as they are; those that they lack are added.
  Configuration given;
  /// Adds a +1 for corners in [3π/4, π), one for two corners that follow each other, and as many
  /// −1 elsewhere, so that these corners become regular points of the boundary.
  bool cancelFlatCorners = false;
};

/// A consistent configuration from counting and room alone: the given singularities, then those that
/// cancel corners, then as many of +1 or −1 as the Poincaré-Hopf theorem still asks for (paper, the
/// algorithm that closes "Generalized Poincaré-Hopf theorem").
///
/// Positions are spread: each is moved in turn to where the largest disk fits between the boundary
/// and the disks of the others, on a grid of 1/64 of the domain's size. Radii are those of
/// GiveRadii. Throws Error when a given singularity lies outside the domain, or there is no room.
Configuration SpreadConfiguration(
  const PlanarDomain& domain, const SpreadOptions& options = {}, const Progress& progress = {});

/// The place with the most room beside singularities, on the same grid; none where the domain is too thin.
std::optional<Point> RoomiestPlace(const PlanarDomain& domain, const Configuration& others);

/// Gives singularities from the number `first` on the radius that a drilled mesh of the default size would
/// choose (HoleRadii.h).
void GiveRadii(const PlanarDomain& domain, Configuration& configuration, std::size_t first = 0);
}
