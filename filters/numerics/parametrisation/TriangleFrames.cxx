#include "TriangleFrames.h"

#include "Error.h"
#include "Parts.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

  /// Returns the increase from the centre of a triangle to the midpoint of an edge. Singularities
  /// of curves see the point of the curve instead of the midpoint of a boundary edge.
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

  /// Returns whether a logarithm belongs to a singularity of a curve, which need not be at a
  /// vertex.
  bool IsOnCurve(std::size_t log) const
  {
    return log >= this->FirstOnCurve && log < this->FirstAtCorner;
  }

private:
  const MeshTopology& Topology;
  const std::vector<LogSource>& Logs;
  const std::size_t FirstOnCurve;
  const std::size_t FirstAtCorner;
  std::vector<Point> SeenFromCurves; ///< Per edge its midpoint, or the point of the curve for it.
  const Eigen::MatrixXd Gradient;
};

/// Returns 4H at the centres: R is linear on a triangle, the logarithms are exact.
Eigen::VectorXd CentreValues(
  const PointPotential& potential, const PointPotential::Solution& solution, const PhaseWalk& walk)
{
  const PotentialSolver& solver = *potential.GetProblem().potential;
  const TriangleMesh& mesh = solver.GetTopology().mesh;
  Eigen::VectorXd values(static_cast<Eigen::Index>(mesh.triangles.size()));
  ForRanges(values.size(),
    [&](int begin, int end)
    {
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

/// Finds the triangles within a few edge lengths of a logarithm. Farther away, the second-order
/// error of a constant value per triangle is small.
std::vector<TriangleFrames::NearLog> FindNear(
  const MeshTopology& topology, const std::vector<LogSource>& logs, const PhaseWalk& walk)
{
  constexpr double Edges = 6.0;
  // Halfway between two logarithms neither is used, which preserves symmetry.
  constexpr double EquallyNear = 1e-9;
  std::vector<TriangleFrames::NearLog> near;
  for (int t = 0; t < static_cast<int>(topology.mesh.triangles.size()); ++t)
  {
    const auto& v = topology.mesh.triangles[static_cast<std::size_t>(t)];
    const Point centre = walk.Centre(t);
    // The squared edge length of an equilateral triangle is 4 / √3 times its area.
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

/// Finds a branch of the phase for every triangle and the jumps between them.
class BranchSearch
{
public:
  BranchSearch(const PointPotential& potential, const PhaseWalk& walk)
    : Topology(potential.GetProblem().Topology())
    , MidpointShift(potential.GetMidpointShift())
    , Walk(walk)
    , ToSide(this->Topology.mesh.triangles.size())
    , Phase(static_cast<Eigen::Index>(this->Topology.mesh.triangles.size()))
  {
    ForRanges(static_cast<std::ptrdiff_t>(this->ToSide.size()),
      [&](int begin, int end)
      {
        for (int t = begin; t < end; ++t)
        {
          for (std::size_t i = 0; i < 3; ++i)
          {
            this->ToSide[static_cast<std::size_t>(t)][i] =
              walk.ToEdge(t, this->Topology.edges.ofTriangle[static_cast<std::size_t>(t)][i]);
          }
        }
      });
  }

  /// Continues the phase breadth-first from the outer loop, and returns it at every centre.
  const Eigen::VectorXd& Continue()
  {
    std::vector<bool> known(this->ToSide.size(), false);
    const int first = this->Topology.FirstOuterEdge();
    const int firstEdge = this->Topology.EdgeOfBoundary(first);
    const int start = this->Topology.edges.triangles[static_cast<std::size_t>(firstEdge)][0];
    this->Phase[start] = this->BoundaryPhase(first) - this->Walk.ToEdge(start, firstEdge);
    known[static_cast<std::size_t>(start)] = true;
    std::vector<int> queue = { start };
    for (std::size_t next = 0; next < queue.size(); ++next)
    {
      const int t = queue[next];
      for (std::size_t i = 0; i < 3; ++i)
      {
        const int other = this->Neighbour(t, i);
        if (other >= 0 && !known[static_cast<std::size_t>(other)])
        {
          known[static_cast<std::size_t>(other)] = true;
          this->Phase[other] = this->Continued(t, i, other);
          queue.push_back(other);
        }
      }
    }
    return this->Phase;
  }

  /// Sets the jumps and the residual of the frames.
  void SetJumps(TriangleFrames& frames) const
  {
    frames.jump.assign(this->ToSide.size(), { 0, 0, 0 });
    for (int t = 0; t < static_cast<int>(this->ToSide.size()); ++t)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const int other = this->Neighbour(t, i);
        if (other >= 0)
        {
          const auto [turns, residual] =
            RoundToTurns(this->Continued(t, i, other) - this->Phase[other]);
          frames.jump[static_cast<std::size_t>(t)][i] = turns;
          frames.residual = std::max(frames.residual, residual);
        }
      }
    }
    for (int position = 0; position < static_cast<int>(this->Topology.mesh.boundary.size());
         ++position)
    {
      const int edge = this->Topology.EdgeOfBoundary(position);
      const int t = this->Topology.edges.triangles[static_cast<std::size_t>(edge)][0];
      const std::size_t i = this->SideOf(t, edge);
      // On an inner loop with a holonomy defect, a quarter of the defect remains.
      frames.jump[static_cast<std::size_t>(t)][i] = RoundToTurns(this->BoundaryPhase(position) -
        this->Phase[t] - this->ToSide[static_cast<std::size_t>(t)][i])
                                                      .first;
    }
  }

private:
  /// Returns the integer nearest to a phase in turns, and the deviation from it in radians of θ.
  static std::pair<int, double> RoundToTurns(double phase)
  {
    const double turn = 2.0 * Pi;
    const double whole = std::round(phase / turn);
    return std::make_pair(static_cast<int>(whole), 0.25 * std::abs(phase - whole * turn));
  }

  /// Returns the phase of the cross along a boundary edge, at its midpoint.
  double BoundaryPhase(int position) const
  {
    const auto& [from, to] = this->Topology.BoundaryAt(position).vertices;
    const Point along = this->Topology.PointAt(to) - this->Topology.PointAt(from);
    return 4.0 * std::atan2(along.y(), along.x()) + this->MidpointShift[position];
  }

  /// Returns the triangle across a side; −1 at the boundary.
  int Neighbour(int triangle, std::size_t side) const
  {
    const int edge = this->Topology.edges.ofTriangle[static_cast<std::size_t>(triangle)][side];
    const auto& two = this->Topology.edges.triangles[static_cast<std::size_t>(edge)];
    return two[0] == triangle ? two[1] : two[0];
  }

  std::size_t SideOf(int triangle, int edge) const
  {
    const auto& sides = this->Topology.edges.ofTriangle[static_cast<std::size_t>(triangle)];
    return static_cast<std::size_t>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
  }

  /// Returns the phase of a triangle, continued to the centre of its neighbour across a side.
  double Continued(int triangle, std::size_t side, int neighbour) const
  {
    const int edge = this->Topology.edges.ofTriangle[static_cast<std::size_t>(triangle)][side];
    return this->Phase[triangle] + this->ToSide[static_cast<std::size_t>(triangle)][side] -
      this->ToSide[static_cast<std::size_t>(neighbour)][this->SideOf(neighbour, edge)];
  }

  const MeshTopology& Topology;
  const Eigen::VectorXd& MidpointShift;
  const PhaseWalk& Walk;
  std::vector<std::array<double, 3>> ToSide; ///< Increase from the centre to each side's midpoint.
  Eigen::VectorXd Phase;                     ///< At the centres.
};
}

TriangleFrames FrameTriangles(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const PhaseWalk walk(potential, solution);
  TriangleFrames frames;
  frames.h = 0.25 * CentreValues(potential, solution, walk);
  BranchSearch branches(potential, walk);
  frames.angle = 0.25 * branches.Continue();
  branches.SetJumps(frames);
  // Far above the rounding of as many steps as there are triangles across the domain.
  constexpr double LargestResidual = 1e-6;
  if (!(frames.residual <= LargestResidual))
  {
    throw Error("The cross field does not close around the domain, by " +
      std::to_string(frames.residual) +
      " radians; the mesh may have degenerate triangles, remesh the domain.");
  }
  frames.near = FindNear(potential.GetProblem().Topology(), solution.logs, walk);
  return frames;
}
}
