#include "PointPotential.h"

#include "AlignedPotential.h"
#include "Error.h"
#include "Parts.h"
#include "PointPlaces.h"

#include <cmath>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
std::shared_ptr<const PotentialSolver> WithoutHoles(
  std::shared_ptr<const PotentialSolver> potential)
{
  if (potential->GetTopology().LoopCount(BoundaryKind::Hole) > 0)
  {
    throw Error("The mesh has holes; singularities that are points need a mesh without any, drill "
                "the domain without singularities.");
  }
  return potential;
}

constexpr auto Islands = PotentialSolver::Periods::Islands;

}

PointPotential::PointPotential(std::shared_ptr<const PotentialSolver> solver, Alignment alignment)
  : Problem(WithoutHoles(std::move(solver)), std::move(alignment))
  , Domain{ Problem.Topology().AlignedLoops() }
  , Curve(CurvePhase(Problem))
  , Next(Problem.Topology().previous.size())
  , Sources(Curve.aligned.atRows)
{
  const PlanarTopology& topology = this->Problem.Topology();
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    this->Next[topology.previous[i]] = i;
    const auto& ends = topology.mesh.boundary[i].vertices;
    const Point middle = topology.Midpoint(topology.edges.ofBoundary[i]);
    const auto growth = this->Curve.growth.col(static_cast<Eigen::Index>(i));
    this->Halves.push_back({ ends[0], topology.PointAt(ends[0]), middle, growth[0] });
    this->Halves.push_back({ ends[1], middle, topology.PointAt(ends[1]), growth[1] });
  }
  this->FindBoundaryLogs();
  // The logarithms at the boundary replace the jumps of the phase at their vertices.
  for (std::size_t m = 0; m < this->BoundaryLogs.size(); ++m)
  {
    const int vertex = this->LogVertices[m];
    this->Sources[vertex] +=
      m < this->CurveLogs ? Pi * this->BoundaryLogs[m].strength : -this->Curve.jumps[vertex];
  }
  // The halves do not contain turns below SmallestTurn (AlignedSources) yet.
  Eigen::VectorXd missing = this->Sources;
  for (const BoundaryHalf& half : this->Halves)
  {
    missing[half.vertex] -= half.growth;
  }
  std::vector<BoundaryLog> logs;
  for (std::size_t m = 0; m < this->BoundaryLogs.size(); ++m)
  {
    logs.push_back(this->BoundaryLogAt(m));
  }
  this->AddFlows(logs);
  for (BoundaryHalf& half : this->Halves)
  {
    half.growth += 0.5 * missing[half.vertex];
  }
}

PointPotential::BoundaryLog PointPotential::BoundaryLogAt(std::size_t boundaryLog) const
{
  return { this->BoundaryLogs[boundaryLog], this->LogVertices[boundaryLog],
    boundaryLog < this->CurveLogs };
}

PointPotential::BoundaryLog PointPotential::QuarterAt(std::size_t entry) const
{
  const PlanarTopology& topology = this->Problem.Topology();
  const int vertex = topology.mesh.boundary[entry].vertices[0];
  if (topology.corners[vertex])
  {
    const double angle = Pi - topology.turning[static_cast<Eigen::Index>(entry)];
    return { { topology.PointAt(vertex), 2.0 * Pi / angle, angle }, vertex, false };
  }
  return { { this->Curve.start[entry], 2.0, Pi }, vertex, true };
}

