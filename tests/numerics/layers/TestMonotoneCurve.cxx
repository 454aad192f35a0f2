// Curves through points: exact on lines, of second order or better on circles, the same in every
// position, and without turning back.

#include "MonotoneCurve.h"

#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
TEST(MonotoneCurve, IsTheLineThroughPointsOnALine)
{
  const Point direction = Point(2.0, -1.0).normalized();
  std::vector<Point> points;
  for (const double at : { 0.0, 0.3, 0.35, 1.0, 2.2 })
  {
    points.push_back(Point(1.0, 1.0) + at * direction);
  }
  const MonotoneCurve curve(points);
  EXPECT_NEAR(curve.Length(), 2.2, 1e-12);
  EXPECT_LT((curve.StartTangent() - direction).norm(), 1e-12);
  for (const double at : { 0.0, 1e-9, 0.1, 0.32, 0.9, 2.1999, 2.2 })
  {
    EXPECT_LT((curve.At(at) - points[0] - at * direction).norm(), 1e-12) << at;
  }
}

TEST(MonotoneCurve, TwoPointsAreASegment)
{
  const MonotoneCurve curve({ Point(0.0, 0.0), Point(0.0, 2.0) });
  EXPECT_NEAR(curve.Length(), 2.0, 1e-14);
  EXPECT_LT((curve.At(0.5) - Point(0.0, 0.5)).norm(), 1e-14);
}

/// Returns points on the unit circle over an angle.
std::vector<Point> OnArc(int pieces, double angle)
{
  std::vector<Point> points;
  for (int i = 0; i <= pieces; ++i)
  {
    points.emplace_back(std::cos(angle * i / pieces), std::sin(angle * i / pieces));
  }
  return points;
}

TEST(MonotoneCurve, PassesThroughItsPointsAndConvergesOnACircle)
{
  std::vector<double> sizes;
  std::vector<double> errors;
  std::vector<double> tangents;
  for (const int pieces : { 8, 16, 32, 64 })
  {
    const std::vector<Point> points = OnArc(pieces, 1.2);
    const MonotoneCurve curve(points);
    double error = 0.0;
    for (int i = 0; i <= 1000; ++i)
    {
      error = std::max(error, std::abs(curve.At(curve.Length() * i / 1000.0).norm() - 1.0));
    }
    EXPECT_LT((curve.At(0.0) - points.front()).norm(), 1e-14);
    EXPECT_LT((curve.At(curve.Length()) - points.back()).norm(), 1e-12);
    sizes.push_back(1.0 / pieces);
    errors.push_back(error);
    tangents.push_back((curve.StartTangent() - Point(0.0, 1.0)).norm());
  }
  EXPECT_GT(ConvergenceRate(sizes, errors), 1.9);
  EXPECT_GT(ConvergenceRate(sizes, tangents), 1.9);
}

TEST(MonotoneCurve, ArgumentIsTheArcLength)
{
  const MonotoneCurve curve(OnArc(5, 1.5));
  constexpr int Steps = 20000;
  double length = 0.0;
  for (int i = 0; i < Steps; ++i)
  {
    const double from = curve.Length() * i / Steps;
    const double to = curve.Length() * (i + 1) / Steps;
    length += (curve.At(to) - curve.At(from)).norm();
    EXPECT_NEAR(length, to, 1e-4) << i; // Gauss's rule over a piece is not exact
  }
}

TEST(MonotoneCurve, IsTheSameInEveryPosition)
{
  Random random(317);
  for (int i = 0; i < 20; ++i)
  {
    std::vector<Point> points = { Point(0.0, 0.0) };
    for (int j = 0; j < 6; ++j)
    {
      points.push_back(points.back() + Point(random.Uniform(0.1, 1.0), random.Uniform(-0.4, 0.4)));
    }
    const Similarity map = { random.Uniform(0.0, 6.0), random.Uniform(0.1, 10.0),
      Point(3.0, -2.0) };
    std::vector<Point> moved;
    std::vector<Point> mirrored;
    for (const Point& point : points)
    {
      moved.push_back(map(point));
      mirrored.emplace_back(point.x(), -point.y());
    }
    const MonotoneCurve curve(points);
    const MonotoneCurve other(moved);
    const MonotoneCurve mirror(mirrored);
    for (const double part : { 0.01, 0.2, 0.5, 0.77, 0.99 })
    {
      const Point at = curve.At(part * curve.Length());
      EXPECT_LT((other.At(part * other.Length()) - map(at)).norm(), 1e-9 * map.scale);
      const Point reflected = mirror.At(part * mirror.Length());
      EXPECT_LT((reflected - Point(at.x(), -at.y())).norm(), 1e-9);
    }
  }
}

TEST(MonotoneCurve, TakesAGivenStartTangent)
{
  const std::vector<Point> points = OnArc(6, 1.0);
  const Point start = Point(0.3, 1.0).normalized();
  const MonotoneCurve curve(points, start);
  EXPECT_LT((curve.StartTangent() - start).norm(), 1e-12);
  EXPECT_LT(((curve.At(1e-6) - points[0]) / 1e-6 - start).norm(), 1e-4);
  EXPECT_LT((curve.At(curve.Length()) - points.back()).norm(), 1e-12);
}

TEST(MonotoneCurve, DoesNotTurnBack)
{
  // Nearly a step: a spline would turn back along the line from the first point to the last one.
  const MonotoneCurve curve({ Point(0.0, 0.0), Point(1.0, 0.0), Point(2.0, 0.1), Point(2.05, 1.0),
    Point(2.1, 2.0), Point(4.0, 2.0) });
  const Point along = Point(4.0, 2.0).normalized();
  double last = -1e-12;
  for (int i = 0; i <= 1000; ++i)
  {
    const double at = along.dot(curve.At(curve.Length() * i / 1000.0));
    EXPECT_GE(at, last - 1e-12) << i;
    last = at;
  }
}
}
}
