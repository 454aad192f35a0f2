#pragma once

#include "PerforatedProblem.h"

namespace crossfield
{
/// What alignment with outer and inner loops asks of the conjugate potential Φ: ∇φ = rot ∇Φ with the
/// phase φ = 4τ along the boundary (METHOD §2, §5).
struct AlignedSources
{
  /// Rows of PotentialSolver: the jump of φ at every vertex of outer and inner loops.
  Eigen::VectorXd atRows;
  /// φ at the midpoint of an edge minus 4τ, in the order of mesh.boundary.
  Eigen::VectorXd midpointShift;
};

/// φ = 4τ constant along every edge; at a vertex it jumps by 4 × the smallest rotation of the cross,
/// or 4 (turning − k π/2) for a chosen quarter index k. With these sources the discrete conjugacy is
/// exact: the phase of the Crouzeix-Raviart field.
AlignedSources PiecewiseConstantPhase(const PerforatedProblem& problem);

/// φ continuous and linear along every edge, at a vertex halfway between the two values of the
/// former: boundary values of finite energy, so that conforming functions bound it from both sides.
/// The flux (jump_p + jump_q) / 2 through edge pq goes to its ends in equal parts.
AlignedSources LinearPhase(const PerforatedProblem& problem);

/// The angle modulo 2π in (−π, π].
double WrapAngle(double angle);

/// The phase differences defect_k + 2π n_k, n_k integer, of least ½ offsetᵀ inverse offset, found by
/// steps of one n_k at a time; `inverse` is the inverse of the periods' Schur complement.
Eigen::VectorXd NearestOffsets(const Eigen::VectorXd& defects, const Eigen::MatrixXd& inverse);
}
