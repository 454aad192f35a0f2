// Counts, progressions and sizes that are prescribed for sides hold exactly, on random parts too.

#include "PrescribedSides.h"

#include "BoundaryCorners.h"
#include "Index.h"
#include "MakePlanarDomain.h"
#include "QuadSides.h"
#include "QuadWorkflow.h"
#include "RandomSides.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
/// Returns the arc lengths of the edges along each piece of a side.
std::vector<std::vector<double>> EdgesOf(const QuadMesh& mesh, const PlanarDomain& domain, int side)
{
  std::vector<std::vector<double>> edges;
  for (const std::vector<int>& piece : PiecesOf(mesh, side))
  {
    edges.emplace_back();
    for (std::size_t i = 1; i < piece.size(); ++i)
    {
      const CurvePlace& from = mesh.points[static_cast<std::size_t>(piece[i - 1])].curve;
      const CurvePlace& to = mesh.points[static_cast<std::size_t>(piece[i])].curve;
      double loop = 0.0;
      for (const Loop& candidate : domain.loops)
      {
        const LoopArc arc(candidate);
        const Point place = mesh.points[static_cast<std::size_t>(piece[i])].InPlane();
        loop = arc.Find(place, 1e-9 * domain.Diagonal()) >= 0.0 ? arc.Length() : loop;
      }
      const double length = to.at - from.at;
      edges.back().push_back(length - loop * std::floor(length / loop));
    }
  }
  return edges;
}

/// Returns the arc lengths of the edges along each part of a side between corners and ends.
std::vector<std::vector<double>> PartsOf(
  const QuadMesh& mesh, const PlanarDomain& domain, const BoundarySides& sides, int side)
{
  std::vector<Point> ends = sides.FixedPlaces();
  for (const Corner& corner : FindCorners(domain.loops))
  {
    ends.push_back(corner.position);
  }
  const std::vector<std::vector<double>> lengths = EdgesOf(mesh, domain, side);
  const std::vector<std::vector<int>> pieces = PiecesOf(mesh, side);
  std::vector<std::vector<double>> parts;
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    parts.emplace_back();
    const std::size_t first = parts.size() - 1;
    bool startsAtEnd = false;
    for (std::size_t i = 0; i < lengths[piece].size(); ++i)
    {
      const Point place = mesh.points[static_cast<std::size_t>(pieces[piece][i])].InPlane();
      const bool isEnd = std::any_of(ends.begin(), ends.end(),
        [&](const Point& end) { return (end - place).norm() < 1e-9 * domain.Diagonal(); });
      startsAtEnd = startsAtEnd || (i == 0 && isEnd);
      if (i > 0 && isEnd)
      {
        parts.emplace_back();
      }
      parts.back().push_back(lengths[piece][i]);
    }
    if (!startsAtEnd && parts.size() - 1 > first) // a closed curve that does not start at a corner
    {
      parts[first].insert(parts[first].begin(), parts.back().begin(), parts.back().end());
      parts.pop_back();
    }
  }
  return parts;
}

/// Returns a rectangle with named sides.
PlanarDomain Rectangle()
{
  return MakePlanarDomain({ { { 0, 0 }, { 3, 0 }, { 3, 1 }, { 0, 1 } } });
}

BoundarySides RectangleSides()
{
  return NameSides(Rectangle(), { { "bottom", "right", "top", "left" } });
}

}

TEST(SidePrescription, EdgesWithinInvertsDivideLength)
{
  Random random(5);
  for (int run = 0; run < 200; ++run)
  {
    Progression progression;
    progression.ratio = std::exp(random.Uniform(-3.0, 3.0));
    progression.both = random.Integer(0, 1) == 1;
    // towards both ends the middle is a point only for even numbers
    const int count = 2 * random.Integer(2, 30);
    const double length = random.Uniform(0.1, 10.0);
    const std::vector<double> places = DivideLength(length, count, progression);
    ASSERT_EQ(places.size(), static_cast<std::size_t>(count) + 1);
    EXPECT_EQ(places.back(), length);
    for (std::size_t i = 0; i < places.size(); ++i)
    {
      EXPECT_NEAR(EdgesWithin(places[i], length, count, progression), static_cast<double>(i), 1e-9);
    }
    const std::size_t last = progression.both ? places.size() / 2 : places.size() - 1;
    EXPECT_NEAR((places[last] - places[last - 1]) / (places[1] - places[0]), progression.ratio,
      1e-9 * progression.ratio);
  }
}

