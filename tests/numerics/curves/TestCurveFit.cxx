// Circles and ellipses through points of known curves.

#include "CurveFit.h"

#include "CurveChecks.h"
#include "CurveEvaluator.h"
#include "Error.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace crossfield::test
{
namespace
{
TEST(CurveFit, CirclesOfExactPoints)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial)
  {
    PlaneCurve circle;
    circle.kind = PlaneCurve::Kind::Circle;
    circle.centre = Point(10.0 * unit(random), -4.0);
    circle.axis = Point(0.1 + unit(random), unit(random));
    const double turn = 0.3 + 5.0 * unit(random);
    const std::vector<Point> points = PointsOn(CurveEvaluator(circle), 1.0, 1.0 + turn, 12);
    for (const FitEnds ends : { FitEnds::Free, FitEnds::Fixed })
    {
      const PlaneCurve fitted = FitCircle(points, ends);
      EXPECT_NEAR((fitted.centre - circle.centre).norm(), 0.0, 1e-11);
      EXPECT_NEAR(fitted.axis.norm(), circle.axis.norm(), 1e-11);
    }
  }
}

TEST(CurveFit, FixedEndsAreOnTheCurve)
{
  std::mt19937 random(11);
  std::normal_distribution<double> noise(0.0, 1e-7);
  for (const double ratio : { 1.0, 0.4 })
  {
    PlaneCurve ellipse;
    ellipse.kind = PlaneCurve::Kind::Ellipse;
    ellipse.axis = Point(1.0, 0.5);
    ellipse.ratio = ratio;
    std::vector<Point> points = PointsOn(CurveEvaluator(ellipse), 0.2, 2.4, 20);
    for (Point& point : points)
    {
      point += Point(noise(random), noise(random));
    }
    const CurveEvaluator fitted(
      ratio == 1.0 ? FitCircle(points, FitEnds::Fixed) : FitEllipse(points, FitEnds::Fixed));
    EXPECT_LT(LargestDistance(fitted, { points.front(), points.back() }), 1e-13);
    const double largest = LargestDistance(fitted, points);
    EXPECT_GT(largest, 1e-9);
    EXPECT_LT(largest, 1e-6);
  }
}

TEST(CurveFit, EllipsesOfExactPoints)
{
  std::mt19937 random(23);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int trial = 0; trial < 50; ++trial)
  {
    PlaneCurve ellipse;
    ellipse.kind = PlaneCurve::Kind::Ellipse;
    ellipse.centre = Point(unit(random), 2.0);
    ellipse.axis = Point(1.0, unit(random));
    ellipse.ratio = 0.05 + unit(random);
    const std::vector<Point> points =
      PointsOn(CurveEvaluator(ellipse), 0.0, trial % 2 == 0 ? 6.0 : 2.5, 24);
    const CurveEvaluator fitted(FitEllipse(points));
    EXPECT_LT(LargestDistance(fitted, PointsOn(CurveEvaluator(ellipse), 0.0, 2.5, 97)), 1e-11);
  }
}

TEST(CurveFit, RefusesTooFewPointsAndLines)
{
  EXPECT_THROW(FitCircle({ { 0, 0 }, { 1, 1 } }), Error);
  EXPECT_THROW(FitCircle({ { 0, 0 }, { 1, 1 }, { 2, 2 }, { 3, 3 } }), Error);
  EXPECT_THROW(FitEllipse({ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } }), Error);
}
}
}
