#include "AlignedSources.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
AlignedSources PiecewiseConstantPhase(const PotentialProblem& problem)
{
  AlignedSources sources;
  sources.atRows = Eigen::VectorXd::Zero(problem.potential->Rows());
  const PlanarTopology& topology = problem.Topology();
  sources.midpointShift = Eigen::VectorXd::Zero(topology.turning.size());
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = topology.mesh.boundary[i];
    if (edge.IsAligned())
    {
      const double turning = topology.turning[static_cast<Eigen::Index>(i)];
      const auto& chosen = problem.alignment.chosenQuarters;
      const auto found = chosen.find(edge.vertices[0]);
      sources.atRows[edge.vertices[0]] = found == chosen.end()
        ? 4.0 * SmallestRotation(turning)
        : 4.0 * turning - 2.0 * Pi * found->second;
    }
  }
  return sources;
}

namespace
{
/// φ − 4τ along every boundary edge.
struct SpreadPhases
{
  Eigen::VectorXd start;
  Eigen::VectorXd middle;
  Eigen::VectorXd end;
};

/// Turns below this are rounding errors of coordinates in single precision: the vertex is in the
/// middle of a side of the polygon.
constexpr double SmallestTurn = 1e-5;
/// Fraction of a length at which a sum of edge lengths counts as complete, for rounding.
constexpr double CompleteFraction = 1.0 - 1e-9;
/// Maximum ratio of the length of a side to that of its neighbour on the same curve.
constexpr double LargestRatio = 2.0;

/// One loop of aligned boundary edges, traversed with the domain on the left.
class SpreadLoop
{
public:
  SpreadLoop(const PotentialProblem& problem, std::vector<int> edges)
    : Problem(problem)
    , Edges(std::move(edges))
  {
    const auto count = this->Edges.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const bool corner = this->IsCorner(i);
      if (corner || std::abs(this->Turning(i)) > SmallestTurn)
      {
        this->Turns.push_back({ i, corner });
      }
    }
  }

  /// Adds the phases that spread every turn of the loop over the sides next to it.
  void Spread(SpreadPhases& phases) const
  {
    const std::size_t turns = this->Turns.size();
    for (std::size_t t = 0; t < turns; ++t)
    {
      const auto [at, corner] = this->Turns[t];
      if (corner)
      {
        continue;
      }
      const std::size_t last = (t + turns - 1) % turns;
      const std::size_t next = (t + 1) % turns;
      const double before = this->SideLength(last);
      const double after = this->SideLength(t);
      const double back = 0.5 * std::min(before, LargestRatio * after);
      const double forth = 0.5 * std::min(after, LargestRatio * before);
      const double density = 4.0 * this->Turning(at) / (back + forth);
      // On a side of a curve that ends at a corner, the tangent equals the side's direction in its
      // middle and keeps turning up to the corner, whose jump is reduced by that turn.
      const double forthReach = this->Turns[next].corner && 2.0 * forth == after ? after : forth;
      const double backReach = this->Turns[last].corner && 2.0 * back == before ? before : back;
      double passed = 0.0;
      for (std::size_t i = at; passed < forthReach * CompleteFraction;
           i = (i + 1) % this->Edges.size())
      {
        const double length = this->Length(i);
        const auto shift = [&](double distance)
        { return density * (std::min(distance, forthReach) - forth); };
        phases.start[this->Edges[i]] += shift(passed);
        phases.middle[this->Edges[i]] += shift(passed + 0.5 * length);
        passed += length;
        phases.end[this->Edges[i]] += shift(passed);
      }
      passed = 0.0;
      for (std::size_t i = this->Before(at); passed < backReach * CompleteFraction;
           i = this->Before(i))
      {
        const double length = this->Length(i);
        const auto shift = [&](double distance)
        { return density * (back - std::min(distance, backReach)); };
        phases.end[this->Edges[i]] += shift(passed);
        phases.middle[this->Edges[i]] += shift(passed + 0.5 * length);
        passed += length;
        phases.start[this->Edges[i]] += shift(passed);
      }
    }
  }

  /// Moves the points of the curve away from the sides by integrating the tangent from turn to
  /// turn.
  void Bend(const SpreadPhases& phases, CurveSources& curve) const
  {
    for (std::size_t t = 0; t < this->Turns.size(); ++t)
    {
      // Integral of the tangent to the left of the side; subtracting a linear part makes the curve
      // meet the next turn.
      const double length = this->SideLength(t);
      double left = 0.0;
      this->AlongSide(t,
        [&](int edge, double half, double) {
          left +=
            0.125 * half * (phases.start[edge] + 2.0 * phases.middle[edge] + phases.end[edge]);
        });
      const double slope = left / length;
      left = 0.0;
      this->AlongSide(t,
        [&](int edge, double half, double passed)
        {
          const PlanarTopology& topology = this->Problem.Topology();
          const auto [from, to] = topology.BoundaryAt(edge).vertices;
          const Point along = (topology.PointAt(to) - topology.PointAt(from)) / (2.0 * half);
          const Point normal(-along.y(), along.x());
          const auto here = static_cast<std::size_t>(edge);
          curve.start[here] += (left - slope * passed) * normal;
          left += 0.125 * half * (phases.start[edge] + phases.middle[edge]);
          curve.middle[here] += (left - slope * (passed + half)) * normal;
          left += 0.125 * half * (phases.middle[edge] + phases.end[edge]);
        });
    }
  }

private:
  struct Turn
  {
    std::size_t at; ///< Position in Edges of the edge that starts there.
    bool corner;
  };

