// Splines through points of known curves.

#include "SplineThrough.h"

#include "CurveChecks.h"
#include "CurveEvaluator.h"
#include "Support.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield::test
{
namespace
{
TEST(SplineThrough, InterpolatesAndConvergesWithOrderFour)
{
  PlaneCurve circle;
  circle.kind = PlaneCurve::Kind::Circle;
  circle.axis = Point(1.0, 0.0);
  const CurveEvaluator exact(circle);
  std::array<std::array<double, 2>, 2> errors{};
  for (int refinement = 0; refinement < 2; ++refinement)
  {
    const int count = 32 << refinement;
    std::vector<Point> closed;
    for (int i = 0; i < count; ++i)
    {
      closed.push_back(exact.At(2.0 * Pi * i / count));
    }
    const std::vector<Point> open = PointsOn(exact, 0.0, 3.0, count);
    for (const bool isClosed : { true, false })
    {
      const std::vector<Point>& points = isClosed ? closed : open;
      const CurveEvaluator spline(SplineThrough(points, isClosed));
      EXPECT_EQ(spline.IsClosed(), isClosed);
      EXPECT_LT(LargestDistance(spline, points), 1e-15);
      double& error = errors[static_cast<std::size_t>(refinement)][isClosed ? 0 : 1];
      for (int i = 0; i <= 5000; ++i)
      {
        const double t = spline.First() + spline.Period() * i / 5000;
        error = std::max(error, std::abs(spline.At(t).norm() - 1.0));
      }
    }
  }
  for (const std::size_t kind : { 0U, 1U })
  {
    EXPECT_GT(std::log2(errors[0][kind] / errors[1][kind]), 3.8);
  }
  EXPECT_LT(errors[1][0], 3e-7); // a circle of 64 points
}

TEST(SplineThrough, OfThreePointsIsAParabola)
{
  const std::vector<Point> points = { { -1.0, 1.0 }, { 0.0, 0.0 }, { 1.0, 1.0 } };
  const CurveEvaluator spline(SplineThrough(points, false));
  for (int i = 0; i <= 20; ++i)
  {
    const Point place = spline.At(spline.Last() * i / 20);
    EXPECT_NEAR(place.y(), place.x() * place.x(), 1e-14);
  }
}

TEST(SplineThrough, HasTheGivenTangents)
{
  const std::vector<Point> points = { { 1, 0 }, { std::sqrt(0.5), std::sqrt(0.5) }, { 0, 1 } };
  EndTangents tangents;
  tangents.first = Point(0, 7);
  tangents.last = Point(-3, 0);
  const CurveEvaluator spline(SplineThrough(points, false, tangents));
  EXPECT_LT((spline.Tangent(spline.First()) - Point(0, 1)).norm(), 1e-14);
  EXPECT_LT((spline.Tangent(spline.Last()) - Point(-1, 0)).norm(), 1e-14);
  for (int i = 0; i <= 100; ++i) // of a quarter circle in two parts
  {
    EXPECT_NEAR(spline.At(spline.Last() * i / 100).norm(), 1.0, 2e-3);
  }
}

TEST(SplineThrough, SecondDerivativesAreContinuous)
{
  Random random(52);
  std::vector<Point> points;
  for (int i = 0; i < 9; ++i)
  {
    points.emplace_back(i + random.Uniform(-0.3, 0.3), random.Uniform(-1, 1));
  }
  for (const bool isClosed : { false, true })
  {
    const PlaneCurve curve = SplineThrough(points, isClosed);
    const std::size_t spans = points.size() - (isClosed ? 0 : 1);
    const auto length = [&curve](std::size_t span)
    { return curve.knots[3 * span + 4] - curve.knots[3 * span + 1]; };
    const auto second = [&](std::size_t span, bool atEnd) -> Point
    {
      const std::size_t at = 3 * span + (atEnd ? 1 : 0);
      return 6.0 / (length(span) * length(span)) *
        (curve.points[at] - 2.0 * curve.points[at + 1] + curve.points[at + 2]);
    };
    const auto third = [&](std::size_t span) -> Point
    { return (second(span, true) - second(span, false)) / length(span); };
    for (std::size_t span = 1; span < spans; ++span)
    {
      EXPECT_LT((second(span - 1, true) - second(span, false)).norm(), 1e-10);
    }
    if (isClosed)
    {
      EXPECT_LT((second(spans - 1, true) - second(0, false)).norm(), 1e-10);
    }
    else
    {
      EXPECT_LT((third(0) - third(1)).norm(), 1e-9);
      EXPECT_LT((third(spans - 2) - third(spans - 1)).norm(), 1e-9);
    }
  }
}
}
}
