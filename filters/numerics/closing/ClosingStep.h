#pragma once

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Linearised conditions on the moves of singularities, in clearances: unknown y_j is the move of
/// coordinate j divided by the clearance of its singularity.
struct ClosingConditions
{
  Eigen::MatrixXd lengths; ///< Derivatives of arc lengths, a row per arc that should vanish.
  Eigen::VectorXd length;  ///< The lengths now, in sides of quads.
  Eigen::MatrixXd defects; ///< Derivatives of holonomy defects, a row per inner loop.
  Eigen::VectorXd defect;  ///< The defects now, radians of θ.
  /// Solves without damping once all lengths are below a tenth of a quad, for lengths of 0 exactly.
  bool exact = false;
};

/// A step towards the conditions.
struct ClosingStep
{
  Eigen::VectorXd moves; ///< y.
  /// Lengths that no step changes enough in the linearised problem: rows whose remaining length
  /// exceeds both half of the length and a tenth of a quad. Only those with at least half of the
  /// largest remainder, since others may follow from these; the largest first.
  std::vector<Eigen::Index> unreachable;
};

/// Solves the linearised conditions (docs/method.md §14.10): the defects vanish exactly, lengths in
/// the sense of least squares with damping, as rows depend on each other. Damping is weaker when all
/// lengths are below a tenth of a quad.
ClosingStep SolveClosing(const ClosingConditions& conditions);
}