TEST(SidePrescription, CountForLengthsHasTheseLengths)
{
  Random random(6);
  for (int run = 0; run < 100; ++run)
  {
    Progression progression;
    const int count = random.Integer(2, 40);
    progression.first = random.Uniform(0.01, 0.2);
    progression.last = progression.first * std::exp(random.Uniform(-2.0, 2.0));
    const double q = std::pow(progression.last / progression.first, 1.0 / (count - 1));
    double length = 0.0;
    for (int i = 0; i < count; ++i)
    {
      length += progression.first * std::pow(q, i);
    }
    EXPECT_EQ(CountForLengths(length, progression), count);
    const std::vector<double> places = DivideLength(length, count, progression);
    EXPECT_NEAR(places[1], progression.first, 1e-9);
  }
}

TEST(PrescribedSides, CountsThatCanBeMetAreMet)
{
  Random random(3);
  int prescribed = 0;
  for (int run = 0; run < 40; ++run)
  {
    SCOPED_TRACE(run);
    const PlanarDomain domain = RandomPart(random);
    QuadRequest request;
    request.sides = NameSides(domain, RandomNames(random, domain, 4));
    request.quadCount = random.Integer(150, 1200);
    const QuadWorkflowResult other = MakeQuadMesh(domain, request);
    // The same separatrices with another number of quads: these counts are possible.
    const std::vector<SideMeasure> measures = MeasureSides(other.quads.mesh);
    request.singularities = other.singularities;
    request.quadCount = random.Integer(150, 1200);
    for (int side = 0; side < static_cast<int>(measures.size()); ++side)
    {
      if (random.Integer(0, 1) == 1)
      {
        request.sideRequests.push_back(
          CountOf(request.sides.names[Index(side)], measures[Index(side)].edges));
      }
    }
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    EXPECT_EQ(result.quads.quality.inverted, 0);
    const std::vector<SideMeasure> found = MeasureSides(result.quads.mesh);
    for (const SideRequest& one : request.sideRequests)
    {
      EXPECT_EQ(found[Index(request.sides.Find(one.side))].edges, one.count);
      ++prescribed;
    }
  }
  EXPECT_GT(prescribed, 60);
}

TEST(PrescribedSides, OddCountsAroundAHole)
{
  const PlanarDomain domain = MakePlanarDomain(
    { { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 0, 2 } }, RegularPolygon(60, 0.4, { 1.4, 1.0 }) });
  for (const int count : { 17, 24, 33 })
  {
    QuadRequest request;
    request.quadCount = 500;
    request.sideRequests = { CountOf("hole0", count), CountOf("outer0", 29) };
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    ASSERT_EQ(result.quads.mesh.sideNames[4], "hole0");
    const std::vector<SideMeasure> found = MeasureSides(result.quads.mesh);
    EXPECT_EQ(found[4].edges, count);
    EXPECT_EQ(found[0].edges, 29);
    EXPECT_EQ(result.quads.quality.inverted, 0);
  }
}

TEST(PrescribedSides, EveryMergeKeepsCounts)
{
  const PlanarDomain domain = MakePlanarDomain({ { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 0, 2 } },
    RegularPolygon(60, 0.3, { 0.9, 1.1 }), RegularPolygon(60, 0.3, { 2.1, 0.9 }) });
  for (const BlockMerge merge : { BlockMerge::None, BlockMerge::Clean, BlockMerge::Coarse })
  {
    QuadRequest request;
    request.quadCount = 600;
    request.merge = merge;
    request.sideRequests = { CountOf("outer0", 31), CountOf("hole1", 22) };
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    const std::vector<SideMeasure> found = MeasureSides(result.quads.mesh);
    EXPECT_EQ(found[0].edges, 31);
    EXPECT_EQ(found[5].edges, 22);
    EXPECT_EQ(result.quads.quality.inverted, 0);
  }
}

