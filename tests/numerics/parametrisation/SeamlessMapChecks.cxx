#include "SeamlessMapChecks.h"

#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
double SeamDefect(const SeamlessMap& map)
{
  const MeshTopology& topology = *map.topology;
  double largest = 0.0;
  for (int t = 0; t < static_cast<int>(map.corners.size()); ++t)
  {
    for (int side = 0; side < 3; ++side)
    {
      const int edge =
        topology.edges.ofTriangle[static_cast<std::size_t>(t)][static_cast<std::size_t>(side)];
      const auto& two = topology.edges.triangles[static_cast<std::size_t>(edge)];
      const int other = two[0] == t ? two[1] : two[0];
      if (other < 0)
      {
        continue;
      }
      const SeamTransition across = map.Across(t, side);
      const auto& mine = topology.mesh.triangles[static_cast<std::size_t>(t)];
      const auto& theirs = topology.mesh.triangles[static_cast<std::size_t>(other)];
      for (const int corner : { side, (side + 1) % 3 })
      {
        const auto there =
          std::find(theirs.begin(), theirs.end(), mine[static_cast<std::size_t>(corner)]);
        const Point w = map.At(other, static_cast<int>(there - theirs.begin()));
        largest = std::max(largest, (across(map.At(t, corner)) - w).norm());
      }
    }
  }
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const int edge = topology.EdgeOfBoundary(static_cast<int>(i));
    const int t = topology.edges.triangles[static_cast<std::size_t>(edge)][0];
    const auto& v = topology.mesh.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](int end)
    {
      return static_cast<int>(std::find(v.begin(), v.end(),
                                topology.mesh.boundary[i].vertices[static_cast<std::size_t>(end)]) -
        v.begin());
    };
    const Point along = map.At(t, corner(1)) - map.At(t, corner(0));
    const Point turned = TurnByQuarters(along, -map.directions[i]);
    EXPECT_GT(turned.x(), 0.0);
    largest = std::max(largest, std::abs(turned.y()));
  }
  return largest / map.Extent();
}

double AngleSumDefect(const SeamlessMap& map)
{
  const TriangleMesh& mesh = map.topology->mesh;
  std::vector<double> defects(mesh.points.size(), 2.0 * Pi);
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    defects[static_cast<std::size_t>(edge.vertices[0])] = Pi;
  }
  for (const Cone& cone : map.cones)
  {
    defects[static_cast<std::size_t>(cone.vertex)] -= 0.5 * Pi * cone.quarterIndex;
  }
  for (int t = 0; t < static_cast<int>(map.corners.size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const Point& apex = map.At(t, i);
      const int vertex = mesh.triangles[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)];
      defects[static_cast<std::size_t>(vertex)] -=
        AngleBetween(map.At(t, (i + 1) % 3) - apex, map.At(t, (i + 2) % 3) - apex);
    }
  }
  double largest = 0.0;
  for (const double defect : defects)
  {
    largest = std::max(largest, std::abs(defect));
  }
  return largest;
}

double ShortestEdge(const SeamlessMap& map)
{
  double shortest = map.Extent();
  for (int t = 0; t < static_cast<int>(map.corners.size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      shortest = std::min(shortest, (map.At(t, (i + 1) % 3) - map.At(t, i)).norm());
    }
  }
  return shortest / map.Extent();
}

int CountReversed(const SeamlessMap& map)
{
  int count = 0;
  for (int t = 0; t < static_cast<int>(map.corners.size()); ++t)
  {
    const bool inMap = Cross(map.At(t, 1) - map.At(t, 0), map.At(t, 2) - map.At(t, 0)) > 0.0;
    const bool inPlane = TriangleArea(map.topology->mesh, static_cast<std::size_t>(t)) > 0.0;
    count += inMap && inPlane ? 0 : 1;
  }
  return count;
}
}
