// Declared, given and recognised curves of domains, sampling, and errors.

#include "BoundaryPieces.h"

#include "CurveEvaluator.h"
#include "CurveSampling.h"
#include "CurvedLoops.h"
#include "Error.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
using Kind = CurveDeclaration::Kind;

Loop Circle(int count, double radius, double direction)
{
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    const double angle = direction * 2.0 * Pi * i / count;
    loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return loop;
}

/// A square with a hole of few points, named 'hole' or 'front' and 'back'.
PlanarDomain Plate(int count)
{
  return { { { { -2, -2 }, { 2, -2 }, { 2, 2 }, { -2, 2 } }, Circle(count, 1.0, -1.0) } };
}

BoundarySides Named(const PlanarDomain& domain, bool isDivided = false)
{
  SegmentNames names = { std::vector<std::string>(4, "wall"), {} };
  for (std::size_t i = 0; i < domain.loops[1].size(); ++i)
  {
    names[1].push_back(isDivided && 2 * i >= domain.loops[1].size() ? "back" : "hole");
  }
  return NameSides(domain, names);
}

CurveRequest Request(const std::vector<CurveDeclaration>& declared, bool findsArcs = false)
{
  CurveRequest request;
  request.declared = declared;
  request.findsArcs = findsArcs;
  return request;
}

std::string MessageOf(const PlanarDomain& domain, const CurveRequest& request)
{
  try
  {
    FindCurves(domain, Named(domain), request);
  }
  catch (const Error& error)
  {
    return error.what();
  }
  return {};
}

TEST(BoundaryPieces, ADeclaredCircleMayHaveFewPoints)
{
  const PlanarDomain domain = Plate(6); // turns by 60° at each vertex
  const CurvesOfSegments found =
    FindCurves(domain, Named(domain), Request({ { "hole", Kind::Circle } }));
  ASSERT_EQ(found.curves.size(), 1U);
  EXPECT_NEAR(found.curves[0].axis.norm(), 1.0, 1e-14);
  EXPECT_EQ(found.ofSegment[0], std::vector<int>(4, -1));
  EXPECT_EQ(found.ofSegment[1], std::vector<int>(6, 0));
}

TEST(BoundaryPieces, EveryPieceOfASideHasItsOwnCircle)
{
  const PlanarDomain domain = Plate(16);
  const CurvesOfSegments found = FindCurves(
    domain, Named(domain, true), Request({ { "hole", Kind::Circle }, { "back", Kind::Circle } }));
  EXPECT_EQ(found.curves.size(), 2U);
  const CurvedBoundary boundary = PiecesOf(domain, found);
  EXPECT_EQ(boundary.starts.size(), 2U);
}

TEST(BoundaryPieces, ALineIsNotRecognisedAsAnArc)
{
  const PlanarDomain domain = Plate(16);
  EXPECT_EQ(FindCurves(domain, Named(domain), Request({}, true)).curves.size(), 1U);
  EXPECT_TRUE(
    FindCurves(domain, Named(domain), Request({ { "hole", Kind::Line } }, true)).curves.empty());
}

TEST(BoundaryPieces, DeclarationsComeBeforeGivenCurves)
{
  const PlanarDomain domain = Plate(16);
  CurvesOfSegments given = FindCurves(domain, Named(domain), Request({ { "hole", Kind::Circle } }));
  EXPECT_EQ(FindCurves(domain, Named(domain), {}, given).curves[0].kind, PlaneCurve::Kind::Circle);
  EXPECT_EQ(
    FindCurves(domain, Named(domain), Request({ { "hole", Kind::Spline } }), given).curves[0].kind,
    PlaneCurve::Kind::Nurbs);
  given.curves[0].centre.x() += 1e-4;
  EXPECT_THROW(FindCurves(domain, Named(domain), {}, given), Error);
}

TEST(BoundaryPieces, ASplineIsCutAtCorners)
{
  const PlanarDomain domain = Plate(16);
  const CurvesOfSegments found =
    FindCurves(domain, Named(domain), Request({ { "wall", Kind::Spline } }));
  EXPECT_TRUE(found.curves.empty()); // four lines
}

