#include "QuadsOnSurface.h"

#include "Error.h"
#include "FeatureEdges.h"
#include "Index.h"
#include "SurfaceParts.h"
#include "VertexPlacement.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
SurfaceMesh OnlyPart(const SurfaceMesh& surface)
{
  SurfaceParts found = FindSurfaceParts(surface);
  if (found.parts.size() != 1)
  {
    throw Error("The surface has " + std::to_string(found.parts.size()) +
      " parts; give one of them (filter Connectivity).");
  }
  return std::move(found.parts.front());
}
}

QuadsOnSurface::QuadsOnSurface(const SurfaceMesh& surface, const std::vector<SpacePoint>& points,
  const std::vector<std::array<int, 4>>& quads)
  : Surface(OnlyPart(surface))
  , Topology(this->Surface)
  , Paths(this->Topology)
  , Triangles(points.size(), -1)
{
  std::vector<std::vector<int>> neighbours(points.size());
  for (const std::array<int, 4>& quad : quads)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      neighbours[quad[i]].push_back(quad[(i + 1) % 4]);
      neighbours[quad[(i + 1) % 4]].push_back(quad[i]);
    }
  }
  for (int seed = 0; seed < static_cast<int>(points.size()); ++seed)
  {
    if (neighbours[seed].empty() || this->Triangles[seed] >= 0)
    {
      continue;
    }
    this->Triangles[seed] = FindNearest(this->Surface, points[seed]).triangle;
    std::vector<int> reached = { seed };
    for (std::size_t next = 0; next < reached.size(); ++next)
    {
      const int from = reached[next];
      for (const int p : neighbours[from])
      {
        if (this->Triangles[p] >= 0)
        {
          continue;
        }
        const MeshPlace near = this->Paths.Find(this->Triangles[from], points[p]);
        // A walk that ends at a hole of the surface or a sharp edge has not arrived; points are beside the surface by
        // less than this part of an edge.
        constexpr double Beside = 0.25;
        const bool hasArrived = (this->Paths.PlaceOf(near) - points[p]).norm() <
          Beside * (points[p] - points[from]).norm();
        this->Triangles[p] =
          hasArrived ? near.triangle : FindNearest(this->Surface, points[p]).triangle;
        reached.push_back(p);
      }
    }
  }
}

SpacePoint QuadsOnSurface::NearestTo(const SpacePoint& place, int point) const
{
  return this->Paths.PlaceOf(this->Paths.Find(this->Triangles[point], place));
}

SpacePoint QuadsOnSurface::NearestOnBoundary(const SpacePoint& place) const
{
  SpacePoint nearest = place;
  double smallest = std::numeric_limits<double>::infinity();
  for (const BoundaryEdge& edge : this->Topology.mesh.boundary)
  {
    const SpacePoint from = this->Topology.PositionOf(edge.vertices[0]);
    const SpacePoint here = NearestOnSide(from, this->Topology.PositionOf(edge.vertices[1]), place);
    if ((here - place).squaredNorm() < smallest)
    {
      smallest = (here - place).squaredNorm();
      nearest = here;
    }
  }
  return nearest;
}

bool QuadsOnSurface::IsOnBoundary(const SpacePoint& place, double distance) const
{
  return !this->Topology.mesh.boundary.empty() &&
    (this->NearestOnBoundary(place) - place).norm() <= distance;
}

std::vector<std::array<SpacePoint, 2>> QuadsOnSurface::FindLines(double featureAngle) const
{
  std::vector<std::array<SpacePoint, 2>> lines;
  for (const BoundaryEdge& edge : this->Topology.mesh.boundary)
  {
    lines.push_back(
      { this->Topology.PositionOf(edge.vertices[0]), this->Topology.PositionOf(edge.vertices[1]) });
  }
  const FeatureEdges features = FindFeatureEdges(this->Surface, featureAngle);
  for (std::size_t t = 0; t < features.isFeature.size(); ++t)
  {
    const std::array<int, 3>& v = this->Surface.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      if (features.isFeature[t][i] && v[i] < v[(i + 1) % 3]) // once
      {
        lines.push_back(
          { this->Surface.points[Index(v[i])], this->Surface.points[Index(v[(i + 1) % 3])] });
      }
    }
  }
  return lines;
}
}
