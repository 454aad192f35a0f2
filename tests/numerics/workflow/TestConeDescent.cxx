#include "ConeDescent.h"

#include "EdgeDistances.h"
#include "PoincareHopf.h"
#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"
#include "VertexPotential.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <set>

namespace crossfield::test
{
namespace
{
/// Returns the largest holonomy defect of the crosses, in radians.
double LargestDefect(const SharedTopology& topology, const std::vector<Cone>& cones)
{
  double largest = 0.0;
  for (const double defect :
    VertexPotential(topology).Solve(QuartersOfVertices(*topology, cones)).holonomyDefect)
  {
    largest = std::max(largest, 0.25 * std::abs(defect));
  }
  return largest;
}

/// Returns four pairs of opposite singularities at random vertices inside.
std::vector<Cone> PairsAtRandom(const MeshTopology& topology, unsigned seed)
{
  Random random(seed);
  std::set<int> taken;
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    taken.insert(edge.vertices[0]);
  }
  std::vector<Cone> cones;
  while (cones.size() < 8)
  {
    const int vertex = std::min(
      topology.VertexCount() - 1, static_cast<int>(random.Uniform(0.0, topology.VertexCount())));
    if (taken.insert(vertex).second)
    {
      cones.push_back({ vertex, cones.size() % 2 == 0 ? 1 : -1, false, -1 });
    }
  }
  return cones;
}

double NearestDistance(const MeshTopology& topology, const std::vector<Cone>& cones)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < cones.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const SpacePoint offset =
        topology.PositionOf(cones[i].vertex) - topology.PositionOf(cones[j].vertex);
      nearest = std::min(nearest, offset.norm());
    }
  }
  return nearest;
}

TEST(ConeDescent, ClosesCrossesAroundHandles)
{
  const auto topology = std::make_shared<const SurfaceTopology>(Torus(2.5, 60, 24));
  double before = 0.0;
  for (unsigned seed = 811; seed < 815; ++seed)
  {
    const std::vector<Cone> cones = PairsAtRandom(*topology, seed);
    before = std::max(before, LargestDefect(topology, cones));
    const std::vector<Cone> moved = MovedCones(topology, cones, {});
    EXPECT_LT(LargestDefect(topology, moved), 0.03) << seed;
    ASSERT_EQ(moved.size(), cones.size());
    std::set<int> vertices;
    for (std::size_t i = 0; i < cones.size(); ++i)
    {
      EXPECT_EQ(moved[i].quarterIndex, cones[i].quarterIndex);
      vertices.insert(moved[i].vertex);
    }
    EXPECT_EQ(vertices.size(), cones.size()); // one at each
  }
  EXPECT_GT(before, 0.2);
}

TEST(ConeDescent, SpreadsSingularities)
{
  const auto topology = std::make_shared<const SurfaceTopology>(CubedSphere(12));
  std::vector<Cone> cones; // eight side by side
  EdgeDistances(*topology).VisitFrom(0,
    [&](int vertex, double)
    {
      cones.push_back({ vertex, 1, false, -1 });
      return cones.size() < 8;
    });
  EXPECT_LT(NearestDistance(*topology, cones), 0.2);
  const std::vector<Cone> moved = MovedCones(topology, cones, {});
  EXPECT_GT(NearestDistance(*topology, moved), 0.5); // 1.15 between the corners of a cube
}
}
}
