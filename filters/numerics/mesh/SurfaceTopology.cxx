#include "SurfaceTopology.h"

#include "BoundaryCorners.h"
#include "Error.h"
#include "SurfaceParts.h"
#include "UnionFind.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Marks the boundary edges of a surface, and refuses what is not a manifold.
class BoundarySearch
{
public:
  explicit BoundarySearch(const SurfaceMesh& surface)
    : Surface(surface)
    , Next(surface.points.size(), -1)
  {
    this->RequireAreas();
    this->VisitSides();
  }

  TriangleMesh MakeMesh() const
  {
    TriangleMesh mesh;
    // There is no common frame, so a use of these coordinates must not go unnoticed.
    mesh.points.assign(
      this->Surface.points.size(), Point::Constant(std::numeric_limits<double>::quiet_NaN()));
    mesh.triangles = this->Surface.triangles;
    int id = 0;
    for (const std::vector<int>& loop : this->FindLoops())
    {
      const BoundaryKind kind = id == 0 ? BoundaryKind::Outer : BoundaryKind::Inner;
      for (const int from : loop)
      {
        mesh.boundary.push_back({ { from, this->Next[from] }, kind, id, 0 });
      }
      ++id;
    }
    return mesh;
  }

private:
  std::string PlaceOf(int vertex) const { return DescribeInSpace(this->Surface.points[vertex]); }

  void RequireAreas() const
  {
    for (const auto& v : this->Surface.triangles)
    {
      if (IsFlat(this->Surface, v))
      {
        throw Error("The triangle at " + this->PlaceOf(v[0]) + " has no area; remove it.");
      }
    }
  }

  /// Finds the next vertex of those on the boundary. Refuses neighbours of opposite orientation, and joins the
  /// others and their corners.
  void VisitSides()
  {
    const auto& triangles = this->Surface.triangles;
    const std::vector<std::array<int, 3>> neighbours = FindNeighbours(this->Surface);
    UnionFind parts(triangles.size());
    UnionFind corners(3 * triangles.size()); // 3 t + i
    for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
    {
      for (int i = 0; i < 3; ++i)
      {
        const int from = triangles[t][i];
        const int to = triangles[t][(i + 1) % 3];
        const int other = neighbours[t][i];
        if (other < 0)
        {
          this->Next[from] = to;
          continue;
        }
        const auto& v = triangles[other];
        const auto back = static_cast<int>(std::find(v.begin(), v.end(), to) - v.begin());
        if (v[(back + 1) % 3] != from)
        {
          throw Error("The edge from " + this->PlaceOf(from) + " to " + this->PlaceOf(to) +
            " has triangles of opposite orientation; orient the surface consistently.");
        }
        parts.Join(t, other);
        corners.Join(3 * t + i, 3 * other + (back + 1) % 3);
        corners.Join(3 * t + (i + 1) % 3, 3 * other + back);
      }
    }
    this->RequireFans(corners);
    this->RequireOnePart(parts);
  }

  /// Refuses points in no triangle or in several fans of triangles.
  void RequireFans(UnionFind& corners) const
  {
    std::vector<int> fan(this->Surface.points.size(), -1);
    for (int c = 0; c < 3 * static_cast<int>(this->Surface.triangles.size()); ++c)
    {
      const int vertex = this->Surface.triangles[c / 3][c % 3];
      const int own = corners.Find(c);
      if (fan[vertex] >= 0 && fan[vertex] != own)
      {
        throw Error("Parts of the surface meet only in the point " + this->PlaceOf(vertex) +
          "; give each a point of its own there.");
      }
      fan[vertex] = own;
    }
    const auto unused = std::find(fan.begin(), fan.end(), -1);
    if (unused != fan.end())
    {
      throw Error("The point " + this->PlaceOf(static_cast<int>(unused - fan.begin())) +
        " is in no triangle; remove it.");
    }
  }

  void RequireOnePart(UnionFind& parts) const
  {
    for (int t = 0; t < static_cast<int>(this->Surface.triangles.size()); ++t)
    {
      if (parts.Find(t) != parts.Find(0))
      {
        throw Error("The surface is not connected: a part of it is at " +
          this->PlaceOf(this->Surface.triangles[t][0]) + "; give its parts one by one.");
      }
    }
  }

  /// Returns the vertices of the boundary loops, the longest first.
  std::vector<std::vector<int>> FindLoops() const
  {
    std::vector<std::pair<double, std::vector<int>>> loops;
    std::vector<bool> isVisited(this->Next.size(), false);
    for (int first = 0; first < static_cast<int>(this->Next.size()); ++first)
    {
      if (this->Next[first] < 0 || isVisited[first])
      {
        continue;
      }
      loops.emplace_back();
      for (int vertex = first; !isVisited[vertex]; vertex = this->Next[vertex])
      {
        isVisited[vertex] = true;
        loops.back().second.push_back(vertex);
        loops.back().first +=
          (this->Surface.points[this->Next[vertex]] - this->Surface.points[vertex]).norm();
      }
    }
    std::stable_sort(
      loops.begin(), loops.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    std::vector<std::vector<int>> sorted;
    for (auto& [length, loop] : loops)
    {
      sorted.push_back(std::move(loop));
    }
    return sorted;
  }

  const SurfaceMesh& Surface;
  std::vector<int> Next; ///< Per vertex on the boundary, the next one with the surface on the left.
};

/// Returns the places of the corners of a triangle in a chart: the first is the origin, and the second is
/// on the first axis.
std::array<Point, 3> UnfoldTriangle(const SurfaceMesh& surface, const std::array<int, 3>& triangle)
{
  const SpacePoint a = surface.points[triangle[1]] - surface.points[triangle[0]];
  const SpacePoint b = surface.points[triangle[2]] - surface.points[triangle[0]];
  const double length = a.norm();
  return { Point(0.0, 0.0), Point(length, 0.0),
    Point(a.dot(b) / length, a.cross(b).norm() / length) };
}
}

SurfaceTopology::SurfaceTopology(SurfaceMesh surface)
  : MeshTopology(BoundarySearch(surface).MakeMesh())
{
  this->charts.emplace();
  for (const auto& triangle : this->mesh.triangles)
  {
    this->charts->corners.push_back(UnfoldTriangle(surface, triangle));
  }
  this->charts->positions = std::move(surface.points);

  this->charts->hinges.assign(this->mesh.triangles.size(), { 0.0, 0.0, 0.0 });
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(this->VertexCount());
  for (int t = 0; t < this->TriangleCount(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Point& corner = this->At(t, i);
      angles[this->mesh.triangles[t][i]] +=
        AngleBetween(this->At(t, (i + 1) % 3) - corner, this->At(t, (i + 2) % 3) - corner);
      const int neighbour = this->Neighbour(t, i);
      if (neighbour >= 0)
      {
        // Both triangles pass their edge, in opposite directions.
        const int back = this->SideOf(neighbour, this->EdgeOf(t, i));
        this->charts->hinges[t][i] =
          WrapAngle(this->DirectionOf(neighbour, back) + Pi - this->DirectionOf(t, i));
      }
    }
  }
  this->charts->curvature = (2.0 * Pi - angles.array()).matrix();
  for (int i = 0; i < static_cast<int>(this->turning.size()); ++i)
  {
    const int vertex = this->BoundaryAt(i).vertices[0];
    this->turning[i] = Pi - angles[vertex];
    this->corners[vertex] = IsCorner(this->turning[i]);
    this->charts->curvature[vertex] = 0.0;
  }
}
}
