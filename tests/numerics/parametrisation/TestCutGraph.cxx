#include "CutGraph.h"

#include "MeshForPoints.h"
#include "Support.h"

#include <algorithm>
#include <set>

namespace crossfield::test
{
/// Checks that the cut mesh has the Euler characteristic 1 of a disk.
TEST(CutGraph, LeavesADiskWithSingularitiesOnItsBoundary)
{
  for (const char* name : { "disk", "ring" })
  {
    SCOPED_TRACE(name);
    Configuration configuration = OnCircle(5, 0.7, 0.2, 1, 0.0);
    const SharedPlanarTopology topology =
      ShareTopology(MeshThroughPoints(Builtin(name, 0.1), configuration, 0.1));
    std::vector<int> singular;
    for (const Singularity& singularity : configuration)
    {
      const auto& points = topology->mesh.points;
      const auto found = std::find(points.begin(), points.end(), singularity.position);
      ASSERT_NE(found, points.end()); // exactly at the given position
      singular.push_back(static_cast<int>(found - points.begin()));
    }
    const CutGraph cut = CutOpen(*topology, singular);
    std::set<std::pair<int, int>> edges;
    std::set<std::pair<int, int>> open;
    for (const auto& v : cut.corners)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        const auto [a, b] = std::minmax(v[i], v[(i + 1) % 3]);
        edges.insert({ a, b });
        if (!open.insert({ a, b }).second)
        {
          open.erase({ a, b });
        }
      }
    }
    EXPECT_EQ(static_cast<int>(cut.original.size()) - static_cast<int>(edges.size()) +
        static_cast<int>(cut.corners.size()),
      1);
    std::set<int> onBoundary;
    for (const auto& [a, b] : open)
    {
      onBoundary.insert(cut.original[static_cast<std::size_t>(a)]);
      onBoundary.insert(cut.original[static_cast<std::size_t>(b)]);
    }
    for (const int vertex : singular)
    {
      EXPECT_EQ(onBoundary.count(vertex), 1U);
    }
  }
}
}
