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
  /// Chosen quarter indices of corners; all others have the index of the smallest rotation.
  std::vector<CornerChoice> corners;
  /// Singularities that are not changed; missing ones are added to them.
  Configuration given;
  /// Adds a +1 for corners in [3π/4, π), one for every two consecutive corners, and the same number
  /// of −1 elsewhere, so that these corners become regular points of the boundary.
  bool cancelFlatCorners = false;
};

/// Returns a consistent configuration derived from counting and distances alone: the given
/// singularities, those that cancel corners, and as many of +1 or −1 as the Poincaré-Hopf theorem
/// still requires (paper, the algorithm that closes "Generalized Poincaré-Hopf theorem").
///
/// Positions are spread: each singularity is moved in turn to the centre of the largest disk that
/// fits between the boundary and the disks of the others, on a grid of 1/64 of the domain's size.
/// Radii are those of AssignRadii. Throws Error when a given singularity lies outside the domain,
/// or the domain is too thin.
Configuration SpreadConfiguration(
  const PlanarDomain& domain, const SpreadOptions& options = {}, const Progress& progress = {});

/// Returns the position on the same grid with the largest free disk, given these singularities;
/// none if the domain is too thin.
std::optional<Point> FindFreePlace(const PlanarDomain& domain, const Configuration& others);

/// Sets the radii of the singularities from index `first` on to those that a drilled mesh of the
/// default size would choose (HoleRadii.h).
void AssignRadii(const PlanarDomain& domain, Configuration& configuration, std::size_t first = 0);
}
