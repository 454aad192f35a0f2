#include "SurfaceTargets.h"

#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Returns the place of a point of the map in a triangle.
SpacePoint PlaceAt(const SeamlessMap& map, int triangle, const Point& point)
{
  const auto& v = map.topology->mesh.triangles[Index(triangle)];
  SpacePoint place = SpacePoint::Zero();
  double sum = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    const double weight =
      Cross(map.At(triangle, (i + 1) % 3) - point, map.At(triangle, (i + 2) % 3) - point);
    place += weight * map.topology->PositionOf(v[Index(i)]);
    sum += weight;
  }
  return place / sum;
}
}

double NearTarget::At(double distance, double growth) const
{
  return distance > this->reach
    ? std::numeric_limits<double>::infinity()
    : this->near.size + growth * std::max(0.0, distance - this->near.radius);
}

double SurfaceTargets::At(const MeshTopology& topology, int triangle, const SpacePoint& place) const
{
  // In the plane of the triangle: weights of its corners are areas.
  const auto& v = topology.mesh.triangles[Index(triangle)];
  const SpacePoint normal = topology.NormalOf(triangle);
  double size = 0.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const SpacePoint a = topology.PositionOf(v[(i + 1) % 3]) - place;
    const SpacePoint b = topology.PositionOf(v[(i + 2) % 3]) - place;
    const double weight = std::max(0.0, a.cross(b).dot(normal));
    size += weight * this->sizes[v[i]];
    sum += weight;
  }
  size /= sum;
  for (const NearTarget& one : this->near)
  {
    size = std::min(size, one.At((place - one.near.place).norm(), this->growth));
  }
  return size;
}

double SurfaceTargets::CountOn(const MeshTopology& topology) const
{
  double count = 0.0;
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const double part = topology.AreaOf(t) / 3.0;
    for (const int vertex : topology.mesh.triangles[Index(t)])
    {
      count += part / (this->sizes[vertex] * this->sizes[vertex]);
    }
  }
  return count;
}

std::vector<double> TargetLengths(
  const SeamlessMap& map, const TMesh& mesh, const SurfaceTargets& targets)
{
  const MeshTopology& topology = *map.topology;
  std::vector<double> lengths;
  for (const TArc& arc : mesh.arcs)
  {
    double length = 0.0;
    for (const ChartPiece& piece : arc.pieces)
    {
      // Pieces are within triangles, so the midpoint rule is accurate enough.
      const SpacePoint from = PlaceAt(map, piece.triangle, piece.from);
      const SpacePoint to = PlaceAt(map, piece.triangle, piece.to);
      length += (to - from).norm() / targets.At(topology, piece.triangle, 0.5 * (from + to));
    }
    lengths.push_back(length);
  }
  return lengths;
}
}
