#include "HField.h"

#include "ConfigurationPlacement.h"
#include "ConjugateField.h"
#include "Error.h"
#include "Parts.h"
#include "RenormalizedEnergy.h"
#include "Stopwatch.h"
#include "TriangleArea.h"
#include "UnitNormField.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Returns the integral of a P1 function and the area.
std::array<double, 2> Integrate(const TriangleMesh& mesh, const Eigen::VectorXd& values)
{
  std::array<double, 2> result = { 0.0, 0.0 };
  for (const auto& triangle : mesh.triangles)
  {
    const double area = TriangleArea(mesh, triangle);
    result[0] += area * (values[triangle[0]] + values[triangle[1]] + values[triangle[2]]) / 3.0;
    result[1] += area;
  }
  return result;
}

/// Sets the values at vertices on a logarithm to the mean over a disk of radius a, half of the
/// shortest edge, where the mean of log r is log a − ½.
void SetCores(const PointPotential& potential, const PointPotential::Solution& solution,
  Eigen::VectorXd& values)
{
  const PlanarTopology& topology = potential.GetProblem().Topology();
  const std::vector<int>& atBoundary = potential.GetBoundaryLogVertices();
  const std::size_t inside = solution.logs.size() - atBoundary.size();
  for (int v = 0; v < static_cast<int>(values.size()); ++v)
  {
    const auto found = std::find(atBoundary.begin(), atBoundary.end(), v);
    if (std::isfinite(values[v]) && found == atBoundary.end())
    {
      continue;
    }
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : topology.edges.vertices)
    {
      if (a == v || b == v)
      {
        shortest = std::min(shortest, (topology.PointAt(a) - topology.PointAt(b)).norm());
      }
    }
    values[v] = solution.aligned[v];
    const std::size_t own = inside + static_cast<std::size_t>(found - atBoundary.begin());
    for (std::size_t m = 0; m < solution.logs.size(); ++m)
    {
      const LogSource& log = solution.logs[m];
      values[v] += m == own || topology.PointAt(v) == log.position
        ? log.strength * (std::log(0.5 * shortest) - 0.5)
        : log.Value(topology.PointAt(v));
    }
  }
}

/// Returns Φ = R + logarithms at the vertices, with area mean 0.
Eigen::VectorXd AssembleValues(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const TriangleMesh& mesh = potential.GetProblem().Topology().mesh;
  const auto count = static_cast<Eigen::Index>(mesh.points.size());
  Eigen::VectorXd values = solution.aligned.head(count);
  auto [integral, area] = Integrate(mesh, values);
  std::vector<std::array<Point, 2>> boundary;
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    boundary.push_back({ mesh.points[edge.vertices[0]], mesh.points[edge.vertices[1]] });
  }
  for (const LogSource& log : solution.logs)
  {
    integral += log.strength * LogIntegral(boundary, log.position);
  }
  ForRanges(count,
    [&](int begin, int end)
    {
      for (int v = begin; v < end; ++v)
      {
        values[v] += SumOfLogs(solution.logs, mesh.points[v]);
      }
    });
  SetCores(potential, solution, values);
  return values.array() - integral / area;
}