TEST(BoundaryPieces, ErrorsNameTheSideTheDistanceAndARemedy)
{
  PlanarDomain domain = Plate(16);
  domain.loops[1][3] *= 1.01;
  const std::string miss = MessageOf(domain, Request({ { "hole", Kind::Circle } }));
  EXPECT_NE(
    miss.find("Side 'hole' is no circle: the nearest one misses the point ("), std::string::npos)
    << miss;
  EXPECT_NE(miss.find("; declare another curve for it, or spline."), std::string::npos) << miss;
  EXPECT_NE(
    MessageOf(Plate(16), Request({ { "wall", Kind::Ellipse } })).find("declared as ellipse"),
    std::string::npos);
  EXPECT_NE(MessageOf(Plate(16), Request({ { "hose", Kind::Circle } })).find("no side 'hose'"),
    std::string::npos);
  EXPECT_NE(MessageOf(Plate(16), Request({ { "hole", Kind::Circle }, { "hole", Kind::Line } }))
              .find("two curves"),
    std::string::npos);
}

TEST(CurveSampling, DividesCoarsePolygonsAndKeepsTheirSymmetry)
{
  const PlanarDomain domain = Plate(16);
  const CurvesOfSegments curves =
    FindCurves(domain, Named(domain), Request({ { "hole", Kind::Circle } }));
  const SampledDomain sampled =
    SampleCurves(domain, Named(domain), curves, { 0.5, 0.05 }, { { 0.5, 0.5 } });
  const Loop& hole = sampled.domain.loops[1];
  EXPECT_EQ(sampled.domain.loops[0], domain.loops[0]);
  EXPECT_EQ(hole.size(), 80U); // parts of 4.5° each
  for (const Point& point : hole)
  {
    EXPECT_NEAR(point.norm(), 1.0, 1e-15);
    const bool isMirrored = std::any_of(hole.begin(), hole.end(),
      [&](const Point& other) { return (other - Point(point.y(), point.x())).norm() < 1e-14; });
    EXPECT_TRUE(isMirrored);
  }
  EXPECT_EQ(sampled.kept[0], Point(0.5, 0.5)); // not on the boundary
}

TEST(CurveSampling, PointsOfThePolygonMoveOntoTheCurve)
{
  const PlanarDomain domain = Plate(16);
  const CurvesOfSegments curves =
    FindCurves(domain, Named(domain), Request({ { "hole", Kind::Circle } }));
  const Point middle = 0.5 * (domain.loops[1][0] + domain.loops[1][1]);
  const SampledDomain sampled = SampleCurves(
    domain, Named(domain), curves, { 0.5, 0.05 }, { middle, domain.loops[1][2], { 0.0, 2.0 } });
  EXPECT_NEAR((sampled.kept[0] - middle.normalized()).norm(), 0.0, 1e-14);
  const Loop& hole = sampled.domain.loops[1];
  EXPECT_NE(std::find(hole.begin(), hole.end(), sampled.kept[0]), hole.end());
  EXPECT_EQ(sampled.kept[1], domain.loops[1][2]);
  EXPECT_EQ(sampled.kept[2], Point(0.0, 2.0));
}

TEST(CurvedLoops, FollowTheCurveFromCoarseAndFromDividedPolygons)
{
  const PlanarDomain domain = Plate(16);
  const CurvedBoundary boundary =
    PiecesOf(domain, FindCurves(domain, Named(domain), Request({ { "hole", Kind::Circle } })));
  Loop divided;
  for (std::size_t i = 0; i < 16; ++i)
  {
    divided.push_back(domain.loops[1][i]);
    divided.push_back(0.5 * (domain.loops[1][i] + domain.loops[1][(i + 1) % 16])); // beside it
  }
  for (const Loop& loop : { domain.loops[1], divided })
  {
    const LoopArc arc(loop);
    const CurvedLoops curved(boundary, { LoopArc(domain.loops[0]), arc });
    for (int i = 0; i < 500; ++i)
    {
      const double at = arc.Length() * i / 500;
      const Point place = curved.At(arc, 1, at);
      EXPECT_NEAR(place.norm(), 1.0, 1e-14);
      const double h = 1e-6;
      const Point difference = (curved.At(arc, 1, at + h) - place) / h;
      EXPECT_LT((difference - curved.Derivative(arc, 1, at)).norm(), 2e-2);
      EXPECT_NEAR(
        (curved.At(arc, 1, curved.Nearest(arc, 1, 1.1 * place)) - place).norm(), 0.0, 1e-9);
    }
    EXPECT_EQ(curved.CurveAt(LoopArc(domain.loops[0]), 0, 1.0), -1);
  }
}
}
}
