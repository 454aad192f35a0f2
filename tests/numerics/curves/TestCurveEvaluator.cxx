// Points, derivatives and projections of curves against their formulas.

#include "CurveEvaluator.h"

#include "Error.h"
#include "SplineThrough.h"
#include "Support.h"

#include <cmath>
#include <random>

namespace crossfield::test
{
namespace
{
PlaneCurve Ellipse(const Point& centre, const Point& axis, double ratio)
{
  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Ellipse;
  curve.centre = centre;
  curve.axis = axis;
  curve.ratio = ratio;
  return curve;
}

/// Returns the unit circle as nine control points of a rational curve of degree 2.
PlaneCurve CircleAsNurbs()
{
  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Nurbs;
  curve.degree = 2;
  curve.knots = { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 };
  curve.points = { { 1, 0 }, { 1, 1 }, { 0, 1 }, { -1, 1 }, { -1, 0 }, { -1, -1 }, { 0, -1 },
    { 1, -1 }, { 1, 0 } };
  for (int i = 0; i < 9; ++i)
  {
    curve.weights.push_back(i % 2 == 0 ? 1.0 : std::sqrt(0.5));
  }
  return curve;
}

PlaneCurve RandomNurbs(std::mt19937& random, int degree)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  PlaneCurve curve;
  curve.kind = PlaneCurve::Kind::Nurbs;
  curve.degree = degree;
  const int count = degree + 4;
  for (int i = 0; i < count; ++i)
  {
    curve.points.emplace_back(i + 0.5 * unit(random), 2.0 * unit(random));
    curve.weights.push_back(0.5 + unit(random));
  }
  double knot = 0.0;
  for (int i = 0; i < count + degree + 1; ++i)
  {
    knot += i > degree && i <= count ? 0.2 + unit(random) : 0.0;
    curve.knots.push_back(knot);
  }
  return curve;
}

TEST(CurveEvaluator, NurbsRepresentACircleExactly)
{
  const CurveEvaluator circle(CircleAsNurbs());
  EXPECT_TRUE(circle.IsClosed());
  for (int i = 0; i <= 400; ++i)
  {
    const double t = 0.01 * i;
    EXPECT_NEAR(circle.At(t).norm(), 1.0, 1e-15);
    EXPECT_NEAR(circle.Curvature(t), 1.0, 1e-13);
    EXPECT_NEAR(circle.Tangent(t).dot(circle.At(t)), 0.0, 1e-14);
  }
}

TEST(CurveEvaluator, DerivativesAreThoseOfDifferences)
{
  std::mt19937 random(71);
  for (int degree = 1; degree <= 5; ++degree)
  {
    const CurveEvaluator curve(RandomNurbs(random, degree));
    std::uniform_real_distribution<double> within(curve.First(), curve.Last());
    for (int i = 0; i < 50; ++i)
    {
      const double t = within(random);
      const double h = 1e-5;
      const CurveFrame frame = curve.FrameAt(t);
      const CurveFrame before = curve.FrameAt(t - h);
      const CurveFrame after = curve.FrameAt(t + h);
      // Not across a knot, where the second derivative may jump.
      if ((after.second - before.second).norm() < 1e-2)
      {
        EXPECT_LT(((after.place - before.place) / (2.0 * h) - frame.first).norm(), 1e-7);
        EXPECT_LT(((after.first - before.first) / (2.0 * h) - frame.second).norm(), 1e-6);
      }
    }
  }
}

TEST(CurveEvaluator, NearestPointsArePerpendicularAndNearerThanAllOthers)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int trial = 0; trial < 60; ++trial)
  {
    const bool isEllipse = trial % 2 == 0;
    const CurveEvaluator curve(isEllipse
        ? Ellipse({ unit(random), unit(random) }, { 1.0 + unit(random), 1.5 },
            0.02 + 0.4 * (1.0 + unit(random)))
        : RandomNurbs(random, 2 + trial % 4));
    const Point place(
      isEllipse ? 3.0 * unit(random) : 3.0 + 3.0 * unit(random), 3.0 * unit(random));
    const double t = curve.Nearest(place);
    const double distance = (curve.At(t) - place).norm();
    for (int i = 0; i <= 2000; ++i)
    {
      const double other = curve.First() + curve.Period() * i / 2000;
      EXPECT_LE(distance, (curve.At(other) - place).norm() + 1e-12);
    }
    if (curve.IsClosed() || (t > curve.First() && t < curve.Last()))
    {
      EXPECT_NEAR(curve.Tangent(t).dot(curve.At(t) - place), 0.0, 1e-12);
    }
  }
}

TEST(CurveEvaluator, FindsTheParameterOfItsOwnPoints)
{
  std::mt19937 random(17);
  const CurveEvaluator ellipse(Ellipse({ 0.3, -0.2 }, { 2.0, 0.7 }, 0.05));
  std::uniform_real_distribution<double> angle(0.0, 2.0 * Pi);
  for (int i = 0; i < 200; ++i)
  {
    const double t = angle(random);
    EXPECT_NEAR(std::remainder(ellipse.Nearest(ellipse.At(t)) - t, 2.0 * Pi), 0.0, 1e-12);
  }
}

TEST(CurveEvaluator, FindsPointsOnBothSidesOfASharpCorner)
{
  // The trailing edge of a profile, at the start of the curve and inside of it.
  const std::vector<Point> profile{ { 1.0, 0.0 }, { 0.5, 0.05 }, { 0.0, 0.0 }, { 0.5, 0.0 } };
  const PlaneCurve fromTip =
    SplineThrough({ profile[0], profile[1], profile[2], profile[3], profile[0] }, false);
  const PlaneCurve before = SplineThrough({ profile[2], profile[3], profile[0] }, false);
  PlaneCurve through = before;
  const PlaneCurve after = SplineThrough({ profile[0], profile[1], profile[2] }, false);
  through.points.insert(through.points.end(), after.points.begin() + 1, after.points.end());
  through.weights.insert(through.weights.end(), after.weights.begin() + 1, after.weights.end());
  const double length = before.knots.back();
  through.knots.pop_back();
  for (std::size_t i = static_cast<std::size_t>(after.degree) + 1; i < after.knots.size(); ++i)
  {
    through.knots.push_back(after.knots[i] + length);
  }
  for (const PlaneCurve& data : { fromTip, through })
  {
    const CurveEvaluator curve(data);
    const double tip = curve.Nearest(profile[0]);
    for (const double distance : { 1e-5, 1e-3, 0.03 })
    {
      for (const double side : { -distance, distance })
      {
        const Point place = curve.At(tip + side);
        EXPECT_LT((curve.At(curve.Nearest(place)) - place).norm(), 1e-14) << side;
      }
    }
  }
}

TEST(CurveEvaluator, RefusesCurvesThatAreNotValid)
{
  PlaneCurve curve = CircleAsNurbs();
  curve.knots.pop_back();
  EXPECT_THROW(CurveEvaluator{ curve }, Error);
  curve = CircleAsNurbs();
  curve.weights[3] = 0.0;
  EXPECT_THROW(CurveEvaluator{ curve }, Error);
  EXPECT_THROW(CurveEvaluator{ PlaneCurve() }, Error);
}
}
}
