#include "StageBoundary.h"

#include <algorithm>

namespace crossfield
{
double CornerCoefficient(const Corner& corner, int quarters)
{
  const double jump = 4.0 * (corner.Turning() - quarters * 0.5 * Pi);
  return jump * jump / (2.0 * corner.angle);
}

BoundaryVertices::BoundaryVertices(const OptimizerStage& stage)
  : reach(BoundaryReach * stage.objective->LengthUnit())
{
  const MeshTopology& topology = stage.potential->GetProblem().Topology();
  const Alignment& alignment = stage.potential->GetProblem().alignment;
  const std::vector<Loop> loops = topology.AlignedLoops();
  for (std::size_t loop = 0; loop < loops.size(); ++loop)
  {
    const std::size_t first = this->vertices.size();
    const std::size_t count = loops[loop].size();
    for (std::size_t vertex = 0; vertex < loops[loop].size(); ++vertex)
    {
      const Corner corner = MakeCorner(loops, loop, vertex);
      const auto chosen = alignment.chosenQuarters.find(topology.VertexOf(corner));
      this->vertices.push_back(corner);
      this->next.push_back(first + (vertex + 1) % count);
      this->previous.push_back(first + (vertex + count - 1) % count);
      this->quarters.push_back(chosen != alignment.chosenQuarters.end()
          ? chosen->second
          : SmallestRotationIndex(corner.Turning()));
    }
  }
}

std::size_t BoundaryVertices::At(const Point& position) const
{
  return static_cast<std::size_t>(
    std::find_if(this->vertices.begin(), this->vertices.end(),
      [&](const Corner& vertex) { return (vertex.position - position).norm() <= this->reach; }) -
    this->vertices.begin());
}

double BoundaryVertices::LoopLength(std::size_t vertex) const
{
  double length = 0.0;
  std::size_t v = vertex;
  do
  {
    length += (this->vertices[this->next[v]].position - this->vertices[v].position).norm();
    v = this->next[v];
  } while (v != vertex);
  return length;
}

bool BoundaryVertices::IsSmooth(const Point& position) const
{
  return std::any_of(this->vertices.begin(), this->vertices.end(),
    [&](const Corner& vertex)
    {
      return (vertex.position - position).norm() <= this->reach &&
        SmallestRotationIndex(vertex.Turning()) == 0;
    });
}

std::size_t RowAt(const Configuration& configuration, const Point& position, double reach)
{
  return static_cast<std::size_t>(
    std::find_if(configuration.begin(), configuration.end(),
      [&](const Singularity& other) { return (other.position - position).norm() <= reach; }) -
    configuration.begin());
}

TrackedConfiguration MovedToVertex(
  TrackedConfiguration tracked, std::size_t row, const BoundaryVertices& boundary, std::size_t v)
{
  const Point& position = boundary.vertices[v].position;
  const int sum = boundary.quarters[v] + tracked.singularities[row].quarterIndex;
  const std::size_t present = RowAt(tracked.singularities, position, boundary.reach);
  if (present < tracked.singularities.size())
  {
    tracked.singularities[present].quarterIndex = sum;
    tracked.Erase(row);
  }
  else
  {
    tracked.singularities[row].position = position;
    tracked.singularities[row].quarterIndex = sum;
  }
  return tracked;
}

std::size_t NearestVertex(const BoundaryVertices& boundary, const Point& position)
{
  std::size_t nearest = 0;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    if ((boundary.vertices[v].position - position).squaredNorm() <
      (boundary.vertices[nearest].position - position).squaredNorm())
    {
      nearest = v;
    }
  }
  return nearest;
}

double ClearanceRange(const OptimizerStage& stage, double clearances)
{
  const double clearance = stage.objective->Clearance() * stage.objective->LengthUnit();
  return std::max(
    2.0 * clearance, clearances * std::min(clearance, CoreRadius(stage.potential->GetDomain())));
}

double VertexReach(const OptimizerStage& stage)
{
  return ClearanceRange(stage, 6.0);
}
}
