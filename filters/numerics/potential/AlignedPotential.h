#pragma once

#include "AlignedSources.h"

namespace crossfield
{
/// The potential Φ conjugate to a phase that is aligned with outer and inner loops and turns d_i
/// times around hole i (docs/method.md §2.3; paper, "How to evaluate the choice of a singularity location").
struct AlignedPotential
{
  Eigen::VectorXd solution;  ///< Rows of PotentialSolver: Φ at the vertices, then its periods.
  Eigen::Matrix2Xd gradient; ///< Of every triangle.
  double energy = 0.0;       ///< ½ ∫ |∇Φ|².
  /// Per inner loop, in (−π, π]: the phase that the single-valued potential carries to it minus the
  /// phase of its alignment. Where it is not zero a harmonic field with a period was added.
  std::vector<double> holonomyDefect;
  /// Per inner loop: φ at the first edge of its strip minus φ at the last one, with all turns.
  Eigen::VectorXd carriedPhase;
};

/// Sources at the vertices of outer and inner loops as given, −2πd_i on hole i, where Φ is one
/// unknown constant, and one period per inner loop so that the phase fits its alignment. How often
/// the phase turns on the way to an inner loop is an integer to choose: the nearest to the
/// single-valued potential, then improved one loop at a time while that lowers the energy.
AlignedPotential SolveAligned(const PotentialProblem& problem, const AlignedSources& sources);

/// The potential that is constant on every hole, with these sources, rows of PotentialSolver: only the sum over each hole
/// counts.
Eigen::VectorXd SolveConstantOnHoles(const PotentialSolver& potential,
  const Eigen::VectorXd& sources, PotentialSolver::Periods periods);

/// Sources at hole vertices, rows of PotentialSolver: this multiple of 2π times the quarter index of each hole.
Eigen::VectorXd TurnsOfHoles(const PotentialSolver& potential, double factor);

/// Phase of the alignment at the first edge of the strip to inner loop k minus that at its last one,
/// modulo 2π.
double AlignedDifference(
  const PotentialProblem& problem, const AlignedSources& sources, Eigen::Index k);

/// The phase differences defect_k + 2π n_k, n_k integer, of least ½ offsetᵀ inverse offset, found by
/// steps of one n_k at a time; `inverse` is the inverse of the periods' Schur complement.
Eigen::VectorXd NearestOffsets(const Eigen::VectorXd& defects, const Eigen::MatrixXd& inverse);
}
