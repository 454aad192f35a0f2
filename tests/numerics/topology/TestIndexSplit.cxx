#include "IndexSplit.h"

#include "Support.h"

namespace crossfield::test
{
namespace
{
TEST(IndexSplit, SplitsIntoARegularPolygonAroundThePlace)
{
  const PlanarDomain disk = Builtin("disk");
  const Point place(0.2, -0.1);
  for (const int quarters : { 2, 3, 4, -2, -3, -5 })
  {
    const Configuration given = { { { -0.6, 0.3 }, 1 }, { place, quarters }, { { 0.1, 0.7 }, -1 } };
    const SplitConfiguration split = SplitIndices(disk, given, 0.15);
    const auto count = static_cast<std::size_t>(std::abs(quarters));
    ASSERT_EQ(split.singularities.size(), 2 + count);
    EXPECT_EQ(split.events.size(), 1U);
    EXPECT_EQ(TotalQuarters(split.singularities), TotalQuarters(given));
    EXPECT_EQ(split.singularities.front().position, given.front().position);
    EXPECT_EQ(split.singularities.back().position, given.back().position);
    Point centre = Point::Zero();
    for (std::size_t i = 1; i <= count; ++i)
    {
      const Singularity& part = split.singularities[i];
      EXPECT_EQ(part.quarterIndex, quarters > 0 ? 1 : -1);
      centre += part.position / static_cast<double>(count);
      const Point& next = split.singularities[i % count + 1].position;
      EXPECT_NEAR((next - part.position).norm(), 0.15, 1e-12);
    }
    EXPECT_LT((centre - place).norm(), 1e-12);
  }
}

TEST(IndexSplit, KeepsADistanceFromWhateverIsNear)
{
  const PlanarDomain square = Builtin("square");
  const double side = square.loops[0][1].x() - square.loops[0][0].x();
  const Point corner = square.loops[0][0];
  // Near the lower side, two are placed parallel to it.
  const Point place = corner + Point(0.5 * side, 0.05 * side);
  const Configuration near = SplitIndices(square, { { place, 2 } }, side).singularities;
  ASSERT_EQ(near.size(), 2U);
  EXPECT_NEAR(near[0].position.y(), place.y(), 1e-12);
  EXPECT_NEAR((near[0].position - near[1].position).norm(), 2.0 * 0.3 * 0.05 * side, 1e-12);
  // Two neighbours that are both split do not meet.
  const Configuration pair = SplitIndices(square,
    { { place + Point(0.0, 0.3 * side), 2 }, { place + Point(0.01 * side, 0.3 * side), -2 } }, side)
                               .singularities;
  ASSERT_EQ(pair.size(), 4U);
  for (std::size_t i = 0; i < 2; ++i)
  {
    for (std::size_t j = 2; j < 4; ++j)
    {
      EXPECT_GT((pair[i].position - pair[j].position).norm(), 0.004 * side);
    }
  }
}

TEST(IndexSplit, LeavesTheBoundaryAndSmallIndices)
{
  const PlanarDomain square = Builtin("square");
  const Configuration given = { { square.loops[0][0], 2 }, { square.loops[0][1], -2 },
    { 0.5 * (square.loops[0][0] + square.loops[0][2]), 1 } };
  const SplitConfiguration split = SplitIndices(square, given, 0.1);
  EXPECT_TRUE(split.events.empty());
  ASSERT_EQ(split.singularities.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_EQ(split.singularities[i].position, given[i].position);
    EXPECT_EQ(split.singularities[i].quarterIndex, given[i].quarterIndex);
  }
}
}
}
