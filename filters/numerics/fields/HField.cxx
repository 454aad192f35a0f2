#include "HField.h"

#include "ConfigurationPlacement.h"
#include "ConjugateField.h"
#include "Error.h"
#include "FieldIndices.h"
#include "RenormalizedEnergy.h"
#include "Stopwatch.h"
#include "UnitNormField.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// ∫ of a P1 function, and the area.
std::array<double, 2> Integrate(const TriangleMesh& mesh, const Eigen::VectorXd& values)
{
  std::array<double, 2> result = { 0.0, 0.0 };
  for (const auto& triangle : mesh.triangles)
  {
    const Point& p0 = mesh.points[static_cast<std::size_t>(triangle[0])];
    const double area = 0.5 *
      Cross(mesh.points[static_cast<std::size_t>(triangle[1])] - p0,
        mesh.points[static_cast<std::size_t>(triangle[2])] - p0);
    result[0] += area * (values[triangle[0]] + values[triangle[1]] + values[triangle[2]]) / 3.0;
    result[1] += area;
  }
  return result;
}

/// The values at vertices that are the position of a log: there the mean over a disk of radius a, half
/// of the shortest edge, where that of log r is log a − ½.
void SetCores(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const PointPotential::Solution& solution, Eigen::VectorXd& values)
{
  for (Eigen::Index v = 0; v < values.size(); ++v)
  {
    if (std::isfinite(values[v]))
    {
      continue;
    }
    double shortest = std::numeric_limits<double>::infinity();
    for (const auto& [a, b] : edges.vertices)
    {
      if (a == v || b == v)
      {
        shortest = std::min(shortest,
          (mesh.points[static_cast<std::size_t>(a)] - mesh.points[static_cast<std::size_t>(b)])
            .norm());
      }
    }
    values[v] = solution.aligned[v];
    for (const LogSource& log : solution.logs)
    {
      const Point& point = mesh.points[static_cast<std::size_t>(v)];
      values[v] +=
        point == log.position ? log.strength * (std::log(0.5 * shortest) - 0.5) : log.Value(point);
    }
  }
}

/// Φ = R + logs at the vertices, area mean 0.
Eigen::VectorXd AssembleValues(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const TriangleMesh& mesh = potential.GetProblem().mesh;
  const auto count = static_cast<Eigen::Index>(mesh.points.size());
  Eigen::VectorXd values = solution.aligned.head(count);
  auto [integral, area] = Integrate(mesh, values);
  std::vector<std::array<Point, 2>> boundary;
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    boundary.push_back({ mesh.points[static_cast<std::size_t>(edge.vertices[0])],
      mesh.points[static_cast<std::size_t>(edge.vertices[1])] });
  }
  for (const LogSource& log : solution.logs)
  {
    integral += log.strength * LogIntegral(boundary, log.position);
  }
  for (Eigen::Index v = 0; v < count; ++v)
  {
    values[v] += SumOfLogs(solution.logs, mesh.points[static_cast<std::size_t>(v)]);
  }
  SetCores(mesh, potential.GetProblem().edges, solution, values);
  return values.array() - integral / area;
}

/// u from the conjugate of R, the turns of the corners' logarithms along the way, and the arguments
/// of the singularities as powers of unit complex numbers, which needs no branches.
ComplexVector AssembleField(
  const PointPotential& potential, const PointPotential::Solution& solution)
{
  const PerforatedProblem& problem = potential.GetProblem();
  const TriangleMesh& mesh = problem.mesh;
  const int first = problem.FirstOuterEdge();
  const Eigen::RowVectorXd phase =
    IntegrateConjugate(mesh, problem.edges, problem.potential->Gradient(solution.aligned),
      problem.edges.ofBoundary[static_cast<std::size_t>(first)], Eigen::VectorXd::Zero(1),
      potential.GetCorners());
  const std::size_t singularities = solution.logs.size() - potential.GetCorners().size();
  ComplexVector u(phase.size());
  for (Eigen::Index e = 0; e < phase.size(); ++e)
  {
    const auto& ends = problem.edges.vertices[static_cast<std::size_t>(e)];
    const Point middle = 0.5 *
      (mesh.points[static_cast<std::size_t>(ends[0])] +
        mesh.points[static_cast<std::size_t>(ends[1])]);
    u[e] = std::polar(1.0, phase[e]) * UnitOfTurns(solution.logs, singularities, middle);
  }
  const Complex start = u[problem.edges.ofBoundary[static_cast<std::size_t>(first)]];
  u *= problem.aligned[first] * std::polar(1.0, potential.GetMidpointShift()[first]) / start;
  return u;
}