PointPotential::LogFlow PointPotential::FlowOf(const BoundaryLog& source) const
{
  const auto count = static_cast<Eigen::Index>(this->Halves.size());
  LogFlow flow{ Eigen::VectorXd(count), Eigen::VectorXd(count) };
  const LogSource& log = source.log;
  const std::vector<double> turns = this->Turns(source);
  for (std::size_t h = 0; h < this->Halves.size(); ++h)
  {
    const auto [from, to] = this->Ends(h, source.onCurve);
    const auto row = static_cast<Eigen::Index>(h);
    flow.flux[row] = log.strength * turns[h];
    // The mean of a logarithm over a half is approximated by the mean of its values at both ends.
    // For points of curves, and along sides on a line through the position of the logarithm, it is
    // integrated exactly.
    const bool along = source.onCurve || std::abs(turns[h]) <= AngleRounding;
    flow.mean[row] = along
      ? log.strength * LogIntegral(from, to, log.position) / (to - from).norm()
      : 0.5 * (log.Value(this->Halves[h].from) + log.Value(this->Halves[h].to));
  }
  return flow;
}

void PointPotential::AddFlows(const std::vector<BoundaryLog>& sources)
{
  constexpr std::size_t BatchSize = 64; // limits the memory
  const auto logsOfPart =
    1 + MinimumPartSize / static_cast<std::ptrdiff_t>(this->Halves.size() + 1);
  for (std::size_t batch = 0; batch < sources.size(); batch += BatchSize)
  {
    std::vector<LogFlow> flows(std::min(BatchSize, sources.size() - batch));
    ForRanges(
      static_cast<std::ptrdiff_t>(flows.size()),
      [&](int begin, int end)
      {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
        {
          flows[i] = this->FlowOf(sources[batch + i]);
        }
      },
      logsOfPart);
    for (const LogFlow& flow : flows)
    {
      for (std::size_t h = 0; h < this->Halves.size(); ++h)
      {
        BoundaryHalf& half = this->Halves[h];
        half.logFlux += flow.flux[static_cast<Eigen::Index>(h)];
        half.logMean += flow.mean[static_cast<Eigen::Index>(h)];
        this->Sources[half.vertex] -= flow.flux[static_cast<Eigen::Index>(h)];
      }
    }
  }
}

PointPotential PointPotential::WithAlignment(Alignment alignment) const
{
  PointPotential result = *this;
  result.Problem = PotentialProblem(this->Problem.potential, std::move(alignment));
  result.Curve = CurvePhase(result.Problem);
  result.BoundaryLogs.clear();
  result.LogVertices.clear();
  result.FindBoundaryLogs();
  // Logarithms by vertex, with the strengths to add.
  std::map<int, double> changes;
  for (std::size_t m = 0; m < result.BoundaryLogs.size(); ++m)
  {
    changes[result.LogVertices[m]] += result.BoundaryLogs[m].strength;
  }
  for (std::size_t m = 0; m < this->BoundaryLogs.size(); ++m)
  {
    changes[this->LogVertices[m]] -= this->BoundaryLogs[m].strength;
  }
  std::vector<BoundaryLog> added;
  const auto add = [&](const PointPotential& owner, std::size_t m)
  {
    double& change = changes[owner.LogVertices[m]];
    if (change != 0.0)
    {
      BoundaryLog source = owner.BoundaryLogAt(m);
      source.log.strength = change;
      added.push_back(source);
      change = 0.0; // a vertex may have a logarithm in both
    }
  };
  for (std::size_t m = 0; m < result.BoundaryLogs.size(); ++m)
  {
    add(result, m);
  }
  for (std::size_t m = 0; m < this->BoundaryLogs.size(); ++m)
  {
    add(*this, m);
  }
  result.AddFlows(added);
  return result;
}

