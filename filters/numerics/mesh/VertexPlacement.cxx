#include "VertexPlacement.h"

#include "SurfaceParts.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
SpacePoint NearestOnSide(const SpacePoint& from, const SpacePoint& to, const SpacePoint& place)
{
  const SpacePoint side = to - from;
  return from + std::clamp((place - from).dot(side) / side.squaredNorm(), 0.0, 1.0) * side;
}

namespace
{
using Corners = std::array<SpacePoint, 3>;

Corners CornersOf(const SurfaceMesh& surface, int triangle)
{
  const auto& v = surface.triangles[triangle];
  return { surface.points[v[0]], surface.points[v[1]], surface.points[v[2]] };
}

/// Returns the point of a triangle nearest to a place.
SpacePoint NearestIn(const Corners& corners, const SpacePoint& place)
{
  const SpacePoint normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]);
  bool isInside = true;
  for (std::size_t i = 0; i < 3; ++i)
  {
    isInside =
      isInside && normal.cross(corners[(i + 1) % 3] - corners[i]).dot(place - corners[i]) >= 0.0;
  }
  if (isInside)
  {
    return place - (place - corners[0]).dot(normal) / normal.squaredNorm() * normal;
  }
  SpacePoint nearest = corners[0];
  for (std::size_t i = 0; i < 3; ++i)
  {
    const SpacePoint here = NearestOnSide(corners[i], corners[(i + 1) % 3], place);
    if ((here - place).squaredNorm() < (nearest - place).squaredNorm())
    {
      nearest = here;
    }
  }
  return nearest;
}

/// Returns the smallest angle of a triangle, in radians.
double SmallestAngle(const Corners& corners)
{
  double smallest = Pi;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const SpacePoint next = corners[(i + 1) % 3] - corners[i];
    const SpacePoint last = corners[(i + 2) % 3] - corners[i];
    smallest = std::min(smallest, std::atan2(next.cross(last).norm(), next.dot(last)));
  }
  return smallest;
}

SpacePoint NormalOf(const Corners& corners)
{
  return (corners[1] - corners[0]).cross(corners[2] - corners[0]);
}
}

SurfacePoint FindNearest(const SurfaceMesh& surface, const SpacePoint& place)
{
  SurfacePoint nearest;
  nearest.distance = std::numeric_limits<double>::infinity();
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
  {
    const SpacePoint here = NearestIn(CornersOf(surface, t), place);
    const double distance = (here - place).norm();
    if (distance < nearest.distance)
    {
      nearest = { t, here, distance };
    }
  }
  return nearest;
}

VertexPlacement::VertexPlacement(SurfaceMesh& surface)
  : Surface(surface)
  , TrianglesAt(surface.points.size())
  , IsFree(surface.points.size(), true)
{
  const std::vector<std::array<int, 3>> neighbours = FindNeighbours(surface);
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
  {
    const auto& v = surface.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      this->TrianglesAt[v[i]].push_back(t);
      if (neighbours[t][i] < 0)
      {
        this->IsFree[v[i]] = false;
        this->IsFree[v[(i + 1) % 3]] = false;
      }
    }
  }
}

std::optional<VertexPlacement::Placed> VertexPlacement::Place(const SurfacePoint& point)
{
  std::vector<int> corners;
  for (const int vertex : this->Surface.triangles[point.triangle])
  {
    if (this->IsFree[vertex])
    {
      corners.push_back(vertex);
    }
  }
  const auto distance = [&](int vertex)
  { return (this->Surface.points[vertex] - point.place).norm(); };
  std::stable_sort(
    corners.begin(), corners.end(), [&](int a, int b) { return distance(a) < distance(b); });
  for (const int vertex : corners)
  {
    if (this->CanMove(vertex, point.place))
    {
      this->Surface.points[vertex] = point.place;
      this->IsFree[vertex] = false;
      return Placed{ vertex, 0.0 };
    }
  }
  if (corners.empty())
  {
    return std::nullopt;
  }
  this->IsFree[corners.front()] = false;
  return Placed{ corners.front(), distance(corners.front()) };
}

bool VertexPlacement::CanMove(int vertex, const SpacePoint& to) const
{
  constexpr double MinimumAngle = 8.0 * Pi / 180.0; // maps of thinner triangles fold
  const std::vector<int>& around = this->TrianglesAt[vertex];
  return std::all_of(around.begin(), around.end(),
    [&](int t)
    {
      const Corners before = CornersOf(this->Surface, t);
      Corners after = before;
      for (std::size_t i = 0; i < 3; ++i)
      {
        after[i] = this->Surface.triangles[t][i] == vertex ? to : before[i];
      }
      return NormalOf(before).dot(NormalOf(after)) > 0.0 &&
        SmallestAngle(after) >= std::min(MinimumAngle, SmallestAngle(before));
    });
}
}
