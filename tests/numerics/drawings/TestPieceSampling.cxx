#include "PieceSampling.h"

#include "CurvePieces.h"
#include "DrawingChecks.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
/// Returns the distance of a point from a segment's line.
double Distance(const Point& point, const Point& first, const Point& last)
{
  return std::abs(Cross(last - first, point - first)) / (last - first).norm();
}

TEST(PieceSampling, KeepsTheRuleOnEveryCurve)
{
  Random random(41);
  SamplingRule rule;
  rule.distance = 1e-3;
  rule.shortest = 1e-5;
  for (int trial = 0; trial < 200; ++trial)
  {
    const DrawingPiece piece = RandomPiece(random, trial % 4);
    const std::vector<double> parameters = SampleParameters(piece, rule);
    EXPECT_EQ(parameters.front(), piece.begin);
    EXPECT_EQ(parameters.back(), piece.end);
    for (std::size_t i = 1; i < parameters.size(); ++i)
    {
      const Point first = PointAt(piece, parameters[i - 1]);
      const Point last = PointAt(piece, parameters[i]);
      if ((last - first).norm() < rule.shortest)
      {
        continue;
      }
      double turn = 0.0;
      Point before = Point::Zero();
      Point previous = first;
      for (int k = 1; k <= 16; ++k)
      {
        const Point here =
          PointAt(piece, parameters[i - 1] + (parameters[i] - parameters[i - 1]) * k / 16);
        EXPECT_LT(Distance(here, first, last), 1.3 * rule.distance) << "trial " << trial;
        turn += k > 1 ? std::abs(AngleBetween(before, here - previous)) : 0.0;
        before = here - previous;
        previous = here;
      }
      EXPECT_LT(turn, 1.5 * rule.turn) << "trial " << trial;
    }
  }
}

TEST(PieceSampling, DividesCirclesEvenlyAndSymmetrically)
{
  SamplingRule rule;
  rule.distance = 1.0;
  const DrawingPiece circle = ArcPiece({ 0, 0 }, 1.0, 0, 360, "circle");
  EXPECT_EQ(SampleParameters(circle, rule).size(), 73U); // 5° each
  rule.distance = 1e-4;
  const std::size_t count = SampleParameters(circle, rule).size() - 1;
  EXPECT_EQ(count % 8, 0U);
  EXPECT_LE(1.0 - std::cos(Pi / static_cast<double>(count)), 1e-4);
  EXPECT_GT(1.0 - std::cos(Pi / static_cast<double>(count - 8)), 1e-4);
  const DrawingPiece quarter = ArcPiece({ 0, 0 }, 1.0, 0, 90, "arc");
  rule.distance = 1.0;
  EXPECT_EQ(SampleParameters(quarter, rule).size(), 19U);
}

TEST(PieceSampling, EndsAtACusp)
{
  // The derivative vanishes in the middle.
  const DrawingPiece cusp = BezierPiece({ { 0, 0 }, { 1, 1 }, { 0, 1 }, { 1, 0 } });
  SamplingRule rule;
  rule.distance = 1e-4;
  rule.shortest = 1e-6;
  const std::size_t count = SampleParameters(cusp, rule).size();
  EXPECT_GT(count, 20U);
  EXPECT_LT(count, 500U);
}

TEST(PieceSampling, LimitsTheNumberOfPoints)
{
  DrawingPiece circle = ArcPiece({ 0, 0 }, 1.0, 0, 360, "circle");
  circle.curve.kind = PlaneCurve::Kind::Ellipse;
  circle.origin = "the ELLIPSE of line 5";
  SamplingRule rule;
  rule.turn = 1e-7;
  rule.distance = 1.0;
  EXPECT_TRUE(Refuses([&] { SampleParameters(circle, rule); }, { "ELLIPSE of line 5", "million" }));
}

TEST(PieceSampling, MeasuresLengths)
{
  EXPECT_NEAR(ApproximateLength(ArcPiece({ 5, 5 }, 2.0, 0, 90, "arc")), Pi, 0.01 * Pi);
  EXPECT_EQ(ApproximateLength(LinePiece({ 0, 0 }, { 3, 4 })), 5.0);
}
}
}
