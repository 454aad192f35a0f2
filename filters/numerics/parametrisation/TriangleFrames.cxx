#include "TriangleFrames.h"

#include "BothHalves.h"
#include "Error.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// The phase 4θ along straight steps inside of triangles: its increase is that of the conjugate of R
/// and the angles at which the logarithms' places see the step.
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
      this->SeenFromCurves[static_cast<std::size_t>(e)] = this->Topology.Midpoint(e);
    }
    for (std::size_t i = 0; i < this->Topology.edges.ofBoundary.size(); ++i)
    {
      this->SeenFromCurves[static_cast<std::size_t>(this->Topology.edges.ofBoundary[i])] =
        potential.GetCurveMiddles()[i];
    }
  }

  Point Centre(int triangle) const
  {
    const auto& v = this->Topology.mesh.triangles[static_cast<std::size_t>(triangle)];
    return (this->Topology.PointAt(v[0]) + this->Topology.PointAt(v[1]) +
             this->Topology.PointAt(v[2])) /
      3.0;
  }

  /// From the centre of a triangle to the midpoint of an edge. Singularities of curves see the boundary
  /// on the curve.
  double ToEdge(int triangle, int edge) const
  {
    const Point from = this->Centre(triangle);
    const Point to = this->Topology.Midpoint(edge);
    const Point& seen = this->SeenFromCurves[static_cast<std::size_t>(edge)];
    const LogSource* const logs = this->Logs.data();
    const LogSource* const onCurve = logs + this->FirstOnCurve;
    const LogSource* const atCorner = logs + this->FirstAtCorner;
    return Cross(this->Gradient.block<2, 1>(0, triangle), to - from) +
      SumOfTurns(logs, onCurve, from, to) + SumOfTurns(onCurve, atCorner, from, seen) +
      SumOfTurns(atCorner, logs + this->Logs.size(), from, to);
  }

  /// Whether a logarithm is that of a singularity of a curve: it need not be at a vertex.
  bool IsOnCurve(std::size_t log) const
  {
    return log >= this->FirstOnCurve && log < this->FirstAtCorner;
  }

private:
  const MeshTopology& Topology;
  const std::vector<LogSource>& Logs;
  const std::size_t FirstOnCurve;
  const std::size_t FirstAtCorner;
  std::vector<Point> SeenFromCurves; ///< The midpoint of every edge.
  const Eigen::MatrixXd Gradient;
};

/// 4H at the centres: R is linear on a triangle, the logarithms are exact.
Eigen::VectorXd CentreValues(
  const PointPotential& potential, const PointPotential::Solution& solution, const PhaseWalk& walk)
{
  const PotentialSolver& solver = *potential.GetProblem().potential;
  const TriangleMesh& mesh = solver.GetTopology().mesh;
  Eigen::VectorXd values(static_cast<Eigen::Index>(mesh.triangles.size()));
  ForBothHalves(true,
    [&](std::size_t half)
    {
      const auto [begin, end] = HalfOf(static_cast<int>(values.size()), half);
      for (int t = begin; t < end; ++t)
      {
        const auto& v = mesh.triangles[static_cast<std::size_t>(t)];
        values[t] =
          (solution.regular[v[0]] + solution.regular[v[1]] + solution.regular[v[2]]) / 3.0 +
          SumOfLogs(solution.logs, walk.Centre(t));
      }
    });
  return values;
}

/// Triangles within a few edges of a logarithm: beyond, the second-order error of taking one value for
/// a triangle is small.
std::vector<TriangleFrames::NearLog> FindNear(
  const MeshTopology& topology, const std::vector<LogSource>& logs, const PhaseWalk& walk)
{
  constexpr double Edges = 6.0;
  // Halfway between two neither is taken, so that what is symmetric stays so.
  constexpr double EquallyNear = 1e-9;
  std::vector<TriangleFrames::NearLog> near;
  for (int t = 0; t < static_cast<int>(topology.mesh.triangles.size()); ++t)
  {
    const auto& v = topology.mesh.triangles[static_cast<std::size_t>(t)];
    const Point centre = walk.Centre(t);
    // Of an equilateral triangle the square of an edge is 4 / √3 times the area.
    const double area = TriangleArea(topology.mesh, v);
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
      near.push_back({ t, *found });
    }
  }
  return near;
}
}