TEST(PrescribedSides, ProgressionsAreGeometric)
{
  for (const double ratio : { 0.2, 6.0 })
  {
    for (const bool both : { false, true })
    {
      QuadRequest request;
      request.quadCount = 400;
      request.sides = RectangleSides();
      Progression progression;
      progression.ratio = ratio;
      progression.both = both;
      request.sideRequests = { GradingOf("bottom", progression) };
      const QuadResult quads = MakeQuadMesh(Rectangle(), request).quads;
      EXPECT_EQ(quads.quality.inverted, 0);
      const std::vector<double> edges =
        EdgesOf(quads.mesh, Rectangle(), request.sides.Find("bottom")).at(0);
      const std::size_t last = both ? (edges.size() - 1) / 2 : edges.size() - 1;
      EXPECT_NEAR(edges[last] / edges[0], ratio, 1e-9 * ratio);
      for (std::size_t i = 2; i <= last; ++i)
      {
        EXPECT_NEAR(edges[i] / edges[i - 1], edges[1] / edges[0], 1e-9);
      }
      // The strips have the lengths up to the opposite side.
      const std::vector<double> opposite =
        EdgesOf(quads.mesh, Rectangle(), request.sides.Find("top")).at(0);
      ASSERT_EQ(opposite.size(), edges.size());
      for (std::size_t i = 0; i < edges.size(); ++i)
      {
        EXPECT_NEAR(opposite[edges.size() - 1 - i] / edges[i], 1.0, 0.1);
      }
    }
  }
}

TEST(PrescribedSides, ProgressionsOfRandomPartsAreGeometric)
{
  Random random(9);
  int graded = 0;
  for (int run = 0; run < 30; ++run)
  {
    SCOPED_TRACE(run);
    const PlanarDomain domain = RandomPart(random);
    QuadRequest request;
    request.sides = NameSides(domain, RandomNames(random, domain, 3));
    request.quadCount = random.Integer(300, 900);
    Progression progression;
    progression.ratio = std::exp(random.Uniform(-1.2, 1.2));
    const int side = random.Integer(0, static_cast<int>(request.sides.names.size()) - 1);
    request.sideRequests = { GradingOf(request.sides.names[Index(side)], progression) };
    QuadResult quads;
    try
    {
      quads = MakeQuadMesh(domain, request).quads;
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::string(error.what()).find("closed curve"), std::string::npos);
      continue;
    }
    EXPECT_EQ(quads.quality.inverted, 0);
    for (const std::vector<double>& part : PartsOf(quads.mesh, domain, request.sides, side))
    {
      const double expected = part.size() > 1 ? progression.ratio : 1.0;
      EXPECT_NEAR(part.back() / part.front(), expected, 1e-6 * expected);
    }
    ++graded;
  }
  EXPECT_GT(graded, 15);
}

TEST(PrescribedSides, LengthsOfFirstAndLastEdgeAreMet)
{
  QuadRequest request;
  request.quadSize = 0.1;
  request.sides = RectangleSides();
  Progression progression;
  progression.first = 0.02;
  progression.last = 0.2;
  request.sideRequests = { GradingOf("bottom", progression) };
  const QuadResult quads = MakeQuadMesh(Rectangle(), request).quads;
  const std::vector<double> edges =
    EdgesOf(quads.mesh, Rectangle(), request.sides.Find("bottom")).at(0);
  // the number of edges is rounded
  EXPECT_NEAR(edges.front(), progression.first, 0.03 * progression.first);
  EXPECT_NEAR(edges.back(), progression.last, 0.03 * progression.last);
}

