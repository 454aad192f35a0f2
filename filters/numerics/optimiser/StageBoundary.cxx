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
    for (std::size_t vertex = 0; vertex < loops[loop].size(); ++vertex)
    {
      const Corner corner = MakeCorner(loops, loop, vertex);
      const auto chosen = alignment.chosenQuarters.find(topology.VertexOf(corner));
      this->vertices.push_back(corner);
      this->quarters.push_back(chosen != alignment.chosenQuarters.end()
          ? chosen->second
          : SmallestRotationIndex(corner.Turning()));
    }
  }
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

std::size_t RowAt(const OptimizerStage& stage, const Point& position)
{
  const Configuration& all = stage.tracked.singularities;
  const double reach = BoundaryReach * stage.objective->LengthUnit();
  return static_cast<std::size_t>(
    std::find_if(all.begin(), all.end(),
      [&](const Singularity& other) { return (other.position - position).norm() <= reach; }) -
    all.begin());
}

TrackedConfiguration MovedToVertex(const OptimizerStage& stage, TrackedConfiguration tracked,
  std::size_t row, const BoundaryVertices& boundary, std::size_t v)
{
  const Point& position = boundary.vertices[v].position;
  const int sum = boundary.quarters[v] + tracked.singularities[row].quarterIndex;
  const std::size_t present = RowAt(stage, position);
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
}
