#pragma once

#include "Alignment.h"

namespace crossfield
{
/// Bounds of E = ½ ∫ |∇φ|² on a perforated mesh, where φ = 4θ belongs to a field of norm one that
/// turns d_i times around hole i (docs/method.md §5.2; paper, "How to evaluate the choice of a
/// singularity location"). The errors of the two bounds have opposite signs and tend to the same
/// magnitude, so the estimate is their mean.
struct PerforatedEnergy
{
  /// Bounds for a field aligned with outer and inner loops, with a phase that is linear along their
  /// edges (LinearPhase of AlignedSources.h), computed from continuous piecewise linear Φ and φ.
  /// The gap between them is the discretisation error. At a corner with a rotation of the cross,
  /// both grow with the logarithm of the mesh size.
  double alignedLower = 0.0;
  double alignedUpper = 0.0;
  /// Bounds for a field that may rotate along outer and inner loops, computed from Φ and φ. Φ = 0
  /// on these loops, so the turns around inner loops are free too. The lower bound is also the
  /// energy of the Crouzeix-Raviart phase.
  double degreeOnlyLower = 0.0;
  double degreeOnlyUpper = 0.0;
  std::vector<double> holonomyDefect; ///< See AlignedPotential.

  /// Returns the mean of the bounds.
  double Aligned() const { return 0.5 * (this->alignedLower + this->alignedUpper); }
  /// Returns the mean of the bounds.
  double DegreeOnly() const { return 0.5 * (this->degreeOnlyLower + this->degreeOnlyUpper); }
};

/// Computes the bounds by two factorisations of the P1 Laplacian: one with free boundary, for Φ
/// given by its flux and for φ where it is free, and one with prescribed boundary values.
///
/// Throws Error if the quarter indices violate Poincaré-Hopf.
PerforatedEnergy ComputePerforatedEnergy(
  const SharedPlanarTopology& topology, const std::vector<CornerChoice>& corners = {});
}
