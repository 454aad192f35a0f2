#pragma once

#include "AlignedSources.h"
#include "LogSource.h"
#include "Singularity.h"

namespace crossfield
{
/// Half of a boundary edge, with the domain on its left: the part of the boundary that one vertex
/// stands for.
struct BoundaryHalf
{
  int vertex = 0;
  Point from = Point::Zero();
  Point to = Point::Zero();
  double growth = 0.0; ///< Of the phase along it, without the jumps that have a logarithm.
  /// Of the logarithms on the boundary: what flows through the half, and the mean of their sum.
  double logFlux = 0.0;
  double logMean = 0.0;
};

/// The potential of singularities that are points, on a mesh without holes (docs/method.md §5.3, §11.3):
///   Φ = R + Σ_j d_j log|x − b_j| + Σ_c s_c / (−α_c) log|x − p_c|,
/// b_j the singularities, p_c the corners of angle α_c at which the phase has to turn by s_c ≠ 0, and
/// the singularities of curves: there α_c = π, s_c = −2πk, and p_c is the point of the curve, from which
/// the curve is seen instead of the polygon.
/// The regular part R is a P1 function with periods. Its sources at a boundary vertex v are those of
/// alignment minus the angles at which all b_j, p_c see the two halves of edges at v, times the
/// strengths: there are no deltas on the mesh, and the phase of R plus the exact arguments is that of
/// CurvePhase on every boundary edge. The mesh is factored once; a further configuration costs one back-substitution, or
/// none but small sums when only the boundary values are asked for.
class PointPotential
{
public:
  /// What one configuration leads to.
  struct Solution
  {
    std::vector<LogSource> logs;        ///< The singularities in their order, then the boundary's.
    Eigen::VectorXd sources;            ///< Of R; rows of PotentialSolver.
    Eigen::VectorXd regular;            ///< R, single-valued.
    Eigen::VectorXd aligned;            ///< R with the periods that align inner loops.
    std::vector<double> holonomyDefect; ///< See AlignedPotential.
    Eigen::VectorXd offsets;            ///< The same with the turns that were chosen.
    Eigen::VectorXd periods;            ///< Of R around inner loops, zero where the offsets are.
  };

  /// `alignment` with the sum of the quarter indices of every configuration to come. Throws Error when
  /// that violates Poincaré-Hopf, or when the mesh has holes.
  PointPotential(std::shared_ptr<const PotentialSolver> solver, Alignment alignment);

  /// Throws Error when a singularity is not inside the domain, or nearer to its boundary than 1e-6 of
  /// the diagonal or to another one, or the sum of the quarter indices is another one.
  Solution Solve(const Configuration& configuration) const;

  /// The single-valued part R of given sources, rows of PotentialSolver: those at periods must be zero,
  /// those at vertices add up to zero. As a matrix between vertices it is symmetric.
  Eigen::VectorXd SolveSingleValued(const Eigen::VectorXd& sources) const;

  const PlanarDomain& GetDomain() const { return this->Domain; }
  const PotentialProblem& GetProblem() const { return this->Problem; }
  const std::vector<BoundaryHalf>& GetHalves() const { return this->Halves; }
  /// The logarithms of the boundary, those of curves first; their strengths are whole numbers.
  const std::vector<LogSource>& GetBoundaryLogs() const { return this->BoundaryLogs; }
  std::size_t CurveLogCount() const { return this->CurveLogs; }
  /// Mesh vertex of each.
  const std::vector<int>& GetBoundaryLogVertices() const { return this->LogVertices; }
  /// The point of the curve at the midpoint of every entry of mesh.boundary.
  const std::vector<Point>& GetCurveMiddles() const { return this->Curve.middle; }
  /// φ at the midpoints of boundary edges minus 4τ; see CurvePhase.
  const Eigen::VectorXd& GetMidpointShift() const { return this->Curve.aligned.midpointShift; }
  /// Per inner loop the solution for a unit source at its period.
  const Eigen::MatrixXd& GetPeriodBasis() const { return this->PeriodBasis; }
  /// Midpoints of the boundary edges between which strip k carries the phase.
  std::array<Point, 2> StripEnds(Eigen::Index k) const;

private:
  /// Finds the logarithms of the boundary.
  void FindBoundaryLogs();
  /// Of a half, on the polygon or on the curve.
  std::array<Point, 2> Ends(std::size_t half, bool onCurve) const;
  /// The angle at which the position of a logarithm of the boundary sees every half: a corner those of the
  /// polygon, a point of a curve those of the curve. They add up to its angle.
  std::vector<double> Turns(std::size_t boundaryLog) const;
  /// Angle at which a position sees the way along strip k from its end to its start.
  double StripTurn(const LogSource& log, Eigen::Index k, const std::array<Point, 2>& ends) const;

  PotentialProblem Problem;
  PlanarDomain Domain; ///< Polygons of the mesh.
  CurveSources Curve;
  std::vector<std::size_t> Next;    ///< The entry of mesh.boundary that starts where one ends.
  std::vector<BoundaryHalf> Halves; ///< Two for every entry of mesh.boundary.
  std::vector<LogSource> BoundaryLogs;
  std::vector<int> LogVertices;
  std::size_t CurveLogs = 0;
  Eigen::VectorXd Sources; ///< Of R, before the singularities inside.
  Eigen::MatrixXd PeriodBasis;
  Eigen::MatrixXd PeriodInverse; ///< Of the Schur complement on the periods.
};
}