TriangleFrames FrameTriangles(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const PotentialProblem& problem = potential.GetProblem();
  const MeshTopology& topology = problem.Topology();
  const PhaseWalk walk(potential, solution);
  const auto count = static_cast<Eigen::Index>(topology.mesh.triangles.size());
  const double turn = 2.0 * Pi;

  TriangleFrames frames;
  frames.h = 0.25 * CentreValues(potential, solution, walk);
  frames.jump.assign(static_cast<std::size_t>(count), { 0, 0, 0 });
  const auto wholeTurns = [turn](double phase)
  {
    const double whole = std::round(phase / turn);
    return std::make_pair(static_cast<int>(whole), 0.25 * std::abs(phase - whole * turn));
  };

  // The phase of the cross along a boundary edge, at its midpoint.
  const auto boundaryPhase = [&](int position)
  {
    const auto& [from, to] = topology.BoundaryAt(position).vertices;
    const Point along = topology.PointAt(to) - topology.PointAt(from);
    return 4.0 * std::atan2(along.y(), along.x()) + potential.GetMidpointShift()[position];
  };

  // 1. Breadth-first from the outer loop: a branch everywhere.
  Eigen::VectorXd phase(count);
  std::vector<bool> known(static_cast<std::size_t>(count), false);
  const int first = topology.FirstOuterEdge();
  const int firstEdge = topology.EdgeOfBoundary(first);
  const int start = topology.edges.triangles[static_cast<std::size_t>(firstEdge)][0];
  phase[start] = boundaryPhase(first) - walk.ToEdge(start, firstEdge);
  known[static_cast<std::size_t>(start)] = true;
  std::vector<int> queue = { start };
  const auto neighbour = [&topology](int triangle, int edge)
  {
    const auto& two = topology.edges.triangles[static_cast<std::size_t>(edge)];
    return two[0] == triangle ? two[1] : two[0];
  };
  // The increase from the centre to the midpoint of each side.
  std::vector<std::array<double, 3>> toSide(static_cast<std::size_t>(count));
  ForBothHalves(true,
    [&](std::size_t half)
    {
      const auto [begin, end] = HalfOf(static_cast<int>(count), half);
      for (int t = begin; t < end; ++t)
      {
        for (std::size_t i = 0; i < 3; ++i)
        {
          toSide[static_cast<std::size_t>(t)][i] =
            walk.ToEdge(t, topology.edges.ofTriangle[static_cast<std::size_t>(t)][i]);
        }
      }
    });
  const auto sideOf = [&topology](int triangle, int edge)
  {
    const auto& sides = topology.edges.ofTriangle[static_cast<std::size_t>(triangle)];
    return static_cast<std::size_t>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
  };
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const int t = queue[next];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int edge = topology.edges.ofTriangle[static_cast<std::size_t>(t)][i];
      const int other = neighbour(t, edge);
      if (other >= 0 && !known[static_cast<std::size_t>(other)])
      {
        known[static_cast<std::size_t>(other)] = true;
        phase[other] = phase[t] + toSide[static_cast<std::size_t>(t)][i] -
          toSide[static_cast<std::size_t>(other)][sideOf(other, edge)];
        queue.push_back(other);
      }
    }
  }

  // 2. What the branches differ by.
  for (int t = 0; t < static_cast<int>(count); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int edge = topology.edges.ofTriangle[static_cast<std::size_t>(t)][i];
      const int other = neighbour(t, edge);
      if (other >= 0)
      {
        const double carried = phase[t] + toSide[static_cast<std::size_t>(t)][i] -
          toSide[static_cast<std::size_t>(other)][sideOf(other, edge)];
        const auto [turns, residual] = wholeTurns(carried - phase[other]);
        frames.jump[static_cast<std::size_t>(t)][i] = turns;
        frames.residual = std::max(frames.residual, residual);
      }
    }
  }
  for (int position = 0; position < static_cast<int>(topology.mesh.boundary.size()); ++position)
  {
    const int edge = topology.EdgeOfBoundary(position);
    const int t = topology.edges.triangles[static_cast<std::size_t>(edge)][0];
    const std::size_t i = sideOf(t, edge);
    // On an inner loop with a holonomy defect, a quarter of that is left.
    frames.jump[static_cast<std::size_t>(t)][i] =
      wholeTurns(boundaryPhase(position) - phase[t] - toSide[static_cast<std::size_t>(t)][i]).first;
  }
  // Rounding of as many steps as there are triangles across the domain, by far.
  constexpr double LargestResidual = 1e-6;
  if (!(frames.residual <= LargestResidual))
  {
    throw Error("The cross field does not close around the domain, by " +
      std::to_string(frames.residual) +
      " radians; the mesh may have degenerate triangles, remesh the domain.");
  }
  frames.angle = 0.25 * phase;
  frames.near = FindNear(topology, solution.logs, walk);
  return frames;
}
}
