#include "Drawing.h"

#include "CurvePieces.h"
#include "DrawingChecks.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
TEST(Drawing, TransformsEveryCurveExactly)
{
  Random random(31);
  for (int trial = 0; trial < 400; ++trial)
  {
    const DrawingPiece piece = RandomPiece(random, trial % 4);
    AffineMap map;
    for (Eigen::Index i = 0; i < 6; ++i)
    {
      map(i % 2, i / 2) = random.Uniform(-2, 2);
    }
    if (std::abs(map.leftCols<2>().determinant()) < 0.1)
    {
      continue;
    }
    DrawingPiece image = piece;
    Transform(map, image);
    const std::vector<Point> before = PointsOf(piece);
    const std::vector<Point> after = PointsOf(image);
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      EXPECT_LT((after[i] - Apply(map, before[i])).norm(), 1e-12) << "trial " << trial;
    }
  }
}

TEST(Drawing, KeepsCirclesUnderSimilarities)
{
  AffineMap map;
  map << 0.6, 0.8, 3.0, 0.8, -0.6, 1.0; // a reflection
  DrawingPiece arc = ArcPiece({ 1.0, 2.0 }, 2.0, 0.0, 90.0, "arc");
  Transform(map, arc);
  EXPECT_EQ(arc.curve.kind, PlaneCurve::Kind::Circle);
  EXPECT_NEAR(arc.curve.axis.norm(), 2.0, 1e-15);
  EXPECT_LT(arc.end, arc.begin); // clockwise
  map.col(1) *= 0.5;
  Transform(map, arc);
  EXPECT_EQ(arc.curve.kind, PlaneCurve::Kind::Ellipse);
}

TEST(Drawing, RefusesAFlatImage)
{
  AffineMap map = IdentityMap();
  map(1, 1) = 0.0;
  DrawingPiece arc = ArcPiece({ 1.0, 2.0 }, 2.0, 0.0, 90.0, "arc");
  arc.origin = "the ARC of line 3";
  EXPECT_TRUE(Refuses([&] { Transform(map, arc); }, { "ARC of line 3" }));
}

TEST(Drawing, EvaluatesARationalCurveAsTheCircleThatItIs)
{
  const double weight = std::sqrt(0.5);
  const DrawingPiece quarter = NurbsPiece(2, { 0, 0, 0, 1, 1, 1 },
    { { 1e9 + 1, 0 }, { 1e9 + 1, 1 }, { 1e9, 1 } }, { 1, weight, 1 }, "spline");
  for (const Point& point : PointsOf(quarter))
  {
    EXPECT_NEAR((point - Point(1e9, 0)).norm(), 1.0, 3e-7); // half a unit in the last place of 1e9
  }
  EXPECT_EQ(quarter.first, Point(1e9 + 1, 0));
  EXPECT_EQ(quarter.last, Point(1e9, 1));
}

TEST(Drawing, ArcsEndExactlyAtMultiplesOf90Degrees)
{
  const DrawingPiece arc = ArcPiece({ 0.1, 0.2 }, 3.0, 270.0, 180.0, "arc");
  EXPECT_EQ(arc.first, Point(0.1, 0.2 - 3.0));
  EXPECT_EQ(arc.last, Point(0.1 - 3.0, 0.2));
  EXPECT_DOUBLE_EQ(arc.end - arc.begin, 1.5 * Pi);
}

TEST(Drawing, BulgesAreArcsThroughBothEnds)
{
  Random random(32);
  for (int trial = 0; trial < 100; ++trial)
  {
    const Point first(random.Uniform(-1, 1), random.Uniform(-1, 1));
    const Point last(random.Uniform(-1, 1), random.Uniform(-1, 1));
    const double bulge = random.Uniform(-3, 3);
    const DrawingPiece arc = BulgePiece(first, last, bulge);
    const double radius = arc.curve.axis.norm();
    EXPECT_NEAR((last - arc.curve.centre).norm(), radius, 1e-12 * radius);
    // The sagitta is half the bulge times the chord, to the right of a positive bulge.
    const Point middle = PointAt(arc, 0.5 * (arc.begin + arc.end)) - 0.5 * (first + last);
    EXPECT_NEAR(Cross(last - first, middle), -0.5 * bulge * (last - first).squaredNorm(), 1e-9);
  }
}

TEST(Drawing, RefusesCurvesThatAreNone)
{
  const auto nurbs = [](int degree, const std::vector<double>& knots,
                       const std::vector<double>& weights) {
    NurbsPiece(degree, knots, { { 0, 0 }, { 1, 0 }, { 1, 1 } }, weights, "the SPLINE of line 7");
  };
  EXPECT_TRUE(Refuses([&] { nurbs(0, { 0, 0, 1, 1 }, {}); }, { "degree", "line 7" }));
  EXPECT_TRUE(Refuses([&] { nurbs(3, { 0, 0, 0, 0, 1, 1, 1, 1 }, {}); }, { "control points" }));
  EXPECT_TRUE(Refuses([&] { nurbs(2, { 0, 0, 0, 1, 1 }, {}); }, { "5 knots instead of 6" }));
  EXPECT_TRUE(Refuses([&] { nurbs(2, { 0, 0, 1, 0, 1, 1 }, {}); }, { "decrease" }));
  EXPECT_TRUE(Refuses([&] { nurbs(2, { 0, 0, 0, 0, 0, 0 }, {}); }, { "empty" }));
  EXPECT_TRUE(Refuses([&] { nurbs(2, { 0, 0, 0, 1, 1, 1 }, { 1, 0, 1 }); }, { "weight" }));
  EXPECT_TRUE(Refuses([] { ArcPiece({ 0, 0 }, 0.0, 0, 90, "the ARC"); }, { "radius" }));
  EXPECT_TRUE(Refuses(
    [] {
      EllipsePiece({ 0, 0 }, { 1, 0 }, -1.0, 0, 1, "the ELLIPSE");
    },
    { "axis" }));
  EXPECT_TRUE(Refuses(
    [] {
      EllipsePiece({ 0, 0 }, { 1, 0 }, 1.0, 0, 1e300, "the ELLIPSE");
    },
    { "1000" }));
}
}
}
