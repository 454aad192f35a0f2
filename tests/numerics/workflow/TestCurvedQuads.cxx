// Quads of domains with curves: nodes are on them, with layers and prescribed counts, in every
// position.

#include "QuadWorkflow.h"

#include "BoundaryCorners.h"
#include "CurveEvaluator.h"
#include "Error.h"
#include "Index.h"
#include "MakePlanarDomain.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace crossfield::test
{
namespace
{
using Kind = CurveDeclaration::Kind;

/// A plate with a hole of given points, whose segments are the side 'hole'.
struct Part
{
  PlanarDomain domain;
  QuadRequest request;
};

Part PlateWith(const Loop& hole, Kind kind)
{
  Part part;
  part.domain = MakePlanarDomain({ { { -3, -2.5 }, { 3, -2.5 }, { 3, 2.5 }, { -3, 2.5 } }, hole });
  SegmentNames names = { { "bottom", "right", "top", "left" },
    std::vector<std::string>(hole.size(), "hole") };
  part.request.sides = NameSides(part.domain, names);
  part.request.sideRequests = { CurveOf("hole", kind) };
  part.request.quadCount = 300;
  part.request.sizing = Sizing::Conformal;
  return part;
}

Loop EllipseOf(std::mt19937& random, int count)
{
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  const double a = 0.6 + 0.8 * unit(random);
  const double b = a * (0.3 + 0.7 * unit(random));
  const double angle = Pi * unit(random);
  const Point centre(0.6 * unit(random) - 0.3, 0.4 * unit(random));
  Loop loop;
  for (int i = 0; i < count; ++i)
  {
    const double t = 2.0 * Pi * i / count;
    const Point at(a * std::cos(t), b * std::sin(t));
    loop.push_back(centre +
      Point(std::cos(angle) * at.x() - std::sin(angle) * at.y(),
        std::sin(angle) * at.x() + std::cos(angle) * at.y()));
  }
  return loop;
}

/// Returns the largest distance of nodes of curved boundary edges from their curve, and counts them.
double LargestDistance(const QuadWorkflowResult& result, int& edges)
{
  edges = 0;
  double largest = 0.0;
  for (const QuadBoundaryEdge& edge : result.quads.mesh.boundary)
  {
    if (edge.curve < 0)
    {
      continue;
    }
    ++edges;
    const CurveEvaluator curve(result.boundary.curves[Index(edge.curve)]);
    for (const int point : edge.points)
    {
      const Point place = result.quads.mesh.points[Index(point)].InPlane();
      largest = std::max(largest, (curve.At(curve.Nearest(place)) - place).norm());
    }
  }
  return largest;
}

/// Returns the largest distance of the corners of a domain from the nearest node.
double CornerDistance(const PlanarDomain& domain, const QuadMesh& mesh)
{
  double largest = 0.0;
  for (const Corner& corner : FindCorners({ domain.loops[0] }))
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const QuadPoint& point : mesh.points)
    {
      nearest = std::min(nearest, (point.InPlane() - corner.position).norm());
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(CurvedQuads, NodesAreOnRandomEllipsesAndSplines)
{
  std::mt19937 random(2024);
  for (int trial = 0; trial < 8; ++trial)
  {
    const Kind kind = trial % 2 == 0 ? Kind::Ellipse : Kind::Spline;
    Part part = PlateWith(EllipseOf(random, 48 + trial), kind);
    if (trial % 4 >= 2)
    {
      part.request.sizing = Sizing::Uniform; // moves all nodes far
    }
    const QuadWorkflowResult result = MakeQuadMesh(part.domain, part.request);
    int edges = 0;
    EXPECT_LT(LargestDistance(result, edges), 1e-12 * part.domain.Diagonal()) << trial;
    EXPECT_GT(edges, 8);
    EXPECT_EQ(CornerDistance(part.domain, result.quads.mesh), 0.0);
    EXPECT_EQ(result.quads.quality.inverted, 0);
    ASSERT_EQ(result.curves.size(), 1U);
    EXPECT_EQ(result.curves[0].edges, edges);
    EXPECT_GT(result.curves[0].moved, 1e-4); // of the chords of 48 points
    EXPECT_LT(result.curves[0].moved, 0.05);
  }
}

TEST(CurvedQuads, NodesAreOnGivenCurves)
{
  PlaneCurve nurbs;
  nurbs.kind = PlaneCurve::Kind::Nurbs;
  nurbs.degree = 2;
  nurbs.knots = { 0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4 };
  for (int i = 0; i < 9; ++i)
  {
    const double angle = -0.25 * Pi * i;
    const double radius = i % 2 == 0 ? 1.0 : std::sqrt(2.0);
    nurbs.points.emplace_back(radius * std::cos(angle), 0.8 * radius * std::sin(angle));
    nurbs.weights.push_back(i % 2 == 0 ? 1.0 : std::sqrt(0.5));
  }
  const CurveEvaluator curve(nurbs);
  Loop hole;
  for (int i = 0; i < 20; ++i)
  {
    hole.push_back(curve.At(0.2 * i));
  }
  Part part = PlateWith(hole, Kind::Line);
  part.request.sideRequests.clear();
  part.request.givenCurves.curves = { nurbs };
  part.request.givenCurves.ofSegment = { std::vector<int>(4, -1), std::vector<int>(20, 0) };
  int edges = 0;
  EXPECT_LT(LargestDistance(MakeQuadMesh(part.domain, part.request), edges), 1e-12);
  EXPECT_GT(edges, 8);
}

TEST(CurvedQuads, LayersAndCountsKeepNodesOnCurves)
{
  std::mt19937 random(7);
  Part part = PlateWith(EllipseOf(random, 40), Kind::Ellipse);
  part.request.quadCount = 800;
  part.request.sideRequests.push_back(LayerOf("hole", 2e-3));
  const QuadWorkflowResult layered = MakeQuadMesh(part.domain, part.request);
  int edges = 0;
  EXPECT_LT(LargestDistance(layered, edges), 1e-12 * part.domain.Diagonal());
  ASSERT_EQ(layered.layers.size(), 1U);
  EXPECT_NEAR(layered.layers[0].minimumHeight, 2e-3, 1e-4);

  part.request.sideRequests.back() = CountOf("hole", 48);
  LargestDistance(MakeQuadMesh(part.domain, part.request), edges);
  EXPECT_EQ(edges, 48);
}

TEST(CurvedQuads, EdgesThatArePlacedAnewAreOfTheCurveWhereTheyAre)
{
  // A side of two lines and the arc between them, with edges of one length.
  Loop loop = { { 4.0, 0.0 }, { 4.0, 2.0 }, { 0.0, 2.0 } };
  std::vector<std::string> names = { "right", "top" };
  constexpr int Steps = 24;
  Loop arc;
  for (int i = 0; i <= Steps; ++i)
  {
    const double angle = Pi + 0.5 * Pi * i / Steps;
    arc.push_back(Point(0.5, 0.5) + 0.5 * Point(std::cos(angle), std::sin(angle)));
  }
  loop.insert(loop.end(), arc.begin(), arc.end());
  names.resize(loop.size(), "inside");
  QuadRequest request;
  const PlanarDomain plate = MakePlanarDomain({ loop });
  request.sides = NameSides(plate, { names });
  request.findsArcs = true;
  request.quadSize = 0.2;
  for (const double size : { 0.06, 0.1, 0.14 })
  {
    request.sideRequests = { SizeOf("inside", size) };
    const QuadWorkflowResult result = MakeQuadMesh(plate, request);
    int curved = 0;
    for (const QuadBoundaryEdge& edge : result.quads.mesh.boundary)
    {
      const Point from = result.quads.mesh.points[Index(edge.points[0])].InPlane();
      const Point to = result.quads.mesh.points[Index(edge.points[1])].InPlane();
      double distance = std::numeric_limits<double>::infinity();
      for (const Point& place : arc)
      {
        distance = std::min(distance, (0.5 * (from + to) - place).norm());
      }
      curved += edge.curve >= 0 ? 1 : 0;
      EXPECT_TRUE(edge.curve < 0 || distance < 0.6 * (to - from).norm()) << Describe(from);
    }
    EXPECT_GE(curved, 4);
  }
}

TEST(CurvedQuads, ACoarsePolygonGivesTheMeshOfAFineOne)
{
  const auto circle = [](int count)
  {
    Loop loop;
    for (int i = 0; i < count; ++i)
    {
      loop.emplace_back(std::cos(2.0 * Pi * i / count), std::sin(2.0 * Pi * i / count));
    }
    return loop;
  };
  const Part coarse = PlateWith(circle(8), Kind::Circle);
  const Part fine = PlateWith(circle(64), Kind::Circle);
  const QuadWorkflowResult a = MakeQuadMesh(coarse.domain, coarse.request);
  const QuadWorkflowResult b = MakeQuadMesh(fine.domain, fine.request);
  ASSERT_EQ(a.quads.mesh.quads.size(), b.quads.mesh.quads.size());
  ASSERT_EQ(a.singularities.size(), b.singularities.size());
  EXPECT_NEAR(a.quads.quality.jacobian.min, b.quads.quality.jacobian.min, 0.02);
  EXPECT_NEAR(a.curves[0].moved, 1.0 - std::cos(Pi / 8), 1e-2);
}

TEST(CurvedQuads, TurnedAndScaledPartsHaveTheSameMesh)
{
  std::mt19937 random(99);
  const Loop hole = EllipseOf(random, 30);
  const double scale = 1e-3;
  const auto moved = [scale](const Point& point)
  {
    return Point(scale * (0.8 * point.x() - 0.6 * point.y()) + 5.0 * scale,
      scale * (0.6 * point.x() + 0.8 * point.y()));
  };
  Part part = PlateWith(hole, Kind::Ellipse);
  Part other = part;
  for (Loop& loop : other.domain.loops)
  {
    std::transform(loop.begin(), loop.end(), loop.begin(), moved);
  }
  for (SideStart& start : other.request.sides.starts)
  {
    start.place = moved(start.place);
  }
  const QuadWorkflowResult a = MakeQuadMesh(part.domain, part.request);
  const QuadWorkflowResult b = MakeQuadMesh(other.domain, other.request);
  ASSERT_EQ(a.quads.mesh.points.size(), b.quads.mesh.points.size());
  double largest = 0.0;
  for (const QuadPoint& point : a.quads.mesh.points) // whose order may differ
  {
    const Point place = moved(point.InPlane());
    double nearest = std::numeric_limits<double>::infinity();
    for (const QuadPoint& candidate : b.quads.mesh.points)
    {
      nearest = std::min(nearest, (candidate.InPlane() - place).norm() / scale);
    }
    largest = std::max(largest, nearest);
  }
  // Triangles may differ, and smoothing stops within a hundredth of a quad.
  EXPECT_LT(largest, 0.03 * a.quads.size);
}

TEST(CurvedQuads, SingularitiesOfThePolygonsBoundaryMoveOntoTheCurve)
{
  Loop hole;
  for (int i = 0; i < 12; ++i)
  {
    hole.emplace_back(std::cos(2.0 * Pi * i / 12), std::sin(2.0 * Pi * i / 12));
  }
  Part part = PlateWith(hole, Kind::Circle);
  // A boundary node with three quads on the hole in the middle of a segment, and one inside less.
  const Point middle = 0.5 * (hole[0] + hole[1]);
  part.request.singularities = Configuration{ { middle, -1 }, { { -1.6, 1.6 }, -1 },
    { { -1.6, -1.6 }, -1 }, { { 1.6, -1.6 }, -1 } };
  const QuadWorkflowResult result = MakeQuadMesh(part.domain, part.request);
  int edges = 0;
  EXPECT_LT(LargestDistance(result, edges), 1e-12);
  EXPECT_NEAR((result.singularities[0].position - middle.normalized()).norm(), 0.0, 1e-12);
}
}
}