/// Largest deviation on aligned edges from the phase that was prescribed there.
double Misalignment(const PointPotential& potential, const ComplexVector& u)
{
  const PerforatedProblem& problem = potential.GetProblem();
  double largest = 0.0;
  for (Eigen::Index i = 0; i < problem.aligned.size(); ++i)
  {
    const Complex wanted = problem.aligned[i] * std::polar(1.0, potential.GetMidpointShift()[i]);
    largest = std::max(
      largest, std::abs(u[problem.edges.ofBoundary[static_cast<std::size_t>(i)]] - wanted));
  }
  return largest;
}

/// Longest edge at each vertex.
std::vector<double> LongestEdges(const TriangleMesh& mesh, const EdgeNumbering& edges)
{
  std::vector<double> longest(mesh.points.size(), 0.0);
  for (const auto& ends : edges.vertices)
  {
    const double length = (mesh.points[static_cast<std::size_t>(ends[0])] -
      mesh.points[static_cast<std::size_t>(ends[1])])
                            .norm();
    for (int vertex : ends)
    {
      double& here = longest[static_cast<std::size_t>(vertex)];
      here = std::max(here, length);
    }
  }
  return longest;
}

/// Triangles and vertices with an index that belong to none of the singularities, and singularities
/// around which the indices do not add up to theirs. Corners and chosen vertices of the boundary may
/// take what they like.
int CountUnwanted(const TriangleMesh& mesh, const CrossField& field, const Configuration& wanted)
{
  std::vector<bool> marked(mesh.points.size(), false);
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    const auto vertex = static_cast<std::size_t>(edge.vertices[0]);
    marked[vertex] = std::any_of(field.count.corners.begin(), field.count.corners.end(),
      [&](const CountedCorner& corner) { return corner.position == mesh.points[vertex]; });
  }
  FieldIndices indices = ReadIndices(mesh, field.edges, field.u);
  MergeAtVertices(mesh, marked, indices);
  const std::vector<double> longest = LongestEdges(mesh, field.edges);
  std::vector<int> sums(wanted.size(), 0);
  int unwanted = 0;
  const auto assign = [&](const Point& place, double edge, int index)
  {
    // The index of one singularity shows in triangles and vertices next to it at the farthest.
    for (std::size_t i = 0; i < wanted.size(); ++i)
    {
      if ((wanted[i].position - place).norm() <= 2.0 * edge)
      {
        sums[i] += index;
        return;
      }
    }
    // A turn that is steep for the triangles of a chosen vertex shows next to it.
    unwanted += std::any_of(field.count.corners.begin(), field.count.corners.end(),
                  [&](const CountedCorner& corner)
                  { return corner.chosen && (corner.position - place).norm() <= 2.0 * edge; })
      ? 0
      : 1;
  };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (indices.ofTriangle[t] != 0)
    {
      Point centre = Point::Zero();
      double edge = 0.0;
      for (int vertex : mesh.triangles[t])
      {
        centre += mesh.points[static_cast<std::size_t>(vertex)] / 3.0;
        edge = std::max(edge, longest[static_cast<std::size_t>(vertex)]);
      }
      assign(centre, edge, indices.ofTriangle[t]);
    }
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if (indices.ofVertex[v] != 0 && !marked[v])
    {
      assign(mesh.points[v], longest[v], indices.ofVertex[v]);
    }
  }
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    unwanted += sums[i] != wanted[i].quarterIndex ? 1 : 0;
  }
  return unwanted;
}

