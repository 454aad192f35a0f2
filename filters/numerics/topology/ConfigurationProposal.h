#pragma once

#include "BoundaryCorners.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
struct ProposalOptions
{
  double cornerAngle = DefaultCornerAngle;
  /// Chosen quarter indices of corners; the others count by the smallest rotation.
  std::vector<CornerChoice> corners;
  /// Singularities that stay as they are; the proposal adds what they lack.
  Configuration given;
  /// Adds a +1 for corners in [3π/4, π), one for two corners that follow each other, and as many
  /// −1 elsewhere, so that these corners become regular points of the boundary.
  bool cancelFlatCorners = false;
};

/// A consistent starting configuration: the given singularities, then those that cancel corners,
/// then as many of +1 or −1 as the Poincaré-Hopf theorem still asks for (paper, the algorithm that
/// closes "Generalized Poincaré-Hopf theorem").
///
/// Positions are spread: each is moved in turn to where the largest disk fits between the boundary
/// and the disks of the others, on a grid of 1/64 of the domain's size. Radii are a third of these
/// disks, or 1/40 of the domain's diagonal if that is less. Throws Error when a given singularity
/// lies outside the domain, or there is no room.
Configuration ProposeConfiguration(
  const PlanarDomain& domain, const ProposalOptions& options = {}, const Progress& progress = {});
}
