#pragma once

#include "Alignment.h"

namespace crossfield
{
/// Bounds of E = ½ ∫ |∇φ|² on a perforated mesh, φ = 4θ of a field of norm one that turns d_i times around
/// hole i (docs/method.md §5.2; paper, "How to evaluate the choice of a singularity location"). Errors
/// of the two bounds have opposite signs and tend to the same size: the estimate is their middle.
struct PerforatedEnergy
{
  /// Aligned with outer and inner loops, the phase linear along their edges (LinearPhase of
  /// AlignedSources.h): from continuous piecewise linear Φ and φ. The gap is the discretisation
  /// error. At a corner with a rotation of the cross both grow with the logarithm of the mesh size.
  double alignedLower = 0.0;
  double alignedUpper = 0.0;
  /// Free to rotate along outer and inner loops, Φ = 0 there, so that the turns around inner loops are free
  /// as well: bounds from Φ and φ. The lower one is
  /// at the same time the energy of the Crouzeix-Raviart phase.
  double degreeOnlyLower = 0.0;
  double degreeOnlyUpper = 0.0;
  std::vector<double> holonomyDefect; ///< See AlignedPotential.

  double Aligned() const { return 0.5 * (this->alignedLower + this->alignedUpper); }
  double DegreeOnly() const { return 0.5 * (this->degreeOnlyLower + this->degreeOnlyUpper); }
};

/// Two factorisations of the P1 Laplacian: with the boundary free, for Φ given by its flux and for φ
/// when it is free, and with the boundary given.
///
/// Throws Error when the quarter indices violate Poincaré-Hopf.
PerforatedEnergy ComputePerforatedEnergy(
  const SharedTopology& topology, const std::vector<CornerChoice>& corners = {});
}
