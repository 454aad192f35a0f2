#pragma once

#include "AlignedSources.h"
#include "LogSource.h"
#include "Singularity.h"

#include <functional>

namespace crossfield
{
/// Half of a boundary edge, with the domain on its left: the part of the edge that belongs to one
/// of its vertices.
struct BoundaryHalf
{
  int vertex = 0;
  Point from = Point::Zero();
  Point to = Point::Zero();
  double growth = 0.0;  ///< Growth of the phase along it, without jumps that have a logarithm.
  double logFlux = 0.0; ///< Flux of the logarithms on the boundary through it.
  double logMean = 0.0; ///< Mean of the sum of the logarithms on the boundary.
};

/// The potential of singularities that are points, on a mesh without holes (docs/method.md §5.3,
/// §11.3):
///   Φ = R + Σ_j d_j log|x − b_j| + Σ_c s_c / (−α_c) log|x − p_c|,
/// b_j the singularities, p_c the corners of angle α_c at which the phase has to turn by s_c ≠ 0,
/// and the singularities of curves: there α_c = π, s_c = −2πk, and p_c is the point of the curve,
/// from which the curve is seen instead of the polygon. The regular part R is a P1 function with
/// periods. Its sources at a boundary vertex v are those of alignment minus, times the strengths,
/// the angles at which all b_j, p_c see the two halves of edges at v: there are no deltas on the
/// mesh, and the phase of R plus the exact arguments is that of CurvePhase on every boundary edge.
/// The mesh is factored once; a further configuration costs one solve with that factor.
class PointPotential
{
public:
  /// The potential of one configuration.
  struct Solution
  {
    std::vector<LogSource> logs;        ///< The singularities in their order, then the boundary's.
    Eigen::VectorXd sources;            ///< Sources of R; rows of PotentialOperator.
    Eigen::VectorXd regular;            ///< R, single-valued.
    Eigen::VectorXd aligned;            ///< R with the periods that align inner loops.
    std::vector<double> holonomyDefect; ///< See AlignedPotential.
    Eigen::VectorXd offsets;            ///< The same with the chosen whole turns added.
    Eigen::VectorXd periods; ///< Periods of R around inner loops; zero where the offsets are.
  };

  /// Prepares the solution of configurations, all of which must have the sum of quarter indices in
  /// `alignment`. Throws Error when that sum violates Poincaré-Hopf, or when the mesh has holes.
  PointPotential(std::shared_ptr<const PotentialSolver> solver, Alignment alignment);

  /// Solves for a configuration. Throws Error when a singularity is not inside the domain, when it
  /// is nearer than 1e-6 of the diagonal to the boundary or to another singularity, or when the
  /// quarter indices have another sum than that of the alignment.
  Solution Solve(const Configuration& configuration) const;

  /// Throws the errors of Solve.
  void RequireSolvable(const Configuration& configuration) const;

  /// A logarithm at a vertex of the boundary.
  struct BoundaryLog
  {
    LogSource log;
    int vertex;
    bool onCurve; ///< Whether it is centred at the point of the curve, and sees the curve.
  };
  /// Returns the logarithm that one quarter of index adds at the vertex where an entry of
  /// mesh.boundary starts.
  BoundaryLog QuarterAt(std::size_t entry) const;
  /// Flux of a logarithm through every half of a boundary edge, and its mean there.
  struct LogFlow
  {
    Eigen::VectorXd flux;
    Eigen::VectorXd mean;
  };
  LogFlow FlowOf(const BoundaryLog& source) const;

  /// Returns the potential with other quarter indices at the boundary, on the same mesh: only the
  /// logarithms at vertices whose quarter index differs are added and subtracted, so that the result
  /// equals that of the constructor up to rounding. Throws Error as the constructor does.
  PointPotential WithAlignment(Alignment alignment) const;

  const PlanarDomain& GetDomain() const { return this->Domain; }
  const PotentialProblem& GetProblem() const { return this->Problem; }
  const std::vector<BoundaryHalf>& GetHalves() const { return this->Halves; }
  /// Logarithms at the boundary: first the singularities of curves, whose strengths are integers,
  /// then corners.
  const std::vector<LogSource>& GetBoundaryLogs() const { return this->BoundaryLogs; }
  std::size_t CurveLogCount() const { return this->CurveLogs; }
  /// The mesh vertex of every logarithm at the boundary.
  const std::vector<int>& GetBoundaryLogVertices() const { return this->LogVertices; }
  /// The points of the curve for the midpoints of the entries of mesh.boundary.
  const std::vector<Point>& GetCurveMiddles() const { return this->Curve.middle; }
  /// φ at the midpoints of boundary edges minus 4τ; see CurvePhase.
  const Eigen::VectorXd& GetMidpointShift() const { return this->Curve.aligned.midpointShift; }
  /// The solution for a unit source at its period, a column per inner loop.
  const Eigen::MatrixXd& GetPeriodBasis() const
  {
    return this->Problem.potential->GetPeriodResponse().basis;
  }
  /// Sources of R without the singularities inside; rows of PotentialOperator.
  const Eigen::VectorXd& GetSources() const { return this->Sources; }
  const CurveSources& GetCurve() const { return this->Curve; }
  /// The entry of mesh.boundary that follows each one.
  const std::vector<std::size_t>& GetNext() const { return this->Next; }
  /// Returns the midpoints of the first and the last boundary edge of strip k.
  std::array<Point, 2> StripEnds(Eigen::Index k) const;
  /// Returns the path along strip k from its first to its last boundary edge, through the centres
  /// of its triangles. It starts and ends on the polygon or on the curve.
  std::vector<Point> StripPath(Eigen::Index k, bool onCurve) const;
  /// Returns the angle at which the position of a logarithm sees the path along strip k from its
  /// end to its start.
  double StripTurn(const LogSource& log, Eigen::Index k, bool onCurve) const;

  /// Computes R and the holonomy defects of a solution that has its logarithms and sources.
  /// `subtractTurns(k, phase)` subtracts from a phase what the logarithms turn along strip k from
  /// its end to its start.
  void Complete(
    Solution& result, const std::function<double(Eigen::Index, double)>& subtractTurns) const;

private:
  /// Finds the logarithms at the boundary.
  void FindBoundaryLogs();
  /// Returns a logarithm at the boundary.
  BoundaryLog BoundaryLogAt(std::size_t boundaryLog) const;
  /// Adds logarithms at the boundary to fluxes, means and sources, one after the other.
  void AddFlows(const std::vector<BoundaryLog>& sources);
  /// Returns the ends of a half, on the polygon or on the curve.
  std::array<Point, 2> Ends(std::size_t half, bool onCurve) const;
  /// Returns the angles at which the position of a logarithm at the boundary sees all halves: a
  /// corner sees those of the polygon, a point of a curve those of the curve. They add up to its
  /// angle.
  std::vector<double> Turns(const BoundaryLog& source) const;

  PotentialProblem Problem;
  PlanarDomain Domain; ///< Polygons of the mesh.
  CurveSources Curve;
  std::vector<std::size_t> Next;    ///< Per entry of mesh.boundary the entry that follows it.
  std::vector<BoundaryHalf> Halves; ///< Two for every entry of mesh.boundary.
  std::vector<LogSource> BoundaryLogs;
  std::vector<int> LogVertices;
  std::size_t CurveLogs = 0;
  Eigen::VectorXd Sources; ///< Sources of R without the singularities inside.
};
}
