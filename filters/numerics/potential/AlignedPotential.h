#pragma once

#include "AlignedSources.h"

namespace crossfield
{
/// The potential Φ conjugate to a phase that is aligned with outer and inner loops and turns d_i
/// times around hole i (docs/method.md §2.3; paper, "How to evaluate the choice of a singularity
/// location").
struct AlignedPotential
{
  Eigen::VectorXd solution;  ///< Rows of PotentialOperator: Φ at the vertices, then its periods.
  Eigen::Matrix2Xd gradient; ///< ∇Φ, a column per triangle.
  double energy = 0.0;       ///< ½ ∫ |∇Φ|².
  /// Per inner loop, in (−π, π]: the phase that the single-valued potential carries to it minus the
  /// phase of its alignment. If it is not zero, a harmonic field with a period was added.
  std::vector<double> holonomyDefect;
  /// Per inner loop: φ at the first edge of its strip minus φ at the last one, whole turns
  /// included.
  Eigen::VectorXd carriedPhase;
};

/// Solves for Φ with the given sources at the vertices of outer and inner loops, the source −2πd_i
/// on hole i, on which Φ is an unknown constant, and one period per inner loop so that the phase
/// fits its alignment. The number of whole turns of the phase along the path to an inner loop is
/// free: it is the nearest to the single-valued potential, then changed one loop at a time while
/// that lowers the energy.
AlignedPotential SolveAligned(const PotentialProblem& problem, const AlignedSources& sources);

/// Solves for the potential that is constant on every hole, with these sources, rows of
/// PotentialOperator. Only the sum of the sources over each hole has an effect. Eliminates the
/// edges of holes anew in every call.
Eigen::VectorXd SolveConstantOnHoles(const PotentialFactor& factor, const Eigen::VectorXd& sources,
  PotentialOperator::Periods periods);

/// Returns sources at hole vertices, rows of PotentialOperator, that add up to `factor` · 2π times
/// its quarter index on each hole.
Eigen::VectorXd TurnsOfHoles(const PotentialOperator& laplacian, double factor);

/// Returns the phase of the alignment at the first edge of the strip to inner loop k minus that at
/// its last edge, modulo 2π.
double AlignedDifference(
  const PotentialProblem& problem, const AlignedSources& sources, Eigen::Index k);

/// Minimises ½ offsetᵀ inverse offset over the phase differences offset_k = defect_k + 2π n_k, n_k
/// integers, by steps of one n_k at a time; `inverse` is the inverse of the periods' Schur
/// complement.
Eigen::VectorXd NearestOffsets(const Eigen::VectorXd& defects, const Eigen::MatrixXd& inverse);
}
