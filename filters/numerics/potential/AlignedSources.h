#pragma once

#include "Alignment.h"

#include <vector>

namespace crossfield
{
/// What alignment with outer and inner loops asks of the conjugate potential Φ: ∇φ = rot ∇Φ with the
/// phase φ = 4τ along the boundary (docs/method.md §2.4, §5.2).
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
AlignedSources PiecewiseConstantPhase(const PotentialProblem& problem);

/// What the curves that a polygon stands for ask, and where they are.
struct CurveSources
{
  AlignedSources aligned;
  /// Rows of PotentialSolver: the jump of φ at each vertex, zero but for rounding except at corners and
  /// chosen vertices. On a curve it is −2πk for a chosen quarter index k.
  Eigen::VectorXd jumps;
  /// By how much φ grows along the first and the second half of every entry of mesh.boundary,
  Eigen::Matrix2Xd growth;
  /// and the points of the curve that stand for its start and its midpoint.
  std::vector<Point> start;
  std::vector<Point> middle;
};

/// The phase of the curves that a polygon stands for. Where the boundary turns by less than the corner
/// angle the jump is spread evenly over half of the polygon's sides before and after; a side is not
/// the mesh edges that it was divided into, on which the former would see corners. φ varies along a
/// side, and for smooth curves the sources are the curvature up to second order. Of sides more than
/// twice as long as their neighbour, straight parts beside a curve, no more than that length takes
/// part. The same as the former where no side was divided and all have one length. Corners keep their
/// jump, less what the tangent of a curve turns along half of a side next to them. The tangent passes
/// smoothly through a chosen vertex that is no corner: of its jump only −2πk stays there. The curve goes
/// through the ends of every side, with this tangent.
CurveSources CurvePhase(const PotentialProblem& problem);

/// φ continuous and linear along every edge of the mesh, with the values of CurvePhase at vertices,
/// at corners halfway between the two values: boundary values of finite energy, so that conforming
/// functions bound it from both sides (docs/method.md §5.2). The flux through an edge goes to its ends in equal
/// parts.
AlignedSources LinearPhase(const PotentialProblem& problem);

/// φ − 4τ at the start and end of every boundary edge for LinearPhase, in the order of mesh.boundary.
struct EdgePhases
{
  Eigen::VectorXd start;
  Eigen::VectorXd end;
};
EdgePhases LinearEdgePhases(const PotentialProblem& problem);
}
