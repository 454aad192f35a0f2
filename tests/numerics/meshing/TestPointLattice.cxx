#include "PointLattice.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
const Eigen::AlignedBox2d Box(Point(-1.0, -0.5), Point(1.2, 0.7));

double NearestOther(const std::vector<Point>& points, const Point& place)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point& point : points)
  {
    const double distance = (point - place).norm();
    nearest = distance > 0.0 ? std::min(nearest, distance) : nearest;
  }
  return nearest;
}

/// Returns the points of a graded lattice that are in the box.
std::vector<Point> PointsInBox(const SizeField& size)
{
  const GradedLattice lattice = MakeGradedLattice(size);
  std::vector<Point> points = lattice.finer;
  for (std::size_t number = 0; number < lattice.coarsest.Count(); ++number)
  {
    const Point point = lattice.coarsest.At(number);
    if (Box.contains(point))
    {
      points.push_back(point);
    }
  }
  return points;
}

TEST(PointLattice, ConstantSizeGivesEquilateralTriangles)
{
  constexpr double Size = 0.08;
  const std::vector<Point> points = PointsInBox(SizeField({}, Size, 0.25, Box));
  const double cell = 0.5 * std::sqrt(3.0) * Size * Size;
  const auto count = static_cast<double>(points.size());
  // The error is due to the points along the border of the box, whose length is 6.8.
  EXPECT_NEAR(count * cell, Box.volume(), 6.8 * Size);
  for (const Point& point : points)
  {
    EXPECT_TRUE(Box.contains(point));
    EXPECT_NEAR(NearestOther(points, point), Size, 1e-12);
  }
}

TEST(PointLattice, GradedSpacingFollowsTheSizeField)
{
  Random random(90);
  for (int trial = 0; trial < 8; ++trial)
  {
    SCOPED_TRACE(trial);
    std::vector<SizeSource> sources;
    for (int i = 0; i < 1 + trial; ++i)
    {
      sources.push_back({ { random.Uniform(-1.0, 1.2), random.Uniform(-0.5, 0.7) },
        std::exp(random.Uniform(std::log(0.003), std::log(0.1))) });
    }
    const SizeField size(sources, 0.15, random.Uniform(0.1, 0.4), Box);
    const std::vector<Point> points = PointsInBox(size);
    for (const Point& point : points)
    {
      ASSERT_TRUE(Box.contains(point));
      ASSERT_GE(NearestOther(points, point), 0.5 * size(point)) << point.transpose();
    }
    for (int i = 0; i < 1000; ++i)
    {
      const Point place(random.Uniform(-1.0, 1.2), random.Uniform(-0.5, 0.7));
      ASSERT_LE(NearestOther(points, place), 1.3 * size(place)) << place.transpose();
    }
  }
}

TEST(PointLattice, IsDeterministic)
{
  const SizeField size({ { { 0.1, 0.2 }, 0.001 } }, 0.1, 0.25, Box);
  EXPECT_EQ(PointsInBox(size), PointsInBox(size));
}
}
}
