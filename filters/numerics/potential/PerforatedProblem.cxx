#include "PerforatedProblem.h"

#include "Stopwatch.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
bool IsAligned(const BoundaryEdge& edge)
{
  return edge.kind == BoundaryKind::Outer || edge.kind == BoundaryKind::Inner;
}

/// The chosen quarter indices by vertex of the mesh.
std::map<int, int> ChosenByVertex(
  const TriangleMesh& mesh, const std::vector<CornerChoice>& corners)
{
  std::vector<int> vertices;
  std::vector<Point> points;
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    if (IsAligned(edge))
    {
      vertices.push_back(edge.vertices[0]);
      points.push_back(mesh.points[static_cast<std::size_t>(edge.vertices[0])]);
    }
  }
  std::map<int, int> chosen;
  const std::vector<std::size_t> matches = MatchChoices(points, corners);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    chosen[vertices[matches[i]]] = corners[i].quarterIndex;
  }
  return chosen;
}
}

PerforatedProblem::PerforatedProblem(const TriangleMesh& drilled, PotentialSolver::Periods periods,
  const std::vector<CornerChoice>& chosenCorners, int pointQuarters, const Progress& progress)
  : mesh(drilled)
  , corners(chosenCorners)
{
  Stopwatch stopwatch;
  this->loops = FindBoundaryLoops(drilled);
  this->count = CountMeshQuarters(drilled, this->loops, corners);
  this->count.givenInteriorQuarters += pointQuarters;
  this->chosenQuarters = ChosenByVertex(drilled, corners);
  RequireConsistent(this->count);
  this->edges = NumberEdges(drilled);
  this->aligned = ComplexVector::Zero(static_cast<Eigen::Index>(drilled.boundary.size()));
  for (std::size_t i = 0; i < drilled.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = drilled.boundary[i];
    if (IsAligned(edge))
    {
      this->aligned[static_cast<Eigen::Index>(i)] =
        AlignedRepresentation(drilled.points[static_cast<std::size_t>(edge.vertices[1])] -
          drilled.points[static_cast<std::size_t>(edge.vertices[0])]);
    }
  }
  this->assembleSeconds = stopwatch.Lap();
  progress.Report(0.1);
  this->potential = std::make_unique<PotentialSolver>(drilled, this->edges, this->loops, periods,
    PotentialSolver::Boundary::Natural, progress.Part(0.1, 1.0));
  this->factorSeconds = stopwatch.Lap();
}

Eigen::Index PerforatedProblem::IslandCount() const
{
  return std::count_if(this->loops.begin(), this->loops.end(),
    [](const BoundaryLoop& loop) { return loop.kind == BoundaryKind::Inner; });
}

std::vector<int> PerforatedProblem::PreviousBoundaryEdges() const
{
  std::vector<int> ending(this->mesh.points.size(), -1);
  for (std::size_t i = 0; i < this->mesh.boundary.size(); ++i)
  {
    ending[static_cast<std::size_t>(this->mesh.boundary[i].vertices[1])] = static_cast<int>(i);
  }
  std::vector<int> previous;
  for (const BoundaryEdge& edge : this->mesh.boundary)
  {
    previous.push_back(ending[static_cast<std::size_t>(edge.vertices[0])]);
  }
  return previous;
}

int PerforatedProblem::FirstOuterEdge() const
{
  const auto outer = std::find_if(this->loops.begin(), this->loops.end(),
    [](const BoundaryLoop& loop) { return loop.kind == BoundaryKind::Outer; });
  return outer->edges.front();
}

double PerforatedProblem::Align(ComplexVector& u) const
{
  double change = 0.0;
  for (std::size_t i = 0; i < this->mesh.boundary.size(); ++i)
  {
    if (IsAligned(this->mesh.boundary[i]))
    {
      Complex& value = u[this->edges.ofBoundary[i]];
      const Complex wanted = this->aligned[static_cast<Eigen::Index>(i)];
      change = std::max(change, std::abs(value - wanted));
      value = wanted;
    }
  }
  return change;
}
}
