#include "ThroughPoints.h"

#include "DrawingChecks.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
std::vector<Point> OnCircle(int count)
{
  std::vector<Point> points;
  for (int i = 0; i <= count; ++i)
  {
    const double angle = 2.0 * Pi * (i % count) / count;
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  return points;
}

double RadialError(const DrawingPiece& piece)
{
  double largest = 0.0;
  for (const Point& point : PointsOf(piece, 2001))
  {
    largest = std::max(largest, std::abs(point.norm() - 1.0));
  }
  return largest;
}

TEST(ThroughPoints, PassesThroughEveryPoint)
{
  Random random(51);
  std::vector<Point> points;
  for (int i = 0; i < 20; ++i)
  {
    points.emplace_back(random.Uniform(-1, 1), random.Uniform(-1, 1));
  }
  const DrawingPiece spline = ThroughPoints(points);
  double at = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    EXPECT_LT((PointAt(spline, std::min(at, spline.end)) - points[i]).norm(), 1e-13);
    at += i + 1 < points.size() ? (points[i + 1] - points[i]).norm() : 0.0;
  }
}

TEST(ThroughPoints, PeriodicSplineHasFourthOrder)
{
  const double coarse = RadialError(ThroughPoints(OnCircle(32), true));
  const double fine = RadialError(ThroughPoints(OnCircle(64), true));
  EXPECT_LT(fine, 3e-7);
  EXPECT_GT(std::log2(coarse / fine), 3.8);
}

TEST(ThroughPoints, HasTheGivenTangents)
{
  const std::vector<Point> points = { { 1, 0 }, { std::sqrt(0.5), std::sqrt(0.5) }, { 0, 1 } };
  EndTangents tangents;
  tangents.first = Point(0, 7);
  tangents.last = Point(-3, 0);
  const DrawingPiece spline = ThroughPoints(points, false, tangents);
  const double step = 1e-6;
  const Point start = (PointAt(spline, step) - points[0]) / step;
  const Point stop = (points[2] - PointAt(spline, spline.end - step)) / step;
  EXPECT_LT((start - Point(0, 1)).norm(), 1e-5);
  EXPECT_LT((stop - Point(-1, 0)).norm(), 1e-5);
  EXPECT_LT(RadialError(spline), 2e-3); // of a quarter circle in two parts
}

TEST(ThroughPoints, SecondDerivativeIsContinuousAndZeroAtNaturalEnds)
{
  Random random(52);
  std::vector<Point> points;
  for (int i = 0; i < 9; ++i)
  {
    points.emplace_back(i + random.Uniform(-0.3, 0.3), random.Uniform(-1, 1));
  }
  for (const bool isPeriodic : { false, true })
  {
    if (isPeriodic)
    {
      points.push_back(points.front());
    }
    const PlaneCurve curve = ThroughPoints(points, isPeriodic).curve;
    const std::size_t spans = points.size() - 1;
    const auto second = [&curve](std::size_t span, bool atEnd) -> Point
    {
      const std::size_t at = 3 * span + (atEnd ? 1 : 0);
      const double length = curve.knots[3 * span + 4] - curve.knots[3 * span + 1];
      return 6.0 / (length * length) *
        (curve.points[at] - 2.0 * curve.points[at + 1] + curve.points[at + 2]);
    };
    for (std::size_t span = 1; span < spans; ++span)
    {
      EXPECT_LT((second(span - 1, true) - second(span, false)).norm(), 1e-10);
    }
    if (isPeriodic)
    {
      EXPECT_LT((second(spans - 1, true) - second(0, false)).norm(), 1e-10);
    }
    else
    {
      EXPECT_LT(second(0, false).norm() + second(spans - 1, true).norm(), 1e-10);
    }
  }
}

TEST(ThroughPoints, IgnoresRepeatedPointsAndReturnsALineForTwo)
{
  EXPECT_EQ(ThroughPoints({ { 0, 0 }, { 0, 0 }, { 1, 2 } }).curve.kind, PlaneCurve::Kind::Line);
  const DrawingPiece spline = ThroughPoints({ { 0, 0 }, { 1, 0 }, { 1, 0 }, { 2, 1 } });
  EXPECT_EQ(spline.curve.points.size(), 7U);
}
}
}
