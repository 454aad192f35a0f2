// Lines inside of a domain: cells along them, and the regions and slits that they make.

#include "CellsAlongLines.h"

#include "Error.h"
#include "MakeRegionSet.h"
#include "Partitions.h"
#include "RegionNodes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crossfield::test
{
namespace
{
double LengthOfLines(const MaterialCells& cells)
{
  double length = 0.0;
  for (const LineEdge& edge : cells.lines)
  {
    length += (cells.points[static_cast<std::size_t>(edge.points[1])] -
      cells.points[static_cast<std::size_t>(edge.points[0])])
                .norm();
  }
  return 0.5 * length; // each edge once from both of its cells
}

double AreaOf(const RegionSet& set)
{
  double area = 0.0;
  for (const Region& region : set.regions)
  {
    area += region.domain.Area();
  }
  return area;
}

/// Returns the quarter indices of the corners at all nodes inside.
std::vector<int> IndicesInside(const RegionSet& set)
{
  std::vector<int> indices;
  const auto corners =
    FindNodeCorners(set, std::vector<std::vector<CornerChoice>>(set.regions.size()));
  for (std::size_t n = 0; n < set.nodes.size(); ++n)
  {
    if (!set.nodes[n].isOnBoundary)
    {
      indices.push_back(IndexAt(set.nodes[n], corners[n]));
    }
  }
  return indices;
}

TEST(CellsAlongLines, CoverTheDomainWithEdgesOnLines)
{
  const Loop line = { { -1.0, -0.2 }, { 0.1, 0.075 }, { 1.0, 0.3 } };
  const MaterialCells cells = SquareWithLines({ { "weld", line } });
  EXPECT_NEAR(LengthOfLines(cells), (line[1] - line[0]).norm() + (line[2] - line[1]).norm(), 1e-12);
  const RegionSet set = MakeRegionSet(cells);
  ASSERT_EQ(set.regions.size(), 2U);
  EXPECT_NEAR(AreaOf(set), 4.0, 1e-12);
  ASSERT_EQ(set.interfaces.size(), 1U);
  EXPECT_EQ(set.interfaces[0].side, "weld");
  EXPECT_FALSE(set.interfaces[0].IsSlit());
}

TEST(CellsAlongLines, ALineThatEndsInsideIsASlit)
{
  const RegionSet set =
    MakeRegionSet(SquareWithLines({ { "crack", { { -1, 0 }, { 0.2, 0.1 } } } }));
  ASSERT_EQ(set.regions.size(), 1U);
  ASSERT_EQ(set.interfaces.size(), 1U);
  const InterfacePiece& piece = set.interfaces[0];
  EXPECT_TRUE(piece.IsSlit());
  EXPECT_EQ(piece.line.front(), Point(-1, 0));
  EXPECT_EQ(piece.line.back(), Point(0.2, 0.1));
  EXPECT_EQ(piece.NameIn(0), "crack.left");
  EXPECT_EQ(piece.NameIn(1), "crack.right");
  // The region is a simple polygon, from which the slit takes little.
  EXPECT_EQ(set.regions[0].domain.loops.size(), 1U);
  EXPECT_NEAR(AreaOf(set), 4.0, 2e-3);
  EXPECT_LT(AreaOf(set), 4.0);
  // Its end has four quads, and so is regular.
  EXPECT_EQ(IndicesInside(set), std::vector<int>{ 0 });
  // In the direction in which it is drawn.
  const RegionSet turned =
    MakeRegionSet(SquareWithLines({ { "crack", { { 0.2, 0.1 }, { -1, 0 } } } }));
  EXPECT_EQ(turned.interfaces[0].line.front(), Point(0.2, 0.1));
}

TEST(CellsAlongLines, LinesMayCrossMeetAndBeClosed)
{
  // Crossing inside, with four ends: one hole in the region, five regular nodes.
  const RegionSet cross = MakeRegionSet(SquareWithLines(
    { { "a", { { -0.6, 0 }, { 0.6, 0 } } }, { "b", { { 0, -0.5 }, { 0, 0.6 } } } }));
  EXPECT_EQ(cross.regions.size(), 1U);
  EXPECT_EQ(cross.regions[0].domain.loops.size(), 2U);
  EXPECT_EQ(cross.interfaces.size(), 4U);
  EXPECT_EQ(IndicesInside(cross), std::vector<int>(5, 0));
  // An end near another line is on it.
  const RegionSet tee = MakeRegionSet(
    SquareWithLines({ { "a", { { -1, 0 }, { 1, 0 } } }, { "b", { { 0.3, 1 }, { 0.3, 1e-5 } } } }));
  EXPECT_EQ(tee.regions.size(), 3U);
  EXPECT_NEAR(AreaOf(tee), 4.0, 1e-9);
  const RegionSet closed = MakeRegionSet(SquareWithLines({ { "ring",
    { { -0.5, -0.5 }, { 0.5, -0.5 }, { 0.5, 0.5 }, { -0.5, 0.5 }, { -0.5, -0.5 } } } }));
  EXPECT_EQ(closed.regions.size(), 2U);
}

TEST(CellsAlongLines, ALineFromAHoleToTheBoundaryCutsARing)
{
  const PlanarDomain ring{ { { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } },
    { { -0.3, 0 }, { 0, 0.3 }, { 0.3, 0 }, { 0, -0.3 } } } };
  const RegionSet set = MakeRegionSet(
    CellsAlongLines(EdgesOf(ring), { "plate" }, { { { 0.3, 0 }, { 1, 0 }, 0 } }, { "cut" }));
  ASSERT_EQ(set.regions.size(), 1U);
  EXPECT_EQ(set.regions[0].domain.loops.size(), 1U);
  EXPECT_TRUE(set.interfaces[0].IsSlit());
  EXPECT_EQ(set.outlines[0].loops.size(), 2U);
}

TEST(CellsAlongLines, EndsOnEdgesOfAnyDirectionAreConnected)
{
  // A point on an edge is beside it by rounding, which must not leave the edge undivided.
  const int corners = 48;
  Loop ellipse;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * i / corners;
    ellipse.emplace_back(1.3 * std::cos(angle), 0.9 * std::sin(angle));
  }
  const PlanarDomain domain{ { ellipse } };
  for (int i = 0; i < 200; ++i)
  {
    const std::size_t edge = static_cast<std::size_t>(i) % ellipse.size();
    const double part = 0.1 + 0.8 * (i % 13) / 13.0;
    const Point end = ellipse[edge] + part * (ellipse[(edge + 1) % ellipse.size()] - ellipse[edge]);
    const RegionSet set = MakeRegionSet(
      CellsAlongLines(EdgesOf(domain), { "plate" }, { { end, { 0.05, 0.02 }, 0 } }, { "line" }));
    EXPECT_EQ(set.regions[0].domain.loops.size(), 1U) << i;
  }
}

TEST(CellsAlongLines, AnEndBesideAVertexByRoundingIsThere)
{
  const double vertex = -0.4 + 0.3; // −0.1 but for rounding
  ASSERT_NE(vertex, -0.1);
  const PlanarDomain ring{ { { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } },
    { { -0.7, 0 }, { -0.4, 0.3 }, { vertex, 0 }, { -0.4, -0.3 } } } };
  const RegionSet set = MakeRegionSet(
    CellsAlongLines(EdgesOf(ring), { "plate" }, { { { -0.1, 0 }, { 0.4, 0 }, 0 } }, { "crack" }));
  EXPECT_EQ(set.regions[0].domain.loops.size(), 2U); // the hole with the crack is one
}

TEST(CellsAlongLines, RefusesALineOutside)
{
  EXPECT_THROW(SquareWithLines({ { "far", { { 3, 3 }, { 4, 4 } } } }), Error);
}
}
}