/// Returns u from the conjugate of R, the turns of the corners' logarithms along the path, and the
/// arguments of the singularities as powers of unit complex numbers, which needs no branches. At
/// singularities on curves, the arguments are evaluated with the boundary edges on the curve.
ComplexVector AssembleField(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const PotentialProblem& problem = potential.GetProblem();
  const PlanarTopology& topology = problem.Topology();
  const int first = topology.FirstOuterEdge();
  const int firstEdge = topology.EdgeOfBoundary(first);
  const std::vector<LogSource>& ofBoundary = potential.GetBoundaryLogs();
  const std::size_t onCurves = potential.CurveLogCount();
  const Eigen::RowVectorXd phase = IntegrateConjugate(topology,
    problem.potential->Gradient(solution.aligned), firstEdge, Eigen::VectorXd::Zero(1),
    { ofBoundary.begin() + static_cast<std::ptrdiff_t>(onCurves), ofBoundary.end() });
  std::vector<Point> seenFromCurves;
  for (int e = 0; onCurves > 0 && e < topology.edges.Count(); ++e)
  {
    seenFromCurves.push_back(topology.Midpoint(e));
  }
  for (std::size_t i = 0; onCurves > 0 && i < topology.mesh.boundary.size(); ++i)
  {
    seenFromCurves[topology.edges.ofBoundary[i]] = potential.GetCurveMiddles()[i];
  }
  const std::size_t singularities = solution.logs.size() - ofBoundary.size();
  ComplexVector u(phase.size());
  ForRanges(u.size(),
    [&](int begin, int end)
    {
      for (int e = begin; e < end; ++e)
      {
        u[e] = std::polar(1.0, phase[e]) *
          UnitOfTurns(solution.logs, singularities, topology.Midpoint(e));
        if (onCurves > 0)
        {
          u[e] *= UnitOfTurns(ofBoundary, onCurves, seenFromCurves[e]);
        }
      }
    });
  u *= problem.alignment.crosses[first] * std::polar(1.0, potential.GetMidpointShift()[first]) /
    u[firstEdge];
  return u;
}

/// Returns the largest deviation from the prescribed phase on aligned edges.
double Misalignment(const PointPotential& potential, const ComplexVector& u)
{
  const PotentialProblem& problem = potential.GetProblem();
  const ComplexVector& crosses = problem.alignment.crosses;
  double largest = 0.0;
  for (Eigen::Index i = 0; i < crosses.size(); ++i)
  {
    const Complex prescribed = crosses[i] * std::polar(1.0, potential.GetMidpointShift()[i]);
    largest = std::max(
      largest, std::abs(u[problem.Topology().EdgeOfBoundary(static_cast<int>(i))] - prescribed));
  }
  return largest;
}

/// Returns H on a mesh whose singularities are holes: Φ of the unit-norm field.
HField SolveOnHoles(const PotentialProblem& problem)
{
  HField result;
  SolvedField& field = result.field;
  field.topology = problem.potential->ShareTopology();
  field.count = problem.alignment.count;
  UnitNormField unit = SolveUnitNorm(problem);
  field.u = std::move(unit.u);
  field.energy = unit.energy;
  field.residual = unit.residual;
  field.holonomyDefect = unit.holonomyDefect;
  const TriangleMesh& mesh = problem.Topology().mesh;
  const auto count = static_cast<Eigen::Index>(mesh.points.size());
  result.h = 0.25 * unit.potential.head(count);
  const auto [integral, area] = Integrate(mesh, result.h);
  result.h.array() -= integral / area;
  for (const double period : unit.potential.segment(
         count, problem.potential->PeriodCount(PotentialSolver::Periods::Islands)))
  {
    result.periods.push_back(0.25 * period);
  }
  result.renormalizedEnergy = std::numeric_limits<double>::quiet_NaN();
  return result;
}

HField SolveAtPoints(const PointPotential& potential, const Configuration& interior)
{
  HField result;
  SolvedField& field = result.field;
  const PotentialProblem& problem = potential.GetProblem();
  field.topology = problem.potential->ShareTopology();
  field.count = problem.alignment.count;
  const PointPotential::Solution solution = potential.Solve(interior);
  const RenormalizedEnergyValue energy = EvaluateRenormalizedEnergy(potential, solution);
  result.h = 0.25 * AssembleValues(potential, solution);
  field.u = AssembleField(potential, solution);
  field.residual = Misalignment(potential, field.u);
  // Rotate from the tangents of curves to the directions of edges.
  SetAlignedCrosses(problem.Topology(), problem.alignment, field.u);

  field.holonomyDefect = solution.holonomyDefect;
  for (const double period : solution.periods)
  {
    result.periods.push_back(0.25 * period);
  }
  result.renormalizedEnergy = energy.energy;
  field.energy = energy.energy;
  const double radius = potential.GetDomain().Diagonal() / 40.0;
  for (std::size_t m = 0; m < solution.logs.size(); ++m)
  {
    const LogSource& log = solution.logs[m];
    const bool given = m < interior.size() && interior[m].radius > 0.0;
    field.energy += 0.5 * log.angle * log.strength * log.strength *
      std::log(1.0 / (given ? interior[m].radius : radius));
  }
  return result;
}

