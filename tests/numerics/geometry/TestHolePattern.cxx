#include "CrossDirection.h"
#include "HolePattern.h"
#include "Layouts.h"
#include "QuadMesher.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
Loop Hole(const Point& centre, double radius, int count)
{
  Loop loop = RegularPolygon(count, radius, centre);
  return { loop.rbegin(), loop.rend() };
}

/// A rectangle with a round hole in the middle of every unit square.
PlanarDomain Grid(int columns, int rows, double radius)
{
  PlanarDomain plate{ { { { 0.0, 0.0 }, { columns, 0.0 }, { columns, rows }, { 0.0, rows } } } };
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      plate.loops.push_back(Hole({ i + 0.5, j + 0.5 }, radius, 64));
    }
  }
  return plate;
}

TEST(HolePattern, FindsRoundHolesOnly)
{
  PlanarDomain plate = Grid(2, 1, 0.22);
  plate.loops[1] = Hole({ 0.5, 0.5 }, 0.22, 6);
  plate.loops.push_back(Hole({ 1.5, 0.15 }, 0.05, 16));
  const std::vector<RoundHole> holes = FindRoundHoles(plate);
  ASSERT_EQ(holes.size(), 2u);
  EXPECT_EQ(holes[0].loop, 2u);
  EXPECT_LT((holes[0].centre - Point(1.5, 0.5)).norm(), 1e-12);
  EXPECT_NEAR(holes[0].radius, 0.22, 1e-12);
  EXPECT_NEAR(holes[0].gap, 0.3 - 0.22, 1e-3);
  EXPECT_NEAR(holes[1].radius, 0.05, 1e-12);
  const PlanarDomain filled = FillHoles(plate, holes);
  ASSERT_EQ(filled.loops.size(), 2u);
  EXPECT_EQ(filled.loops[1], plate.loops[1]);
}

TEST(HolePattern, PatternFollowsTheCrossOfTheFilledDomain)
{
  const Similarity turn = { 0.3, 2.0, { 1.0, -3.0 } };
  const PlanarDomain plate = turn(Grid(2, 2, 0.2));
  const std::vector<RoundHole> holes = FindRoundHoles(plate);
  ASSERT_EQ(holes.size(), 4u);
  const Layout field = LayOutOn(FillHoles(plate, holes), {});
  const Configuration pattern = PatternAroundHoles(holes, CrossAnglesAt(field.map, Centres(holes)));
  ASSERT_EQ(pattern.size(), 16u);
  for (std::size_t i = 0; i < pattern.size(); ++i)
  {
    EXPECT_EQ(pattern[i].quarterIndex, -1);
    const Point offset = pattern[i].position - holes[i / 4].centre;
    EXPECT_NEAR(
      offset.norm(), 2.0 * std::min(1.41 * 0.2, 0.2 + 0.4 * holes[i / 4].gap / 2.0), 1e-9);
    const double angle = std::atan2(offset.y(), offset.x()) - 0.3 - 0.25 * Pi;
    EXPECT_NEAR(std::remainder(angle, 0.5 * Pi), 0.0, 1e-6);
  }
}

TEST(HolePattern, TwentyHolesHaveFewBlocks)
{
  const PlanarDomain plate = Grid(5, 4, 0.22);
  const std::vector<RoundHole> holes = FindRoundHoles(plate);
  const Layout field = LayOutOn(FillHoles(plate, holes), {});
  const Layout layout =
    LayOutOn(plate, PatternAroundHoles(holes, CrossAnglesAt(field.map, Centres(holes))));
  const QuadResult quads = MakeQuads(LayoutSet(layout), {});
  EXPECT_EQ(quads.blocks.blocks.size(), 159u);
  EXPECT_GE(quads.quality.jacobian.min, 0.88);
}
}
}
