#include "BoundaryCurves.h"

#include "Segment.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}
}

BoundaryCurves::BoundaryCurves(const MeshTopology& topology)
  : Topology(topology)
  , LoopAndEdge(topology.mesh.boundary.size(), { -1, 0 })
{
  std::vector<int> positionAt(topology.mesh.points.size(), -1);
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    positionAt[Index(topology.mesh.boundary[i].vertices[0])] = static_cast<int>(i);
  }
  for (const std::vector<int>& vertices : topology.alignedVertices)
  {
    std::vector<double> starts = { 0.0 };
    std::vector<int> positions;
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const int position = positionAt[Index(vertices[i])];
      this->LoopAndEdge[Index(position)] = { static_cast<int>(this->Starts.size()), i };
      positions.push_back(position);
      starts.push_back(starts.back() +
        (topology.PointAt(vertices[(i + 1) % vertices.size()]) - topology.PointAt(vertices[i]))
          .norm());
    }
    this->Starts.push_back(std::move(starts));
    this->Positions.push_back(std::move(positions));
  }
}

CurvePlace BoundaryCurves::Place(int boundaryPosition, double fraction) const
{
  const auto& [loop, edge] = this->LoopAndEdge[Index(boundaryPosition)];
  const std::vector<double>& starts = this->Starts[Index(loop)];
  return { loop, starts[edge] + fraction * (starts[edge + 1] - starts[edge]) };
}

std::pair<std::size_t, double> BoundaryCurves::EdgeAt(const CurvePlace& place) const
{
  const std::vector<double>& starts = this->Starts[Index(place.loop)];
  double at = std::fmod(place.at, starts.back());
  at = at < 0.0 ? at + starts.back() : at;
  const auto after = std::upper_bound(starts.begin(), starts.end(), at);
  const auto edge =
    std::min(static_cast<std::size_t>(after - starts.begin()) - 1, starts.size() - 2);
  return { edge, std::min(1.0, (at - starts[edge]) / (starts[edge + 1] - starts[edge])) };
}

Point BoundaryCurves::At(const CurvePlace& place) const
{
  const auto [edge, fraction] = this->EdgeAt(place);
  const std::vector<int>& vertices = this->Topology.alignedVertices[Index(place.loop)];
  const Point& from = this->Topology.PointAt(vertices[edge]);
  const Point& to = this->Topology.PointAt(vertices[(edge + 1) % vertices.size()]);
  return from + fraction * (to - from);
}

CurvePlace BoundaryCurves::Nearest(int loop, const Point& point) const
{
  const std::vector<double>& starts = this->Starts[Index(loop)];
  const std::vector<int>& vertices = this->Topology.alignedVertices[Index(loop)];
  // Rounding of a distance between points of the domain.
  const double rounding = 1e-13 * starts.back();
  CurvePlace nearest = { loop, 0.0 };
  double least = std::numeric_limits<double>::infinity();
  std::size_t best = 0;
  for (std::size_t edge = 0; edge < vertices.size(); ++edge)
  {
    const Point& from = this->Topology.PointAt(vertices[edge]);
    const Point& to = this->Topology.PointAt(vertices[(edge + 1) % vertices.size()]);
    const double distance = WayFromSegment(point, from, to).norm();
    const bool next = edge == best + 1 || (best == 0 && edge + 1 == vertices.size());
    if (std::abs(distance - least) <= rounding && next)
    {
      nearest.at = edge == best + 1 ? starts[edge] : 0.0;
    }
    else if (distance < least)
    {
      least = distance;
      best = edge;
      nearest.at =
        starts[edge] + NearestFraction(point, from, to) * (starts[edge + 1] - starts[edge]);
    }
  }
  return nearest;
}

Point BoundaryCurves::Tangent(const CurvePlace& place) const
{
  const std::size_t edge = this->EdgeAt(place).first;
  const std::vector<int>& vertices = this->Topology.alignedVertices[Index(place.loop)];
  return (this->Topology.PointAt(vertices[(edge + 1) % vertices.size()]) -
    this->Topology.PointAt(vertices[edge]))
    .normalized();
}

std::vector<CurvePlace> BoundaryCurves::Corners() const
{
  std::vector<CurvePlace> places;
  for (std::size_t l = 0; l < this->Starts.size(); ++l)
  {
    const std::vector<int>& vertices = this->Topology.alignedVertices[l];
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      if (this->Topology.corners[Index(vertices[i])])
      {
        places.push_back({ static_cast<int>(l), this->Starts[l][i] });
      }
    }
  }
  return places;
}

int BoundaryCurves::PositionAt(const CurvePlace& place) const
{
  return this->Positions[Index(place.loop)][this->EdgeAt(place).first];
}
}