void PointPotential::FindBoundaryLogs()
{
  const PlanarTopology& topology = this->Problem.Topology();
  const auto& chosen = this->Problem.alignment.chosenQuarters;
  std::vector<LogSource> corners;
  std::vector<int> cornerVertices;
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const int vertex = topology.mesh.boundary[i].vertices[0];
    const auto found = chosen.find(vertex);
    const double source = this->Curve.jumps[vertex];
    if (topology.corners[vertex])
    {
      const double angle = Pi - topology.turning[static_cast<Eigen::Index>(i)];
      if (std::abs(source) > 4.0 * AngleRounding)
      {
        corners.push_back({ topology.PointAt(vertex), -source / angle, angle });
        cornerVertices.push_back(vertex);
      }
    }
    else if (found != chosen.end() && found->second != 0)
    {
      // The boundary is straight here: −s / α = 2πk / π.
      this->BoundaryLogs.push_back({ this->Curve.start[i], 2.0 * found->second, Pi });
      this->LogVertices.push_back(vertex);
    }
  }
  this->CurveLogs = this->BoundaryLogs.size();
  this->BoundaryLogs.insert(this->BoundaryLogs.end(), corners.begin(), corners.end());
  this->LogVertices.insert(this->LogVertices.end(), cornerVertices.begin(), cornerVertices.end());
}

std::array<Point, 2> PointPotential::Ends(std::size_t half, bool onCurve) const
{
  if (!onCurve)
  {
    return { this->Halves[half].from, this->Halves[half].to };
  }
  // The start of the next entry is the end of this one, on the curve as on the polygon.
  const std::size_t i = half / 2;
  if (half % 2 == 0)
  {
    return { this->Curve.start[i], this->Curve.middle[i] };
  }
  return { this->Curve.middle[i], this->Curve.start[this->Next[i]] };
}

std::vector<double> PointPotential::Turns(const BoundaryLog& source) const
{
  const auto& [log, vertex, onCurve] = source;
  std::vector<double> turns;
  double remaining = log.angle;
  double length = 0.0; // of the halves at its vertex
  for (std::size_t h = 0; h < this->Halves.size(); ++h)
  {
    const auto [from, to] = this->Ends(h, onCurve);
    const bool own = this->Halves[h].vertex == vertex;
    turns.push_back(own ? 0.0 : log.Turn(from, to));
    remaining -= turns.back();
    length += own ? (to - from).norm() : 0.0;
  }
  // A curve turns away from its tangent, but a half at the vertex is straight: it receives the
  // angle that remains. For a corner, what remains is rounding.
  for (std::size_t h = 0; onCurve && h < this->Halves.size(); ++h)
  {
    if (this->Halves[h].vertex == vertex)
    {
      const auto [from, to] = this->Ends(h, onCurve);
      turns[h] = remaining * (to - from).norm() / length;
    }
  }
  return turns;
}

std::array<Point, 2> PointPotential::StripEnds(Eigen::Index k) const
{
  const PlanarTopology& topology = this->Problem.Topology();
  const Cycle& cycle = topology.cycles[k];
  const auto middle = [&topology](int position)
  { return topology.Midpoint(topology.EdgeOfBoundary(position)); };
  return { middle(cycle.firstBoundaryEdge), middle(cycle.lastBoundaryEdge) };
}

std::vector<Point> PointPotential::StripPath(Eigen::Index k, bool onCurve) const
{
  const PlanarTopology& topology = this->Problem.Topology();
  const Cycle& cycle = topology.cycles[k];
  const std::array<Point, 2> ends = onCurve
    ? std::array<Point, 2>{ this->Curve.middle[cycle.firstBoundaryEdge],
        this->Curve.middle[cycle.lastBoundaryEdge] }
    : this->StripEnds(k);
  std::vector<Point> path = { ends[0] };
  for (const Cycle::Step& step : cycle.steps)
  {
    path.push_back(topology.CentreOf(step.triangle));
  }
  path.push_back(ends[1]);
  return path;
}

double PointPotential::StripTurn(const LogSource& log, Eigen::Index k, bool onCurve) const
{
  const std::vector<Point> path = this->StripPath(k, onCurve);
  double turn = 0.0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i)
  {
    turn += log.Turn(path[i], path[i + 1]);
  }
  return -turn;
}

void PointPotential::RequireSolvable(const Configuration& configuration) const
{
  if (TotalQuarters(configuration) != this->Problem.alignment.count.givenInteriorQuarters)
  {
    PoincareHopfCount count = this->Problem.alignment.count;
    count.givenInteriorQuarters = TotalQuarters(configuration);
    RequireConsistent(count);
  }
  RequirePlaces(configuration, this->Domain);
}

