#include "PhaseSteps.h"

#include "Parts.h"

#include <cmath>

namespace crossfield
{
namespace
{
/// The increase of the phase 4θ along straight steps within triangles: that of the conjugate of R
/// plus the angles at which the positions of the logarithms see the step.
class PhaseWalk
{
public:
  PhaseWalk(const PointPotential& potential, const PointPotential::Solution& solution)
    : Topology(potential.GetProblem().Topology())
    , Logs(solution.logs)
    , FirstOnCurve(solution.logs.size() - potential.GetBoundaryLogs().size())
    , FirstAtCorner(this->FirstOnCurve + potential.CurveLogCount())
    , SeenFromCurves(static_cast<std::size_t>(this->Topology.edges.Count()))
    , Gradient(potential.GetProblem().potential->Gradient(solution.regular))
  {
    for (int e = 0; e < this->Topology.edges.Count(); ++e)
    {
      this->SeenFromCurves[e] = this->Topology.Midpoint(e);
    }
    for (std::size_t i = 0; i < this->Topology.edges.ofBoundary.size(); ++i)
    {
      this->SeenFromCurves[this->Topology.edges.ofBoundary[i]] = potential.GetCurveMiddles()[i];
    }
  }

  /// Returns the increase from the centre of a triangle to the midpoint of an edge. Singularities
  /// of curves see the point of the curve instead of the midpoint of a boundary edge.
  double ToEdge(int triangle, int edge) const
  {
    const Point from = this->Topology.CentreOf(triangle);
    const Point to = this->Topology.Midpoint(edge);
    const Point& seen = this->SeenFromCurves[edge];
    const LogSource* const logs = this->Logs.data();
    const LogSource* const onCurve = logs + this->FirstOnCurve;
    const LogSource* const atCorner = logs + this->FirstAtCorner;
    return Cross(this->Gradient.block<2, 1>(0, triangle), to - from) +
      SumOfTurns(logs, onCurve, from, to) + SumOfTurns(onCurve, atCorner, from, seen) +
      SumOfTurns(atCorner, logs + this->Logs.size(), from, to);
  }

  /// Returns whether a logarithm belongs to a singularity of a curve, which need not be at a
  /// vertex.
  bool IsOnCurve(std::size_t log) const
  {
    return log >= this->FirstOnCurve && log < this->FirstAtCorner;
  }

private:
  const PlanarTopology& Topology;
  const std::vector<LogSource>& Logs;
  const std::size_t FirstOnCurve;
  const std::size_t FirstAtCorner;
  std::vector<Point> SeenFromCurves; ///< Per edge its midpoint, or the point of the curve for it.
  const Eigen::MatrixXd Gradient;
};

/// Returns 4H at the centres: R is linear on a triangle, the logarithms are exact.
Eigen::VectorXd CentreValues(
  const PlanarTopology& topology, const PointPotential::Solution& solution)
{
  Eigen::VectorXd values(topology.TriangleCount());
  ForRanges(values.size(),
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const auto& v = topology.mesh.triangles[t];
        values[t] =
          (solution.regular[v[0]] + solution.regular[v[1]] + solution.regular[v[2]]) / 3.0 +
          SumOfLogs(solution.logs, topology.CentreOf(t));
      }
    });
  return values;
}

/// Finds the triangles within a few edge lengths of a logarithm. Farther away, the second-order
/// error of a constant value per triangle is small.
std::vector<NearCone> FindNear(
  const PlanarTopology& topology, const std::vector<LogSource>& logs, const PhaseWalk& walk)
{
  constexpr double Edges = 6.0;
  // Halfway between two logarithms neither is used, which preserves symmetry.
  constexpr double EquallyNear = 1e-9;
  std::vector<NearCone> near;
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const Point centre = topology.CentreOf(t);
    // The squared edge length of an equilateral triangle is 4 / √3 times its area.
    const double area = topology.AreaOf(t);
    double nearest = Edges * Edges * 4.0 / std::sqrt(3.0) * area;
    const LogSource* found = nullptr;
    for (std::size_t m = 0; m < logs.size(); ++m)
    {
      if (walk.IsOnCurve(m))
      {
        continue;
      }
      const LogSource& log = logs[m];
      const double distance = (centre - log.position).squaredNorm();
      if (found != nullptr && std::abs(distance - nearest) <= EquallyNear * nearest)
      {
        found = nullptr;
      }
      else if (distance < nearest)
      {
        nearest = distance;
        found = &log;
      }
    }
    if (found != nullptr)
    {
      near.push_back({ t, found->position, 1.0 - 0.25 * found->strength });
    }
  }
  return near;
}
}

PhaseSteps StepsOf(const PointPotential& potential, const PointPotential::Solution& solution)
{
  const PlanarTopology& topology = potential.GetProblem().Topology();
  const PhaseWalk walk(potential, solution);
  PhaseSteps steps;
  steps.centre = CentreValues(topology, solution);
  steps.toSide.resize(topology.mesh.triangles.size());
  ForRanges(topology.TriangleCount(),
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        for (int side = 0; side < 3; ++side)
        {
          steps.toSide[t][side] = walk.ToEdge(t, topology.EdgeOf(t, side));
        }
      }
    });
  steps.boundaryShift = potential.GetMidpointShift();
  steps.near = FindNear(topology, solution.logs, walk);
  return steps;
}

PhaseSteps StepsOf(const VertexPotential& potential, const VertexPotential::Solution& solution)
{
  const MeshTopology& topology = potential.GetTopology();
  const Eigen::MatrixXd gradient = potential.GetOperator().Gradient(solution.potential);
  const Eigen::MatrixXd shift = potential.GetOperator().Gradient(solution.phaseShift);
  PhaseSteps steps;
  steps.centre.resize(topology.TriangleCount());
  steps.toSide.resize(topology.mesh.triangles.size());
  ForRanges(topology.TriangleCount(),
    [&](int begin, int end)
    {
      for (int t = begin; t < end; ++t)
      {
        const auto& v = topology.mesh.triangles[t];
        steps.centre[t] =
          (solution.potential[v[0]] + solution.potential[v[1]] + solution.potential[v[2]]) / 3.0;
        const Point centre = topology.CentreOf(t);
        for (int side = 0; side < 3; ++side)
        {
          const Point step = topology.MiddleOf(t, side) - centre;
          steps.toSide[t][side] = Cross(gradient.col(t), step) + shift.col(t).dot(step);
        }
      }
    });
  steps.boundaryShift =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(topology.mesh.boundary.size()));
  return steps;
}
}
