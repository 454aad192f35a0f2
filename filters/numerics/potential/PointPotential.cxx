#include "PointPotential.h"

#include "AlignedPotential.h"
#include "DomainQueries.h"
#include "Error.h"

#include <Eigen/LU>

#include <cmath>
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

/// Makes a solution single-valued by sources at the periods, and returns them. `basis` and
/// `inverse` are PeriodBasis and PeriodInverse of PointPotential.
Eigen::VectorXd RemovePeriods(
  const Eigen::MatrixXd& basis, const Eigen::MatrixXd& inverse, Eigen::VectorXd& solution)
{
  const Eigen::Index periods = basis.cols();
  if (periods == 0)
  {
    return {};
  }
  Eigen::VectorXd sources = -inverse.inverse() * solution.tail(periods);
  solution += basis * sources;
  solution.tail(periods).setZero();
  return sources;
}
}

PointPotential::PointPotential(std::shared_ptr<const PotentialSolver> solver, Alignment alignment)
  : Problem(WithoutHoles(std::move(solver)), std::move(alignment))
  , Domain{ Problem.Topology().AlignedLoops() }
  , Curve(CurvePhase(Problem))
  , Next(Problem.Topology().previous.size())
  , Sources(Curve.aligned.atRows)
{
  const MeshTopology& topology = this->Problem.Topology();
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    this->Next[static_cast<std::size_t>(topology.previous[i])] = i;
    const auto& ends = topology.mesh.boundary[i].vertices;
    const Point middle = topology.Midpoint(topology.edges.ofBoundary[i]);
    const auto growth = this->Curve.growth.col(static_cast<Eigen::Index>(i));
    this->Halves.push_back({ ends[0], topology.PointAt(ends[0]), middle, growth[0] });
    this->Halves.push_back({ ends[1], middle, topology.PointAt(ends[1]), growth[1] });
  }
  this->FindBoundaryLogs();
  // The halves do not contain turns below SmallestTurn (AlignedSources) yet.
  Eigen::VectorXd missing = this->Sources;
  for (const BoundaryHalf& half : this->Halves)
  {
    missing[half.vertex] -= half.growth;
  }
  for (std::size_t m = 0; m < this->BoundaryLogs.size(); ++m)
  {
    const std::vector<double> turns = this->Turns(m);
    const LogSource& log = this->BoundaryLogs[m];
    for (std::size_t h = 0; h < this->Halves.size(); ++h)
    {
      BoundaryHalf& half = this->Halves[h];
      const auto [from, to] = this->Ends(h, m < this->CurveLogs);
      half.logFlux += log.strength * turns[h];
      // The mean of a logarithm over a half is approximated by the mean of its values at both ends.
      // For points of curves, and along sides on a line through the position of the logarithm, it
      // is integrated exactly.
      const bool along = m < this->CurveLogs || std::abs(turns[h]) <= AngleRounding;
      half.logMean += along
        ? log.strength * LogIntegral(from, to, log.position) / (to - from).norm()
        : 0.5 * (log.Value(half.from) + log.Value(half.to));
      this->Sources[half.vertex] -= log.strength * turns[h];
    }
  }
  for (BoundaryHalf& half : this->Halves)
  {
    half.growth += 0.5 * missing[half.vertex];
  }

  const PotentialSolver& potential = *this->Problem.potential;
  const Eigen::Index periods = potential.PeriodCount();
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(potential.Rows(), periods);
  unit.bottomRows(periods).setIdentity();
  this->PeriodBasis = periods > 0 ? potential.Solve(unit, Islands) : unit;
  this->PeriodInverse = this->PeriodBasis.bottomRows(periods);
}

