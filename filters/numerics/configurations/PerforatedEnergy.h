#pragma once

#include "Alignment.h"

namespace crossfield
{
/// Energies E = ½ ∫ |∇φ|² of the unit-norm field on a perforated mesh, φ turning d_i times around
/// hole i (docs/method.md §5; paper, "How to evaluate the choice of a singularity location").
struct PerforatedEnergy
{
  /// Aligned with outer and inner loops: the energy of UnitNormField.h, phase constant along edges.
  /// An estimate; it is ½ ∫ |∇Φ|² of the conjugate potential.
  double aligned = 0.0;
  /// Bounds of the aligned energy on this polygon when the phase is linear along its edges (LinearPhase
  /// of AlignedSources.h): from continuous piecewise linear Φ and φ. Their gap is the discretisation
  /// error. At a corner with a rotation of the cross both grow with the logarithm of the mesh size.
  double alignedLower = 0.0;
  double alignedUpper = 0.0;
  /// Free to rotate along outer and inner loops, Φ = 0 there, so that the turns around inner loops are free
  /// as well: bounds from Φ and φ. The lower one is
  /// at the same time the energy of the Crouzeix-Raviart phase.
  double degreeOnlyLower = 0.0;
  double degreeOnlyUpper = 0.0;
  std::vector<double> holonomyDefect; ///< See AlignedPotential.
};

/// Two factorisations of the P1 Laplacian: with the boundary free, for Φ given by its flux and for φ
/// when it is free, and with the boundary given.
///
/// Throws Error when the quarter indices violate Poincaré-Hopf.
PerforatedEnergy ComputePerforatedEnergy(
  const SharedTopology& topology, const std::vector<CornerChoice>& corners = {});
}