  const BoundaryEdge& Edge(std::size_t i) const
  {
    return this->Problem.Topology().BoundaryAt(this->Edges[i]);
  }
  std::size_t Before(std::size_t i) const
  {
    return (i + this->Edges.size() - 1) % this->Edges.size();
  }
  bool IsCorner(std::size_t i) const
  {
    const int vertex = this->Edge(i).vertices[0];
    return this->Problem.Topology().corners[vertex];
  }
  double Turning(std::size_t i) const { return this->Problem.Topology().turning[this->Edges[i]]; }
  double Length(std::size_t i) const
  {
    const auto& [from, to] = this->Edge(i).vertices;
    const PlanarTopology& topology = this->Problem.Topology();
    return (topology.PointAt(to) - topology.PointAt(from)).norm();
  }
  /// Calls f(entry of mesh.boundary, half its length, length passed before it) along the side from
  /// one turn to the next. Returns the side's length.
  template <typename F>
  double AlongSide(std::size_t turn, const F& f) const
  {
    const std::size_t end = this->Turns[(turn + 1) % this->Turns.size()].at;
    double passed = 0.0;
    std::size_t i = this->Turns[turn].at;
    do
    {
      const double length = this->Length(i);
      f(this->Edges[i], 0.5 * length, passed);
      passed += length;
      i = (i + 1) % this->Edges.size();
    } while (i != end);
    return passed;
  }
  double SideLength(std::size_t turn) const
  {
    return this->AlongSide(turn, [](int, double, double) {});
  }

  const PotentialProblem& Problem;
  std::vector<int> Edges;
  std::vector<Turn> Turns;
};

std::vector<SpreadLoop> AlignedLoops(const PotentialProblem& problem)
{
  std::vector<SpreadLoop> loops;
  for (const BoundaryLoop& loop : problem.Topology().loops)
  {
    std::vector<int> edges = loop.edges;
    if (loop.kind == BoundaryKind::Hole)
    {
      continue;
    }
    if (loop.kind == BoundaryKind::Inner)
    {
      std::reverse(edges.begin(), edges.end()); // along the directions of the edges
    }
    loops.emplace_back(problem, std::move(edges));
  }
  return loops;
}

SpreadPhases SpreadTurns(const PotentialProblem& problem, const std::vector<SpreadLoop>& loops)
{
  const auto count = static_cast<Eigen::Index>(problem.Topology().mesh.boundary.size());
  SpreadPhases phases{ Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count),
    Eigen::VectorXd::Zero(count) };
  for (const SpreadLoop& loop : loops)
  {
    loop.Spread(phases);
  }
  return phases;
}
}

CurveSources CurvePhase(const PotentialProblem& problem)
{
  CurveSources curve;
  curve.aligned = PiecewiseConstantPhase(problem);
  curve.jumps = curve.aligned.atRows;
  const std::vector<SpreadLoop> loops = AlignedLoops(problem);
  const SpreadPhases phases = SpreadTurns(problem, loops);
  const PlanarTopology& topology = problem.Topology();
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = topology.mesh.boundary[i];
    const int vertex = edge.vertices[0];
    if (edge.IsAligned())
    {
      const auto here = static_cast<Eigen::Index>(i);
      const int before = topology.previous[i];
      curve.aligned.atRows[vertex] += phases.middle[here] - phases.middle[before];
      curve.jumps[vertex] += phases.start[here] - phases.end[before];
    }
    curve.start.push_back(topology.PointAt(vertex));
    curve.middle.push_back(topology.Midpoint(topology.edges.ofBoundary[i]));
  }
  curve.growth.resize(2, phases.middle.size());
  curve.growth.row(0) = phases.middle - phases.start;
  curve.growth.row(1) = phases.end - phases.middle;
  for (const SpreadLoop& loop : loops)
  {
    loop.Bend(phases, curve);
  }
  curve.aligned.midpointShift = phases.middle;
  return curve;
}

EdgePhases LinearEdgePhases(const PotentialProblem& problem)
{
  const Eigen::VectorXd jump = PiecewiseConstantPhase(problem).atRows;
  const SpreadPhases phases = SpreadTurns(problem, AlignedLoops(problem));
  EdgePhases result{ phases.start, phases.end };
  const std::vector<int>& previous = problem.Topology().previous;
  for (std::size_t i = 0; i < previous.size(); ++i)
  {
    const BoundaryEdge& edge = problem.Topology().mesh.boundary[i];
    if (edge.IsAligned())
    {
      // The part of the jump that was not spread, at corners.
      const auto here = static_cast<Eigen::Index>(i);
      const double left = jump[edge.vertices[0]] + phases.start[here] - phases.end[previous[i]];
      result.start[here] -= 0.5 * left;
      result.end[previous[i]] += 0.5 * left;
    }
  }
  return result;
}

AlignedSources LinearPhase(const PotentialProblem& problem)
{
  const EdgePhases phases = LinearEdgePhases(problem);
  AlignedSources sources;
  sources.atRows = Eigen::VectorXd::Zero(problem.potential->Rows());
  sources.midpointShift = 0.5 * (phases.start + phases.end);
  for (std::size_t i = 0; i < problem.Topology().mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = problem.Topology().mesh.boundary[i];
    if (edge.IsAligned())
    {
      const auto here = static_cast<Eigen::Index>(i);
      const double flux = phases.end[here] - phases.start[here];
      sources.atRows[edge.vertices[0]] += 0.5 * flux;
      sources.atRows[edge.vertices[1]] += 0.5 * flux;
    }
  }
  return sources;
}
}
