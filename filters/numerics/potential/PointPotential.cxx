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
}

PointPotential::PointPotential(std::shared_ptr<const PotentialSolver> solver, Alignment alignment)
  : Problem(WithoutHoles(std::move(solver)), std::move(alignment))
  , Domain{ Problem.Topology().AlignedLoops() }
  , Sources(CurvePhase(Problem))
  , Smooth(Sources.atRows)
{
  const Eigen::VectorXd jump = CornerJumps(this->Problem);
  const MeshTopology& topology = this->Problem.Topology();
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const auto& ends = topology.mesh.boundary[i].vertices;
    const Point middle = topology.Midpoint(topology.edges.ofBoundary[i]);
    this->Halves.push_back({ ends[0], topology.PointAt(ends[0]), middle });
    this->Halves.push_back({ ends[1], middle, topology.PointAt(ends[1]) });

    const int vertex = ends[0];
    const double angle = Pi - topology.turning[static_cast<Eigen::Index>(i)];
    const double source = jump[vertex];
    const bool corner = topology.corners[static_cast<std::size_t>(vertex)] ||
      this->Problem.alignment.chosenQuarters.count(vertex) != 0;
    if (corner && std::abs(source) > 4.0 * AngleRounding)
    {
      this->Corners.push_back({ topology.PointAt(vertex), -source / angle, angle });
      this->CornerVertices.push_back(vertex);
      this->Smooth[vertex] -= source;
    }
  }

  const PotentialSolver& potential = *this->Problem.potential;
  const Eigen::Index periods = potential.PeriodCount();
  Eigen::MatrixXd unit = Eigen::MatrixXd::Zero(potential.Rows(), periods);
  unit.bottomRows(periods).setIdentity();
  this->PeriodBasis = periods > 0 ? potential.Solve(unit, Islands) : unit;
  this->PeriodInverse = this->PeriodBasis.bottomRows(periods);
}

std::array<Point, 2> PointPotential::StripEnds(Eigen::Index k) const
{
  const LoopStrip& strip = this->Problem.potential->GetStrips()[static_cast<std::size_t>(k)];
  const MeshTopology& topology = this->Problem.Topology();
  const auto middle = [&topology](int position)
  { return topology.Midpoint(topology.EdgeOfBoundary(position)); };
  return { middle(strip.firstBoundaryEdge), middle(strip.lastBoundaryEdge) };
}

double PointPotential::StripTurn(const LogSource& log, Eigen::Index k) const
{
  const auto [first, last] = this->StripEnds(k);
  const TriangleMesh& mesh = this->Problem.Topology().mesh;
  double turn = 0.0;
  Point here = first;
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
  return -(turn + log.Turn(here, last));
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
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    const Singularity& singularity = configuration[i];
    if (!(SignedDistance(singularity.position, this->Domain) > 1e-6 * this->Domain.Diagonal()))
    {
      throw Error("The singularity " + std::to_string(i) + " at " + Describe(singularity.position) +
        " lies outside the domain or on its boundary; move it inside.");
    }
    for (std::size_t j = 0; j < i; ++j)
    {
      // Nearer than this they are one point in single precision.
      if ((configuration[j].position - singularity.position).norm() <=
        1e-6 * this->Domain.Diagonal())
      {
        throw Error("Singularities " + std::to_string(j) + " and " + std::to_string(i) +
          " are at the same place " + Describe(singularity.position) +
          "; replace them by one with the sum of their quarter indices.");
      }
    }
    result.logs.push_back(
      { singularity.position, static_cast<double>(singularity.quarterIndex), 2.0 * Pi });
  }
  result.logs.insert(result.logs.end(), this->Corners.begin(), this->Corners.end());

  // 1. Sources of R. Every log is seen from all of the boundary under the angle of the domain.
  result.sources = this->Smooth;
  for (std::size_t m = 0; m < result.logs.size(); ++m)
  {
    const LogSource& log = result.logs[m];
    for (const BoundaryHalf& half : this->Halves)
    {
      const bool own =
        m >= configuration.size() && half.vertex == this->CornerVertices[m - configuration.size()];
      const double angle = own ? 0.0 : log.Turn(half.from, half.to);
      result.sources[half.vertex] -= log.strength * angle;
    }
  }
  // Angles have rounding errors that a Neumann problem must not see as a source.
  const Eigen::Index periods = this->Problem.potential->PeriodCount();
  const Eigen::Index vertices = result.sources.size() - periods;
  result.sources[this->Halves.front().vertex] -= result.sources.head(vertices).sum();

  // 2. R without periods: the sources at the periods that keep them zero are what R carries.
  result.regular = this->Problem.potential->Solve(result.sources, Islands);
  result.aligned = result.regular;
  result.offsets = result.periods = Eigen::VectorXd::Zero(periods);
  if (periods > 0)
  {
    const Eigen::VectorXd carried = -this->PeriodInverse.inverse() * result.regular.tail(periods);
    result.regular += this->PeriodBasis * carried;
    result.regular.tail(periods).setZero();
    Eigen::VectorXd defects(periods);
    for (Eigen::Index k = 0; k < periods; ++k)
    {
      double difference = AlignedDifference(this->Problem, this->Sources, k) - carried[k];
      for (const LogSource& log : result.logs)
      {
        difference -= log.strength * this->StripTurn(log, k);
      }
      defects[k] = WrapAngle(difference);
      result.holonomyDefect.push_back(defects[k]);
    }
    // 3. And with those that the alignment of inner loops asks for.
    result.offsets = NearestOffsets(defects, this->PeriodInverse);
    result.periods = this->PeriodInverse * result.offsets;
    result.aligned = result.regular + this->PeriodBasis * result.offsets;
  }
  return result;
}
}
