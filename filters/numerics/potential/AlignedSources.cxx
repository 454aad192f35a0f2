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
  const MeshTopology& topology = problem.Topology();
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

/// A turn below this is one of coordinates that went through single precision, in the middle of a
/// side of the polygon.
constexpr double SmallestTurn = 1e-5;
/// Sums of lengths are the length of the whole up to rounding.
constexpr double WalkedAll = 1.0 - 1e-9;
/// How much longer than its neighbour a side of one curve may be.
constexpr double LargestRatio = 2.0;

/// One loop of aligned boundary edges, walked with the domain on the left.
class SpreadLoop
{
public:
  SpreadLoop(const PotentialProblem& problem, const Eigen::VectorXd& jump, std::vector<int> edges)
    : Problem(problem)
    , Jump(jump)
    , Edges(std::move(edges))
  {
    const auto count = this->Edges.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const int vertex = this->Start(i);
      const bool corner = this->IsFixed(i);
      if (corner || std::abs(jump[vertex]) > 4.0 * SmallestTurn)
      {
        this->Turns.push_back({ i, corner });
      }
    }
  }

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
      const double density = this->Jump[this->Start(at)] / (back + forth);
      // The side of a curve that ends at a corner: the tangent is that of the side in its middle and
      // goes on turning up to the corner, whose jump is less by that.
      const double forthReach = this->Turns[next].corner && 2.0 * forth == after ? after : forth;
      const double backReach = this->Turns[last].corner && 2.0 * back == before ? before : back;
      double way = 0.0;
      for (std::size_t i = at; way < forthReach * WalkedAll; i = (i + 1) % this->Edges.size())
      {
        const double length = this->Length(i);
        const auto shift = [&](double distance)
        { return density * (std::min(distance, forthReach) - forth); };
        phases.start[this->Edges[i]] += shift(way);
        phases.middle[this->Edges[i]] += shift(way + 0.5 * length);
        way += length;
        phases.end[this->Edges[i]] += shift(way);
      }
      way = 0.0;
      for (std::size_t i = this->Before(at); way < backReach * WalkedAll; i = this->Before(i))
      {
        const double length = this->Length(i);
        const auto shift = [&](double distance)
        { return density * (back - std::min(distance, backReach)); };
        phases.end[this->Edges[i]] += shift(way);
        phases.middle[this->Edges[i]] += shift(way + 0.5 * length);
        way += length;
        phases.start[this->Edges[i]] += shift(way);
      }
    }
  }

private:
  struct Turn
  {
    std::size_t at; ///< The edge that starts there.
    bool corner;
  };

  const BoundaryEdge& Edge(std::size_t i) const
  {
    return this->Problem.Topology().BoundaryAt(this->Edges[i]);
  }
  int Start(std::size_t i) const { return this->Edge(i).vertices[0]; }
  std::size_t Before(std::size_t i) const
  {
    return (i + this->Edges.size() - 1) % this->Edges.size();
  }
  bool IsFixed(std::size_t i) const
  {
    return this->Problem.alignment.chosenQuarters.count(this->Start(i)) != 0 ||
      this->Problem.Topology().corners[static_cast<std::size_t>(this->Start(i))];
  }
  double Length(std::size_t i) const
  {
    const auto& [from, to] = this->Edge(i).vertices;
    const MeshTopology& topology = this->Problem.Topology();
    return (topology.PointAt(to) - topology.PointAt(from)).norm();
  }
  /// Of the side from one turn to the next.
  double SideLength(std::size_t turn) const
  {
    const std::size_t end = this->Turns[(turn + 1) % this->Turns.size()].at;
    double length = 0.0;
    std::size_t i = this->Turns[turn].at;
    do
    {
      length += this->Length(i);
      i = (i + 1) % this->Edges.size();
    } while (i != end);
    return length;
  }

  const PotentialProblem& Problem;
  const Eigen::VectorXd& Jump;
  std::vector<int> Edges;
  std::vector<Turn> Turns;
};

SpreadPhases SpreadJumps(const PotentialProblem& problem, const Eigen::VectorXd& jump)
{
  const auto count = static_cast<Eigen::Index>(problem.Topology().mesh.boundary.size());
  SpreadPhases phases{ Eigen::VectorXd::Zero(count), Eigen::VectorXd::Zero(count),
    Eigen::VectorXd::Zero(count) };
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
    SpreadLoop(problem, jump, edges).Spread(phases);
  }
  return phases;
}
}

AlignedSources CurvePhase(const PotentialProblem& problem)
{
  AlignedSources sources = PiecewiseConstantPhase(problem);
  const SpreadPhases phases = SpreadJumps(problem, sources.atRows);
  const std::vector<int>& previous = problem.Topology().previous;
  for (std::size_t i = 0; i < previous.size(); ++i)
  {
    const BoundaryEdge& edge = problem.Topology().mesh.boundary[i];
    if (edge.IsAligned())
    {
      sources.atRows[edge.vertices[0]] +=
        phases.middle[static_cast<Eigen::Index>(i)] - phases.middle[previous[i]];
    }
  }
  sources.midpointShift = phases.middle;
  return sources;
}

EdgePhases LinearEdgePhases(const PotentialProblem& problem)
{
  const Eigen::VectorXd jump = PiecewiseConstantPhase(problem).atRows;
  const SpreadPhases phases = SpreadJumps(problem, jump);
  EdgePhases result{ phases.start, phases.end };
  const std::vector<int>& previous = problem.Topology().previous;
  for (std::size_t i = 0; i < previous.size(); ++i)
  {
    const BoundaryEdge& edge = problem.Topology().mesh.boundary[i];
    if (edge.IsAligned())
    {
      // What was not spread: corners.
      const auto here = static_cast<Eigen::Index>(i);
      const double left = jump[edge.vertices[0]] + phases.start[here] - phases.end[previous[i]];
      result.start[here] -= 0.5 * left;
      result.end[previous[i]] += 0.5 * left;
    }
  }
  return result;
}

Eigen::VectorXd CornerJumps(const PotentialProblem& problem)
{
  Eigen::VectorXd jump = PiecewiseConstantPhase(problem).atRows;
  const SpreadPhases phases = SpreadJumps(problem, jump);
  const std::vector<int>& previous = problem.Topology().previous;
  for (std::size_t i = 0; i < previous.size(); ++i)
  {
    if (problem.Topology().mesh.boundary[i].IsAligned())
    {
      jump[problem.Topology().mesh.boundary[i].vertices[0]] +=
        phases.start[static_cast<Eigen::Index>(i)] - phases.end[previous[i]];
    }
  }
  return jump;
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