void PointPotential::FindBoundaryLogs()
{
  const MeshTopology& topology = this->Problem.Topology();
  const auto& chosen = this->Problem.alignment.chosenQuarters;
  std::vector<LogSource> corners;
  std::vector<int> cornerVertices;
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const int vertex = topology.mesh.boundary[i].vertices[0];
    const auto found = chosen.find(vertex);
    const double source = this->Curve.jumps[vertex];
    if (topology.corners[static_cast<std::size_t>(vertex)])
    {
      const double angle = Pi - topology.turning[static_cast<Eigen::Index>(i)];
      if (std::abs(source) > 4.0 * AngleRounding)
      {
        corners.push_back({ topology.PointAt(vertex), -source / angle, angle });
        cornerVertices.push_back(vertex);
        this->Sources[vertex] -= source;
      }
    }
    else if (found != chosen.end() && found->second != 0)
    {
      // The boundary is straight here: −s / α = 2πk / π.
      this->BoundaryLogs.push_back({ this->Curve.start[i], 2.0 * found->second, Pi });
      this->LogVertices.push_back(vertex);
      this->Sources[vertex] += 2.0 * Pi * found->second;
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

std::vector<double> PointPotential::Turns(std::size_t boundaryLog) const
{
  const LogSource& log = this->BoundaryLogs[boundaryLog];
  const bool onCurve = boundaryLog < this->CurveLogs;
  std::vector<double> turns;
  double remaining = log.angle;
  double length = 0.0; // of the halves at its vertex
  for (std::size_t h = 0; h < this->Halves.size(); ++h)
  {
    const auto [from, to] = this->Ends(h, onCurve);
    const bool own = this->Halves[h].vertex == this->LogVertices[boundaryLog];
    turns.push_back(own ? 0.0 : log.Turn(from, to));
    remaining -= turns.back();
    length += own ? (to - from).norm() : 0.0;
  }
  // A curve turns away from its tangent, but a half at the vertex is straight: it receives the
  // angle that remains. For a corner, what remains is rounding.
  for (std::size_t h = 0; onCurve && h < this->Halves.size(); ++h)
  {
    if (this->Halves[h].vertex == this->LogVertices[boundaryLog])
    {
      const auto [from, to] = this->Ends(h, onCurve);
      turns[h] = remaining * (to - from).norm() / length;
    }
  }
  return turns;
}

std::array<Point, 2> PointPotential::StripEnds(Eigen::Index k) const
{
  const LoopStrip& strip = this->Problem.potential->GetStrips()[static_cast<std::size_t>(k)];
  const MeshTopology& topology = this->Problem.Topology();
  const auto middle = [&topology](int position)
  { return topology.Midpoint(topology.EdgeOfBoundary(position)); };
  return { middle(strip.firstBoundaryEdge), middle(strip.lastBoundaryEdge) };
}

double PointPotential::StripTurn(
  const LogSource& log, Eigen::Index k, const std::array<Point, 2>& ends) const
{
  const TriangleMesh& mesh = this->Problem.Topology().mesh;
  double turn = 0.0;
  Point here = ends[0];
  for (const LoopStrip::Step& step :
    this->Problem.potential->GetStrips()[static_cast<std::size_t>(k)].steps)
  {
    const auto& v = mesh.triangles[static_cast<std::size_t>(step.triangle)];
    const Point centre =
      (mesh.points[static_cast<std::size_t>(v[0])] + mesh.points[static_cast<std::size_t>(v[1])] +
        mesh.points[static_cast<std::size_t>(v[2])]) /
      3.0;
    turn += log.Turn(here, centre);
    here = centre;
  }
  return -(turn + log.Turn(here, ends[1]));
}

Eigen::VectorXd PointPotential::SolveSingleValued(const Eigen::VectorXd& sources) const
{
  Eigen::VectorXd regular = this->Problem.potential->Solve(sources, Islands);
  RemovePeriods(this->PeriodBasis, this->PeriodInverse, regular);
  return regular;
}

PointPotential::Solution PointPotential::Solve(const Configuration& configuration) const
{
  if (TotalQuarters(configuration) != this->Problem.alignment.count.givenInteriorQuarters)
  {
    PoincareHopfCount count = this->Problem.alignment.count;
    count.givenInteriorQuarters = TotalQuarters(configuration);
    RequireConsistent(count);
  }
  Solution result;
  // Points nearer than this coincide in single precision.
  const double minimum = 1e-6 * this->Domain.Diagonal();
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    const Singularity& singularity = configuration[i];
    if (!(SignedDistance(singularity.position, this->Domain) > minimum))
    {
      throw Error("The singularity " + std::to_string(i + 1) + " at " +
        Describe(singularity.position) +
        " lies outside the domain or on its boundary; move it inside.");
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      if ((configuration[j].position - singularity.position).norm() <= minimum)
      {
        throw Error("Singularities " + std::to_string(j + 1) + " and " + std::to_string(i + 1) +
          " are at the same place " + Describe(singularity.position) +
          "; replace them by one with the sum of their quarter indices.");
      }
    }
    result.logs.push_back(
      { singularity.position, static_cast<double>(singularity.quarterIndex), 2.0 * Pi });
  }
  const std::size_t inside = result.logs.size();

  // 1. Sources of R. The angles at which a logarithm sees the boundary add up to its angle.
  result.sources = this->Sources;
  for (const BoundaryHalf& half : this->Halves)
  {
    for (const LogSource& log : result.logs)
    {
      result.sources[half.vertex] -= log.strength * log.Turn(half.from, half.to);
    }
  }
  result.logs.insert(result.logs.end(), this->BoundaryLogs.begin(), this->BoundaryLogs.end());
  // Remove the sum of the rounding errors of the angles: the Neumann problem is solvable only for
  // sources of sum zero.
  const Eigen::Index periods = this->Problem.potential->PeriodCount();
  const Eigen::Index vertices = result.sources.size() - periods;
  result.sources[this->Halves.front().vertex] -= result.sources.head(vertices).sum();

  // 2. R without periods. The sources that keep the periods zero are the phase that R carries.
  result.regular = this->Problem.potential->Solve(result.sources, Islands);
  const Eigen::VectorXd carried =
    RemovePeriods(this->PeriodBasis, this->PeriodInverse, result.regular);
  result.aligned = result.regular;
  result.offsets = result.periods = Eigen::VectorXd::Zero(periods);
  if (periods > 0)
  {
    Eigen::VectorXd defects(periods);
    for (Eigen::Index k = 0; k < periods; ++k)
    {
      double difference = AlignedDifference(this->Problem, this->Curve.aligned, k) - carried[k];
      const LoopStrip& strip = this->Problem.potential->GetStrips()[static_cast<std::size_t>(k)];
      const std::array<Point, 2> curveEnds = {
        this->Curve.middle[static_cast<std::size_t>(strip.firstBoundaryEdge)],
        this->Curve.middle[static_cast<std::size_t>(strip.lastBoundaryEdge)]
      };
      for (std::size_t m = 0; m < result.logs.size(); ++m)
      {
        const LogSource& log = result.logs[m];
        const bool onCurve = m >= inside && m < inside + this->CurveLogs;
        difference -=
          log.strength * this->StripTurn(log, k, onCurve ? curveEnds : this->StripEnds(k));
      }
      defects[k] = WrapAngle(difference);
      result.holonomyDefect.push_back(defects[k]);
    }
    // 3. R with the periods that align inner loops.
    result.offsets = NearestOffsets(defects, this->PeriodInverse);
    result.periods = this->PeriodInverse * result.offsets;
    result.aligned = result.regular + this->PeriodBasis * result.offsets;
  }
  return result;
}
}
