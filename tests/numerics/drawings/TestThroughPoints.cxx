#include "ThroughPoints.h"

#include "DrawingChecks.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
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

TEST(ThroughPoints, APeriodicPieceEndsWhereItStarts)
{
  std::vector<Point> points;
  for (int i = 0; i <= 64; ++i)
  {
    const double angle = 2.0 * Pi * (i % 64) / 64;
    points.emplace_back(std::cos(angle), std::sin(angle));
  }
  const DrawingPiece spline = ThroughPoints(points, true);
  EXPECT_EQ(spline.first, spline.last);
  for (const Point& point : PointsOf(spline, 2001))
  {
    EXPECT_NEAR(point.norm(), 1.0, 3e-7);
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