/// H on a mesh whose singularities are holes: Φ of the unit-norm field.
HField SolveOnHoles(
  const TriangleMesh& mesh, const PlacedConfiguration& placed, const Progress& progress)
{
  HField result;
  CrossField& field = result.field;
  const PerforatedProblem problem(mesh, PotentialSolver::Periods::Islands, placed.corners);
  field.count = problem.count;
  field.edges = problem.edges;
  field.seconds.assemble = problem.assembleSeconds;
  field.seconds.factor = problem.factorSeconds;
  progress.Report(0.7);
  Stopwatch stopwatch;
  UnitNormField unit = SolveUnitNorm(problem);
  field.u = std::move(unit.u);
  field.energy = unit.energy;
  field.residual = unit.residual;
  field.holonomyDefect = unit.holonomyDefect;
  const auto count = static_cast<Eigen::Index>(mesh.points.size());
  result.h = 0.25 * unit.potential.head(count);
  const auto [integral, area] = Integrate(mesh, result.h);
  result.h.array() -= integral / area;
  for (Eigen::Index k = count; k < unit.potential.size(); ++k)
  {
    result.periods.push_back(0.25 * unit.potential[k]);
  }
  result.renormalizedEnergy = std::numeric_limits<double>::quiet_NaN();
  field.seconds.solve = stopwatch.Lap();
  progress.Report(0.9);
  ReadReport(mesh, problem.loops, field);
  return result;
}

HField SolveAtPoints(
  const TriangleMesh& mesh, const PlacedConfiguration& placed, const Progress& progress)
{
  HField result;
  CrossField& field = result.field;
  const PointPotential potential(mesh, placed.corners, TotalQuarters(placed.interior));
  const PerforatedProblem& problem = potential.GetProblem();
  field.count = problem.count;
  field.seconds.assemble = problem.assembleSeconds;
  field.seconds.factor = problem.factorSeconds;
  progress.Report(0.7);
  Stopwatch stopwatch;
  const PointPotential::Solution solution = potential.Solve(placed.interior);
  const RenormalizedEnergyValue energy = EvaluateRenormalizedEnergy(potential, solution);
  result.h = 0.25 * AssembleValues(potential, solution);
  field.u = AssembleField(potential, solution);
  field.residual = Misalignment(potential, field.u);
  problem.Align(field.u); // from the tangents of curves to the directions of edges
  field.seconds.solve = stopwatch.Lap();
  progress.Report(0.9);

  field.edges = problem.edges;
  field.holonomyDefect = solution.holonomyDefect;
  for (Eigen::Index k = 0; k < solution.periods.size(); ++k)
  {
    result.periods.push_back(0.25 * solution.periods[k]);
  }
  result.renormalizedEnergy = energy.energy;
  field.energy = energy.energy;
  const double radius = potential.GetDomain().Diagonal() / 40.0;
  for (std::size_t m = 0; m < solution.logs.size(); ++m)
  {
    const LogSource& log = solution.logs[m];
    const bool given = m < placed.interior.size() && placed.interior[m].radius > 0.0;
    field.energy += 0.5 * log.angle * log.strength * log.strength *
      std::log(1.0 / (given ? placed.interior[m].radius : radius));
  }
  ReadReport(mesh, problem.loops, field);
  field.unwantedSingularities = CountUnwanted(mesh, field, placed.interior);
  return result;
}

bool HasHoles(const std::vector<BoundaryLoop>& loops)
{
  return std::any_of(loops.begin(), loops.end(),
    [](const BoundaryLoop& loop) { return loop.kind == BoundaryKind::Hole; });
}

/// Throws unless the singularity lies in a hole of its quarter index.
void RequireHole(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops, const Singularity& singularity)
{
  for (const BoundaryLoop& loop : loops)
  {
    double winding = 0.0;
    for (int edge : loop.edges)
    {
      const auto& ends = mesh.boundary[static_cast<std::size_t>(edge)].vertices;
      winding += AngleBetween(mesh.points[static_cast<std::size_t>(ends[0])] - singularity.position,
        mesh.points[static_cast<std::size_t>(ends[1])] - singularity.position);
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
}

HField SolveHField(const TriangleMesh& mesh, const Configuration& configuration,
  const std::vector<CornerChoice>& corners, const Progress& progress)
{
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    if (!configuration[i].position.allFinite())
    {
      throw Error("Row " + std::to_string(i) +
        " of the singularities has a coordinate that is not a finite number; correct it.");
    }
  }
  const PlacedConfiguration placed = PlaceConfiguration(mesh, loops, configuration, corners);
  progress.Report(0.1);
  HField result;
  if (HasHoles(loops))
  {
    for (const Singularity& singularity : placed.interior)
    {
      RequireHole(mesh, loops, singularity);
    }
    result = SolveOnHoles(mesh, placed, progress);
  }
  else
  {
    result = SolveAtPoints(mesh, placed, progress);
  }
  // The cross is off the boundary's direction by a fraction of this; rounding only.
  result.field.converged = result.field.residual <= 1e-6;
  progress.Report(1.0);
  return result;
}
}