PointPotential::Solution PointPotential::Solve(const Configuration& configuration) const
{
  this->RequireSolvable(configuration);
  Solution result;
  for (const Singularity& singularity : configuration)
  {
    result.logs.push_back(
      { singularity.position, static_cast<double>(singularity.quarterIndex), 2.0 * Pi });
  }
  const std::size_t inside = result.logs.size();

  // 1. Sources of R. The angles at which a logarithm sees the boundary add up to its angle.
  result.sources = this->Sources;
  constexpr std::size_t BatchSize = 4096; // limits the memory
  for (std::size_t batch = 0; batch < this->Halves.size(); batch += BatchSize)
  {
    const std::size_t count = std::min(BatchSize, this->Halves.size() - batch);
    Eigen::MatrixXd turns(static_cast<Eigen::Index>(inside), static_cast<Eigen::Index>(count));
    ForRanges(
      turns.cols(),
      [&](int begin, int end)
      {
        for (Eigen::Index h = begin; h < end; ++h)
        {
          const BoundaryHalf& half = this->Halves[batch + static_cast<std::size_t>(h)];
          for (std::size_t i = 0; i < inside; ++i)
          {
            const LogSource& log = result.logs[i];
            turns(static_cast<Eigen::Index>(i), h) = log.strength * log.Turn(half.from, half.to);
          }
        }
      },
      1 + MinimumPartSize / static_cast<std::ptrdiff_t>(inside + 1));
    for (Eigen::Index h = 0; h < turns.cols(); ++h)
    {
      double& source = result.sources[this->Halves[batch + static_cast<std::size_t>(h)].vertex];
      for (Eigen::Index i = 0; i < turns.rows(); ++i)
      {
        source -= turns(i, h);
      }
    }
  }
  result.logs.insert(result.logs.end(), this->BoundaryLogs.begin(), this->BoundaryLogs.end());
  this->Complete(result,
    [&](Eigen::Index k, double phase)
    {
      for (std::size_t m = 0; m < result.logs.size(); ++m)
      {
        const LogSource& log = result.logs[m];
        const bool onCurve = m >= inside && m < inside + this->CurveLogs;
        phase -= log.strength * this->StripTurn(log, k, onCurve);
      }
      return phase;
    });
  return result;
}

void PointPotential::Complete(
  Solution& result, const std::function<double(Eigen::Index, double)>& subtractTurns) const
{
  // Remove the sum of the rounding errors of the angles: the Neumann problem is solvable only for
  // sources of sum zero.
  const Eigen::Index periods = this->Problem.potential->PeriodCount();
  const Eigen::Index vertices = result.sources.size() - periods;
  result.sources[this->Halves.front().vertex] -= result.sources.head(vertices).sum();

  // 2. R without periods. The sources that keep the periods zero are the phase that R carries.
  result.regular = this->Problem.potential->Solve(result.sources, Islands);
  const Eigen::VectorXd carried =
    this->Problem.potential->GetPeriodResponse().RemovePeriods(result.regular);
  result.aligned = result.regular;
  result.offsets = result.periods = Eigen::VectorXd::Zero(periods);
  if (periods > 0)
  {
    Eigen::VectorXd defects(periods);
    for (Eigen::Index k = 0; k < periods; ++k)
    {
      defects[k] = WrapAngle(
        subtractTurns(k, AlignedDifference(this->Problem, this->Curve.aligned, k) - carried[k]));
      result.holonomyDefect.push_back(defects[k]);
    }
    // 3. R with the periods that align inner loops.
    const PeriodResponse& response = this->Problem.potential->GetPeriodResponse();
    result.offsets = NearestOffsets(defects, response.inverse);
    result.periods = response.inverse * result.offsets;
    result.aligned = result.regular + response.basis * result.offsets;
  }
}
}
