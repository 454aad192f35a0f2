#include "SurfaceChoice.h"

#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <cstdlib>
#include <map>

namespace crossfield::test
{
namespace
{
/// Returns how many cones of each index are chosen.
std::map<int, int> ChosenFor(const SurfaceMesh& surface, const std::vector<Cone>& corners = {})
{
  const SurfaceTopology topology(surface);
  std::map<int, int> counts;
  for (const Cone& cone : ChooseSurfaceCones(topology, corners))
  {
    EXPECT_FALSE(cone.onBoundary);
    ++counts[cone.quarterIndex];
  }
  return counts;
}

using Counts = std::map<int, int>;

TEST(SurfaceChoice, HasFewSingularitiesOnSmoothSurfaces)
{
  EXPECT_EQ(ChosenFor(CubedSphere(12)), (Counts{ { 1, 8 } }));
  EXPECT_EQ(ChosenFor(Hemisphere(12)), (Counts{ { 1, 4 } }));
  EXPECT_EQ(ChosenFor(Torus(2.5, 60, 24)), Counts());
}

TEST(SurfaceChoice, TakesCornersIntoAccount)
{
  constexpr int N = 12;
  const SurfaceMesh sheet = BentAtRandom(GridOfSquare(N), N, 704);
  std::vector<Cone> corners;
  for (const Cone& cone : ConesOfSquare(N))
  {
    if (cone.onBoundary)
    {
      corners.push_back(cone);
    }
  }
  ASSERT_EQ(corners.size(), 4u);
  EXPECT_EQ(ChosenFor(sheet, corners), Counts());
  // Where a corner is to be none, its index goes inside.
  corners.pop_back();
  EXPECT_EQ(ChosenFor(sheet, corners), (Counts{ { 1, 1 } }));
}

TEST(SurfaceChoice, AddsUp)
{
  for (const int genus : { 1, 2, 4 })
  {
    int sum = 0;
    for (const auto& [index, count] : ChosenFor(BoxWithHoles(genus, 4)))
    {
      EXPECT_EQ(std::abs(index), 1);
      sum += index * count;
    }
    EXPECT_EQ(sum, 4 * (2 - 2 * genus));
  }
}
}
}
