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

constexpr double MinimumAngle = 8.0 * Pi / 180.0; // maps of thinner triangles fold

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
  constexpr double Rounding = 1e-9; // of a side: points of surfaces are merged up to that
  const Corners sides = CornersOf(this->Surface, point.triangle);
  const double same = Rounding * (sides[1] - sides[0]).norm();
  for (const int vertex : corners)
  {
    const bool isThere = distance(vertex) <= same;
    if (isThere || this->CanMove(vertex, point.place))
    {
      this->Surface.points[vertex] = isThere ? this->Surface.points[vertex] : point.place;
      this->IsFree[vertex] = false;
      return Placed{ vertex, 0.0 };
    }
  }
  const int added = this->Divide(point);
  if (added >= 0)
  {
    return Placed{ added, 0.0 };
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
  const std::vector<int>& around = this->TrianglesAt[vertex];
  return !this->IsSharp(vertex) &&
    std::all_of(around.begin(), around.end(),
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

bool VertexPlacement::IsSharp(int vertex) const
{
  // That of edges which other programs keep as well, 35°. Moving a vertex of a smooth surface changes its shape by as much as
  // triangles deviate from it; here it would cut off an edge.
  const double leastCosine = std::cos(35.0 * Pi / 180.0);
  const std::vector<int>& around = this->TrianglesAt[vertex];
  const SpacePoint first = NormalOf(CornersOf(this->Surface, around.front())).normalized();
  return std::any_of(around.begin(), around.end(),
    [&](int t)
    { return NormalOf(CornersOf(this->Surface, t)).normalized().dot(first) < leastCosine; });
}

int VertexPlacement::TriangleWith(int from, int to) const
{
  for (const int t : this->TrianglesAt[from])
  {
    const auto& v = this->Surface.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (v[i] == from && v[(i + 1) % 3] == to)
      {
        return t;
      }
    }
  }
  return -1;
}

VertexPlacement::Diagonal VertexPlacement::DiagonalAcross(
  int from, int to, const SpacePoint& place) const
{
  constexpr double Flat = 1e-9; // sine of the angle between planes: rounding
  Diagonal diagonal;
  diagonal.triangle = this->TriangleWith(to, from);
  if (diagonal.triangle < 0)
  {
    return diagonal;
  }
  for (const int corner : this->Surface.triangles[diagonal.triangle])
  {
    diagonal.beyond = corner != from && corner != to ? corner : diagonal.beyond;
  }
  const SpacePoint& start = this->Surface.points[from];
  const SpacePoint& end = this->Surface.points[to];
  const SpacePoint& beyond = this->Surface.points[diagonal.beyond];
  const Corners first = { place, start, beyond };
  const Corners second = { place, beyond, end };
  const SpacePoint normal = NormalOf({ start, end, place }).normalized();
  const SpacePoint other = NormalOf({ end, start, beyond }).normalized();
  if (normal.cross(other).norm() <= Flat && NormalOf(first).dot(normal) > 0.0 &&
    NormalOf(second).dot(normal) > 0.0)
  {
    diagonal.angle = std::min(SmallestAngle(first), SmallestAngle(second));
  }
  return diagonal;
}

int VertexPlacement::Divide(const SurfacePoint& point)
{
  const std::array<int, 3> v = this->Surface.triangles[point.triangle];
  const Corners corners = CornersOf(this->Surface, point.triangle);
  std::array<Diagonal, 3> diagonals;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t j = (i + 1) % 3;
    diagonals[i] = this->DiagonalAcross(v[i], v[j], point.place);
    const double angle = SmallestAngle({ corners[i], corners[j], point.place });
    if (!(std::max(angle, diagonals[i].angle) >= MinimumAngle))
    {
      return -1;
    }
    if (diagonals[i].angle <= angle)
    {
      diagonals[i].triangle = -1;
    }
  }
  const auto added = static_cast<int>(this->Surface.points.size());
  this->Surface.points.push_back(point.place);
  this->TrianglesAt.emplace_back();
  this->IsFree.push_back(false);
  for (std::size_t i = 0; i < 3; ++i)
  {
    const int from = v[i];
    const int to = v[(i + 1) % 3];
    const int own = i == 0 ? point.triangle : static_cast<int>(this->Surface.triangles.size());
    if (i > 0)
    {
      this->Surface.triangles.push_back({ -1, -1, -1 });
    }
    const Diagonal& diagonal = diagonals[i];
    if (diagonal.triangle < 0)
    {
      this->Set(own, { from, to, added });
      continue;
    }
    this->Set(own, { from, diagonal.beyond, added });
    this->Set(diagonal.triangle, { diagonal.beyond, to, added });
  }
  return added;
}

void VertexPlacement::Set(int triangle, const std::array<int, 3>& vertices)
{
  std::array<int, 3>& own = this->Surface.triangles[triangle];
  for (const int vertex : own)
  {
    if (vertex >= 0)
    {
      std::vector<int>& around = this->TrianglesAt[vertex];
      around.erase(std::find(around.begin(), around.end(), triangle));
    }
  }
  own = vertices;
  for (const int vertex : vertices)
  {
    this->TrianglesAt[vertex].push_back(triangle);
  }
}
}
