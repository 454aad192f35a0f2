#include "StageBoundary.h"

#include <algorithm>

namespace crossfield
{
double CornerCoefficient(const Corner& corner, int quarters)
{
  const double jump = 4.0 * (corner.Turning() - quarters * 0.5 * Pi);
  return jump * jump / (2.0 * corner.angle);
}

double CornerQuality(double angle, int quarters)
{
  return quarters < 2 ? std::max(0.0, std::sin(std::min(Pi, angle / (2 - quarters)))) : 0.0;
}

double QuadSizeAt(double quadSize, double loopLength)
{
  constexpr double LoopFraction = 0.125;
  return std::min(quadSize, LoopFraction * loopLength);
}

BoundaryVertices::BoundaryVertices(const OptimizerStage& stage)
  : reach(BoundaryReach * stage.objective->LengthUnit())
  , quadSize(stage.quadSize)
{
  const PlanarTopology& topology = stage.potential->GetProblem().Topology();
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
    this->loopLengths.push_back(count == 0 ? 0.0 : this->LoopLength(first));
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

double BoundaryVertices::AngleForQuads(std::size_t vertex, std::size_t ignored) const
{
  // Quads at a point with an index are smaller than others, and those between two such points are
  // smaller than their distance.
  constexpr double IndexFraction = 0.25;
  const double own = PartSeen * this->QuadRange(vertex);
  const double range =
    std::min(own, IndexFraction * this->DistanceToIndex(vertex, ignored, own / IndexFraction));
  const Corner& corner = this->vertices[vertex];
  const auto away = [&](const std::vector<std::size_t>& neighbours)
  {
    double remaining = range;
    Point point = corner.position;
    for (std::size_t v = neighbours[vertex]; v != vertex; v = neighbours[v])
    {
      const Point edge = this->vertices[v].position - point;
      if (edge.norm() >= remaining)
      {
        return Point(point + remaining / edge.norm() * edge - corner.position);
      }
      remaining -= edge.norm();
      point = this->vertices[v].position;
    }
    return Point(point - corner.position);
  };
  double angle = AngleBetween(away(this->next), away(this->previous));
  // The angle is known up to 2π; it differs from that of the vertex by less than π.
  angle += angle < corner.angle - Pi ? 2.0 * Pi : 0.0;
  return std::max(angle, 0.0);
}

bool BoundaryVertices::Allows(std::size_t vertex, int index, std::size_t ignored) const
{
  constexpr double SufficientQuality = 0.5; // quads have at least 0.3 if the angle is inexact
  const double spacing = this->QuadRange(vertex);
  if (this->quarters[vertex] == 0 && index > 0 &&
    this->DistanceToIndex(vertex, ignored, spacing) < spacing)
  {
    return false;
  }
  const double angle = this->AngleForQuads(vertex, ignored);
  double best = 0.0;
  for (int other = 1; other >= -3; --other) // down to five quads
  {
    best = std::max(best, CornerQuality(angle, other));
  }
  return CornerQuality(angle, index) >= std::min(SufficientQuality, best);
}

double BoundaryVertices::QuadRange(std::size_t vertex) const
{
  return QuadSizeAt(this->quadSize, this->loopLengths[this->vertices[vertex].loop]);
}

double BoundaryVertices::DistanceToIndex(
  std::size_t vertex, std::size_t ignored, double range) const
{
  double nearest = range;
  for (const std::vector<std::size_t>* neighbours : { &this->next, &this->previous })
  {
    double length = 0.0;
    for (std::size_t v = vertex; length < nearest;)
    {
      const std::size_t following = (*neighbours)[v];
      length += (this->vertices[following].position - this->vertices[v].position).norm();
      v = following;
      if (v == vertex)
      {
        break;
      }
      if (this->quarters[v] != 0 && v != ignored)
      {
        nearest = std::min(nearest, length);
      }
    }
  }
  return nearest;
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

std::size_t NearestAllowedVertex(
  const BoundaryVertices& boundary, const Point& position, double distance, int quarters)
{
  std::size_t nearest = boundary.vertices.size();
  double lowest = distance * distance;
  for (std::size_t v = 0; v < boundary.vertices.size(); ++v)
  {
    const double squared = (boundary.vertices[v].position - position).squaredNorm();
    if (squared <= lowest && boundary.Allows(v, boundary.quarters[v] + quarters))
    {
      lowest = squared;
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