/// Throws Error unless the singularity is in a hole of the same quarter index.
void RequireHole(const PlanarTopology& topology, const Singularity& singularity)
{
  for (const BoundaryLoop& loop : topology.loops)
  {
    double winding = 0.0;
    for (const int edge : loop.edges)
    {
      const auto& [from, to] = topology.BoundaryAt(edge).vertices;
      winding += AngleBetween(
        topology.PointAt(from) - singularity.position, topology.PointAt(to) - singularity.position);
    }
    if (loop.kind == BoundaryKind::Hole && std::abs(winding) > Pi &&
      loop.quarterIndex == singularity.quarterIndex)
    {
      return;
    }
  }
  throw Error("The mesh has holes, but none of quarter index " +
    std::to_string(singularity.quarterIndex) + " at " + Describe(singularity.position) +
    "; give all singularities as holes, or the domain without holes.");
}

/// Places the configuration on the mesh; throws Error when it is invalid.
PlacedConfiguration Place(const PlanarTopology& topology, const Configuration& configuration,
  const std::vector<CornerChoice>& corners)
{
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    if (!configuration[i].position.allFinite())
    {
      throw Error("Row " + std::to_string(i + 1) +
        " of the singularities has a coordinate that is not a finite number; correct it.");
    }
  }
  PlacedConfiguration placed = PlaceConfiguration(topology, configuration, corners);
  if (topology.LoopCount(BoundaryKind::Hole) > 0)
  {
    for (const Singularity& singularity : placed.interior)
    {
      RequireHole(topology, singularity);
    }
  }
  return placed;
}

HField SolvePlaced(const std::shared_ptr<const PotentialSolver>& potential,
  const PlacedConfiguration& placed, const Progress& progress)
{
  const PlanarTopology& topology = potential->GetTopology();
  const bool holes = topology.LoopCount(BoundaryKind::Hole) > 0;
  Stopwatch stopwatch;
  const Alignment alignment =
    AlignWithBoundary(topology, placed.corners, holes ? 0 : TotalQuarters(placed.interior));
  HField result = holes ? SolveOnHoles({ potential, alignment })
                        : SolveAtPoints({ potential, alignment }, placed.interior);
  // The angle between cross and boundary is a fraction of this; only rounding is accepted.
  result.field.converged = result.field.residual <= 1e-6;
  result.field.seconds.solve = stopwatch.Lap();
  progress.Report(0.8);
  result.field.Read(holes ? Configuration() : placed.interior);
  progress.Report(1.0);
  return result;
}
}

HField SolveHField(const std::shared_ptr<const PotentialSolver>& potential,
  const Configuration& configuration, const std::vector<CornerChoice>& corners,
  const Progress& progress)
{
  return SolvePlaced(potential, Place(potential->GetTopology(), configuration, corners), progress);
}

HField SolveHField(const SharedPlanarTopology& topology, const Configuration& configuration,
  const std::vector<CornerChoice>& corners, const Progress& progress)
{
  Stopwatch stopwatch;
  const PlacedConfiguration placed = Place(*topology, configuration, corners);
  progress.Report(0.1);
  const double assemble = stopwatch.Lap();
  const auto potential = std::make_shared<const PotentialSolver>(topology, progress.Part(0.1, 0.7));
  const double factor = stopwatch.Lap();
  HField result = SolvePlaced(potential, placed, progress.Part(0.7, 1.0));
  result.field.seconds.assemble = assemble;
  result.field.seconds.factor = factor;
  return result;
}
}
