#pragma once

#include "Alignment.h"

#include <vector>

namespace crossfield
{
/// Sources of the conjugate potential Φ for a field aligned with outer and inner loops: ∇φ = rot ∇Φ
/// with the phase φ = 4τ along the boundary (docs/method.md §2.4, §5.2).
struct AlignedSources
{
  /// Rows of PotentialOperator: the jump of φ at every vertex of outer and inner loops.
  Eigen::VectorXd atRows;
  /// φ at the midpoint of an edge minus 4τ, in the order of mesh.boundary.
  Eigen::VectorXd midpointShift;
};

/// Returns the sources for φ = 4τ constant along every edge. At a vertex φ jumps by 4 × the
/// smallest rotation of the cross, or by 4 (turning − k π/2) for a chosen quarter index k. With
/// these sources the discrete conjugacy with the phase of the Crouzeix-Raviart field is exact.
AlignedSources PiecewiseConstantPhase(const PotentialProblem& problem);

/// Sources for the curves that a polygon approximates, and points of these curves.
struct CurveSources
{
  AlignedSources aligned;
  /// Rows of PotentialOperator: the jump of φ at each vertex. It is zero within rounding except at
  /// corners and chosen vertices; on a curve it is −2πk for a chosen quarter index k.
  Eigen::VectorXd jumps;
  /// Growth of φ along the first and the second half of every entry of mesh.boundary.
  Eigen::Matrix2Xd growth;
  std::vector<Point> start;  ///< Points of the curve for the starts of the entries.
  std::vector<Point> middle; ///< Points of the curve for the midpoints of the entries.
};

/// Returns the sources for the phase of the curves that a polygon approximates.
///
/// If the boundary turns by less than the corner angle at a vertex, the jump is spread evenly over
/// half of the polygon's side before it and half of the side after it. A side of the polygon may
/// consist of several mesh edges; PiecewiseConstantPhase would see corners between such sides. φ
/// varies along a side, and for smooth curves the sources are the curvature up to second order. If
/// a side is more than twice as long as its neighbour, such as a straight part next to a curve,
/// only twice the neighbour's length is used. If no side was divided and all have the same length,
/// the sources equal those of PiecewiseConstantPhase.
///
/// Corners keep their jump, less the turn of a curve's tangent along half of a side next to them.
/// The tangent is continuous at a chosen vertex that is no corner: only the part −2πk of its jump
/// remains there. The curve passes through the ends of every side, with this tangent.
CurveSources CurvePhase(const PotentialProblem& problem);

/// Returns the sources for φ continuous and linear along every edge of the mesh, with the values of
/// CurvePhase at vertices and the mean of the two values at corners. These boundary values have
/// finite energy, so conforming functions bound it from both sides (docs/method.md §5.2). The flux
/// through an edge is divided equally between its ends.
AlignedSources LinearPhase(const PotentialProblem& problem);

/// φ − 4τ of LinearPhase at the start and end of every boundary edge, in the order of
/// mesh.boundary.
struct EdgePhases
{
  Eigen::VectorXd start;
  Eigen::VectorXd end;
};
EdgePhases LinearEdgePhases(const PotentialProblem& problem);
}
