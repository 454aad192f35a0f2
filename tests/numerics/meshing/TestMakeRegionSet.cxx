// Sets of regions from polygons with materials.

#include "MakeRegionSet.h"

#include "Error.h"
#include "Partitions.h"
#include "PoincareHopf.h"
#include "RegionNodes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>

namespace crossfield::test
{
namespace
{
TEST(RegionSet, HasPiecesWithEqualPointsOnBothSides)
{
  for (const unsigned seed : { 1U, 2U, 3U, 4U, 5U })
  {
    const RegionSet set = MakeRegionSet(VoronoiCells(seed, 4));
    ASSERT_EQ(set.regions.size(), 16U);
    const std::vector<DomainPart> parts = PartsOf(set);
    using Segment = std::array<double, 4>;
    std::map<Segment, int> sides;
    for (const Region& region : set.regions)
    {
      for (const Loop& loop : region.domain.loops)
      {
        for (std::size_t i = 0; i < loop.size(); ++i)
        {
          const Point& a = loop[i];
          const Point& b = loop[(i + 1) % loop.size()];
          ++sides[{ a.x(), a.y(), b.x(), b.y() }];
        }
      }
    }
    std::size_t inside = 0;
    for (const auto& [segment, count] : sides)
    {
      EXPECT_EQ(count, 1);
      const bool isPaired = sides.count({ segment[2], segment[3], segment[0], segment[1] }) > 0;
      const bool isOnOutline = std::abs(segment[0]) == 1.0 || std::abs(segment[1]) == 1.0;
      EXPECT_TRUE(isPaired || isOnOutline);
      inside += isPaired ? 1 : 0;
    }
    std::size_t pieces = 0;
    for (const InterfacePiece& piece : set.interfaces)
    {
      pieces += piece.line.size() - 1;
      EXPECT_LT(piece.regions[0], piece.regions[1]);
      for (const int region : piece.regions)
      {
        EXPECT_GE(parts[static_cast<std::size_t>(region)].sides.Find(piece.name), 0);
      }
    }
    EXPECT_EQ(2 * pieces, inside);
    // What singularities, nodes and corners have together is 4χ.
    const auto corners =
      FindNodeCorners(set, std::vector<std::vector<CornerChoice>>(set.regions.size()));
    int sum = 4; // the corners of the square, in one region each
    std::vector<std::vector<CornerChoice>> choices(set.regions.size());
    for (std::size_t n = 0; n < corners.size(); ++n)
    {
      sum += IndexAt(set.nodes[n], corners[n]);
      for (const RegionCorner& corner : corners[n])
      {
        choices[corner.region].push_back({ corner.corner.position, corner.quarterIndex });
      }
    }
    for (std::size_t r = 0; r < set.regions.size(); ++r)
    {
      sum += CountQuarters(set.regions[r].domain.loops, 0, DefaultCornerAngle, choices[r])
               .requiredInteriorQuarters;
    }
    EXPECT_EQ(sum, 4);
  }
}

TEST(RegionSet, DoesNotDependOnTheOrderOfCells)
{
  MaterialCells cells = VoronoiCells(7, 3);
  const RegionSet set = MakeRegionSet(cells);
  std::reverse(cells.cells.begin(), cells.cells.end());
  std::reverse(cells.materials.begin(), cells.materials.end());
  for (std::vector<int>& cell : cells.cells)
  {
    std::reverse(cell.begin(), cell.end());
  }
  const RegionSet other = MakeRegionSet(cells);
  ASSERT_EQ(other.regions.size(), set.regions.size());
  for (std::size_t r = 0; r < set.regions.size(); ++r)
  {
    EXPECT_EQ(other.regions[r].domain.loops, set.regions[r].domain.loops);
  }
  ASSERT_EQ(other.interfaces.size(), set.interfaces.size());
  for (std::size_t p = 0; p < set.interfaces.size(); ++p)
  {
    EXPECT_EQ(other.interfaces[p].name, set.interfaces[p].name);
    EXPECT_EQ(other.interfaces[p].line, set.interfaces[p].line);
  }
}

TEST(RegionSet, RefusesOverlappingCells)
{
  CellMaker maker;
  maker.Add("a", { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  maker.Add("b", { { 0, 0 }, { 1, 0 }, { 1, 2 }, { 0, 2 } });
  EXPECT_THROW(MakeRegionSet(maker.Cells), Error);
}

TEST(RegionSet, RefusesCellsThatTouchWithoutCommonPoints)
{
  CellMaker maker;
  maker.Add("a", { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  maker.Add("b", { { 1, 0 }, { 2, 0 }, { 2, 0.5 }, { 1, 0.5 } });
  maker.Add("c", { { 1, 0.5 }, { 2, 0.5 }, { 2, 1 }, { 1, 1 } });
  try
  {
    MakeRegionSet(maker.Cells);
    FAIL();
  }
  catch (const Error& error)
  {
    EXPECT_NE(
      std::string(error.what()).find("The point at (1, 0.5) is on the edge of another cell"),
      std::string::npos);
  }
  maker = {};
  maker.Add("", { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  EXPECT_THROW(MakeRegionSet(maker.Cells), Error);
}
}
}