TEST(PrescribedSides, SizesAtSidesHoldWithinTheTolerance)
{
  Random random(8);
  for (int run = 0; run < 25; ++run)
  {
    SCOPED_TRACE(run);
    const PlanarDomain domain = RandomPart(random);
    QuadRequest request;
    request.sides = NameSides(domain, RandomNames(random, domain, 3));
    request.quadSize = domain.Diagonal() / random.Uniform(20.0, 35.0);
    const int side = random.Integer(0, static_cast<int>(request.sides.names.size()) - 1);
    const SideRequest one =
      SizeOf(request.sides.names[Index(side)], request.quadSize * random.Uniform(0.3, 0.9));
    request.sideRequests = { one };
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    EXPECT_EQ(result.quads.quality.inverted, 0);
    for (const std::vector<double>& part : PartsOf(result.quads.mesh, domain, request.sides, side))
    {
      // no number of equal edges meets the size on a part shorter than this
      const double length = std::accumulate(part.begin(), part.end(), 0.0);
      const double error = length < 1.6 * one.size ? 0.6 : SizeTolerance + 1e-9;
      for (const double edge : part)
      {
        EXPECT_LE(edge / one.size, 1.0 + error);
        EXPECT_GE(edge, std::min(length, one.size) * (1.0 - error));
      }
    }
  }
}

TEST(PrescribedSides, SizesGrowFromASideAndKeepTheOthers)
{
  QuadRequest request;
  request.quadSize = 0.2;
  request.sides = RectangleSides();
  request.sideRequests = { SizeOf("left", 0.05) };
  const QuadResult quads = MakeQuadMesh(Rectangle(), request).quads;
  const std::vector<double> bottom =
    EdgesOf(quads.mesh, Rectangle(), request.sides.Find("bottom")).at(0);
  EXPECT_LT(bottom.front(), 0.12);
  EXPECT_GT(bottom.back(), 0.15);
}

TEST(PrescribedSides, BoundsOfSizesHold)
{
  QuadRequest request;
  request.quadSize = 0.2;
  request.maximumSize = 0.1;
  request.sides = RectangleSides();
  const QuadResult quads = MakeQuadMesh(Rectangle(), request).quads;
  EXPECT_NEAR(static_cast<double>(quads.mesh.quads.size()), 300.0, 15.0);
}

TEST(PrescribedSides, ContradictionsNameTheStrip)
{
  QuadRequest request;
  request.sides = RectangleSides();
  request.sideRequests = { CountOf("bottom", 24), CountOf("top", 11) };
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(Rectangle(), request); },
    { "bottom:24 and top:11 are sides of one strip of quads; give equal numbers or leave one out." }));
  request.sideRequests.push_back(CountOf("left", 9));
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(Rectangle(), request); }, { "bottom:24 and top:11 are" }));
  request.sideRequests.back() = CountOf("top", 24);
  request.sideRequests.erase(request.sideRequests.begin() + 1);
  EXPECT_EQ(MeasureSides(MakeQuadMesh(Rectangle(), request).quads.mesh)[0].edges, 24);
}

TEST(PrescribedSides, NothingIsPrescribedTwice)
{
  QuadRequest request;
  request.sides = RectangleSides();
  request.quadCount = 100;
  request.sideRequests = { CountOf("bottom", 12), GradingOf("bottom", { 2.0 }) };
  EXPECT_EQ(MeasureSides(MakeQuadMesh(Rectangle(), request).quads.mesh)[0].edges, 12);
  for (const SideRequest& again : { CountOf("bottom", 12), GradingOf("bottom", { 3.0 }) })
  {
    QuadRequest twice = request;
    twice.sideRequests.push_back(again);
    EXPECT_TRUE(Refuses([&] { MakeQuadMesh(Rectangle(), twice); },
      { "of side 'bottom' is prescribed twice; leave one out." }));
  }
  request.sideRequests = { CountOf("lid", 3) };
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(Rectangle(), request); }, { "no side 'lid'" }));
}

TEST(PrescribedSides, ProgressionsOfClosedCurvesAreRefused)
{
  const PlanarDomain disk = DiskOfEdges(0.1);
  QuadRequest request;
  request.sideRequests = { GradingOf("outer0", { 2.0 }) };
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(disk, request); }, { "'outer0' is a closed curve" }));
}
}
