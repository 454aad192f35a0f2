#include "LoopArc.h"

#include <gtest/gtest.h>

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Oblong of 4 × 2, counter-clockwise, with a vertex in the middle of the lower side.
const Loop Oblong = { { 0, 0 }, { 2, 0 }, { 4, 0 }, { 4, 2 }, { 0, 2 } };

TEST(LoopArc, EvaluatesPointsAlongTheLoop)
{
  const LoopArc arc(Oblong);
  EXPECT_EQ(arc.Length(), 12.0);
  EXPECT_EQ(arc.Start(3), 6.0);
  EXPECT_EQ(arc.At(5.0), Point(4, 1));
  EXPECT_EQ(arc.At(11.5), Point(0, 0.5));
  for (const double at : { 0.0, 0.25, 2.0, 5.0, 11.5 })
  {
    for (const double rounds : { -24.0, -12.0, 12.0, 36.0 })
    {
      EXPECT_EQ(arc.At(at + rounds), arc.At(at));
      EXPECT_EQ(arc.SideAt(at + rounds), arc.SideAt(at));
    }
  }
  EXPECT_EQ(arc.SideAt(2.0), std::make_pair(std::size_t{ 1 }, 0.0)); // the side after a vertex
  EXPECT_EQ(arc.SideAt(5.5), std::make_pair(std::size_t{ 2 }, 0.75));
  EXPECT_EQ(arc.Tangent(4.0), Point(0, 1));
  EXPECT_EQ(arc.Tangent(-1.0), Point(0, -1));
  EXPECT_EQ(arc.NearestVertex(3.5), 2U);
  EXPECT_EQ(arc.NearestVertex(11.5), 0U);
  EXPECT_EQ(arc.NearestVertex(-1.5), 4U);
}

TEST(LoopArc, FindsNearestPoints)
{
  const LoopArc arc(Oblong);
  EXPECT_EQ(arc.Nearest({ 1, -3 }), 1.0);
  EXPECT_EQ(arc.Nearest({ 2, -3 }), 2.0);    // a vertex, equally near on both of its sides
  EXPECT_EQ(arc.Nearest({ -1, -1 }), 0.0);   // the first vertex
  EXPECT_EQ(arc.Nearest({ 3.5, 1.5 }), 6.0); // equally near to two sides: the vertex between them
  EXPECT_EQ(arc.Nearest({ 0.25, 0.25 }), 0.0);
  EXPECT_EQ(arc.Find({ 1, -3 }, 3.0), 1.0);
  EXPECT_LT(arc.Find({ 1, -3 }, 2.9), 0.0);
  EXPECT_EQ(arc.FindAll({ { 5, 1 }, { 9, 9 }, { 1, 0 } }, 1.0), std::vector<double>({ 5.0, 1.0 }));
}

TEST(LoopArc, TurningAddsUpToAFullTurn)
{
  const LoopArc arc(Oblong);
  double sum = 0.0;
  for (const double turn : arc.Turns())
  {
    sum += turn;
  }
  EXPECT_NEAR(sum, 2.0 * Pi, 1e-15);
  EXPECT_EQ(arc.Turns()[1], 0.0);
  EXPECT_EQ(arc.Corners(Pi / 6.0), std::vector<double>({ 0.0, 4.0, 6.0, 10.0 }));
  EXPECT_TRUE(arc.Corners(Pi / 2.0).empty()); // corners turn by more than the angle
}

TEST(LoopArc, MeasuresDistancesFromReplacementSides)
{
  const LoopArc arc(Oblong);
  // Without (4, 0), the side from (2, 0) to (4, 2) is √2 away from it.
  const std::vector<ArcVertex> vertices = { { 0.0, { 0, 0 } }, { 2.0, { 2, 0 } }, { 6.0, { 4, 2 } },
    { 10.0, { 0, 2 } } };
  EXPECT_DOUBLE_EQ(LargestDistance(arc, vertices), std::sqrt(2.0));
  EXPECT_EQ(PositionsOf(vertices)[2], Point(4, 2));
}

TEST(LoopArc, FindsTheNearestPointOfAPart)
{
  const LoopArc arc(Oblong);
  EXPECT_EQ(arc.NearestOnPart({ 1, 0.5 }, 0.0, 4.0), 1.0);
  EXPECT_EQ(arc.NearestOnPart({ 1, 0.5 }, 6.0, 4.0), 9.0);  // on the upper side
  EXPECT_EQ(arc.NearestOnPart({ 1, 0.5 }, 10.0, 4.0), 1.0); // around the first vertex
  EXPECT_EQ(arc.NearestOnPart({ 1, 0.5 }, 4.0, 2.0), 4.5);
}
}
}
