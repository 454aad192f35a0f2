// Periodic sides: equal numbers of edges, nodes that match to rounding, good quads, refusals.

#include "QuadWorkflow.h"

#include "Index.h"
#include "MakePlanarDomain.h"
#include "NodePairs.h"
#include "QuadSides.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// A domain with sides 'a' and 'b' that are images of each other, and 'low' and 'high' between
/// them.
struct PeriodicDomain
{
  PlanarDomain domain;
  BoundarySides sides;
  double angle = 0.0; ///< Of the motion from a to b.
};

/// Moves points of the unit square to the domain.
using Chart = std::function<Point(double, double)>;

PeriodicDomain MakeDomain(const Chart& chart, Random& random, int holes, double angle)
{
  const int across = random.Integer(12, 30);
  const int along = random.Integer(12, 40);
  Loop outer;
  std::vector<std::string> names;
  const auto add = [&](int count, const std::string& name, auto place)
  {
    for (int i = 0; i < count; ++i)
    {
      outer.push_back(place(static_cast<double>(i) / count));
      names.push_back(name);
    }
  };
  add(along, "low", [&](double t) { return chart(t, 0.0); });
  add(across, "b", [&](double t) { return chart(1.0, t); });
  add(along, "high", [&](double t) { return chart(1.0 - t, 1.0); });
  add(across, "a", [&](double t) { return chart(0.0, 1.0 - t); });
  std::vector<Loop> loops = { outer };
  for (int hole = 0; hole < holes; ++hole)
  {
    const Point centre = chart((hole + random.Uniform(0.4, 0.6)) / holes, random.Uniform(0.4, 0.6));
    double distance = DistanceToLoop(centre, outer);
    for (std::size_t other = 1; other < loops.size(); ++other)
    {
      distance = std::min(distance, DistanceToLoop(centre, loops[other]));
    }
    loops.push_back(
      RegularPolygon(random.Integer(16, 40), random.Uniform(0.25, 0.5) * distance, centre));
  }
  Similarity place;
  place.angle = random.Uniform(0.0, 6.0);
  place.scale = std::pow(10.0, random.Uniform(-2.0, 2.0));
  place.shift = { random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0) };
  PeriodicDomain result;
  result.domain = MakePlanarDomain(place(loops));
  result.angle = angle;
  // MakePlanarDomain may begin loops elsewhere.
  SegmentNames segments;
  for (const Loop& loop : result.domain.loops)
  {
    segments.emplace_back();
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point middle = 0.5 * (loop[i] + loop[(i + 1) % loop.size()]);
      std::size_t nearest = 0;
      double distance = 1e300;
      for (std::size_t k = 0; k < outer.size(); ++k)
      {
        const Point other = place(Point(0.5 * (outer[k] + outer[(k + 1) % outer.size()])));
        if ((other - middle).norm() < distance)
        {
          distance = (other - middle).norm();
          nearest = k;
        }
      }
      const bool isOuter = distance < 1e-9 * result.domain.Diagonal();
      segments.back().push_back(isOuter ? names[nearest] : std::string());
    }
  }
  result.sides = NameSides(result.domain, segments);
  return result;
}

/// A passage between two wavy translates, with up to two holes unless their number is given.
PeriodicDomain RandomPassage(Random& random, int holes = -1)
{
  const double width = random.Uniform(1.0, 2.5);
  const double wave = random.Uniform(-0.2, 0.2);
  const double shear = random.Uniform(-0.5, 0.5);
  const double rise = random.Uniform(-0.4, 0.4);
  const double bulge = random.Uniform(-0.15, 0.15);
  const Chart chart = [=](double s, double t) -> Point
  {
    const double x = width * s + wave * std::sin(2.0 * Pi * t) + shear * t;
    return { x, t + rise * s + bulge * std::sin(Pi * s) * (1.0 - 2.0 * t) };
  };
  return MakeDomain(chart, random, holes < 0 ? random.Integer(0, 2) : holes, 0.0);
}

/// A sector between a curve and its rotated copy, with holes as above.
PeriodicDomain RandomSector(Random& random, int holes = -1)
{
  const double inner = random.Uniform(0.4, 1.5);
  const double angle = random.Uniform(0.3, 2.5);
  const double twist = random.Uniform(-0.6, 0.6);
  const double wave = random.Uniform(-0.1, 0.1);
  const Chart chart = [=](double s, double t) -> Point
  {
    const double radius = inner + t;
    const double at = angle * (s - 1.0) + twist * t * t + wave * std::sin(2.0 * Pi * t);
    return radius * Point(std::cos(at), std::sin(at));
  };
  return MakeDomain(chart, random, holes < 0 ? random.Integer(0, 2) : holes, angle);
}

QuadRequest RequestFor(const PeriodicDomain& domain, int count)
{
  QuadRequest request;
  request.sides = domain.sides;
  request.quadCount = count;
  request.sideRequests = { PartnerOf("a", "b") };
  return request;
}

/// Returns the number of edges of each side of the first pair.
int EdgesOf(const QuadWorkflowResult& result)
{
  return static_cast<int>(result.quads.mesh.periodic.at(0).nodes.size()) - 1;
}

/// Expects equal numbers of edges, and nodes of b at the images of those of a.
void ExpectPeriodic(const PeriodicDomain& domain, const QuadWorkflowResult& result)
{
  const QuadMesh& mesh = result.quads.mesh;
  ASSERT_EQ(mesh.periodic.size(), 1U);
  const PairedSides& pair = mesh.periodic[0];
  EXPECT_NEAR(pair.motion.angle, domain.angle, 1e-12);
  const auto first = PiecesOf(mesh, domain.sides.Find("a"));
  const auto second = PiecesOf(mesh, domain.sides.Find("b"));
  ASSERT_EQ(first.size(), 1U);
  ASSERT_EQ(second.size(), 1U);
  ASSERT_EQ(first[0].size(), second[0].size());
  EXPECT_EQ(pair.nodes.size(), first[0].size());
  double worst = 0.0;
  for (std::size_t i = 0; i < first[0].size(); ++i)
  {
    const Point image = pair.motion(mesh.points[Index(first[0][i])].InPlane());
    worst = std::max(
      worst, (image - mesh.points[Index(second[0][second[0].size() - 1 - i])].InPlane()).norm());
  }
  EXPECT_LE(worst, 1e-12 * domain.domain.Diagonal());
  EXPECT_EQ(LargestMismatch(pair, mesh), worst);
  // nodes of b are on the boundary, too
  const std::vector<LoopArc> arcs(domain.domain.loops.begin(), domain.domain.loops.end());
  for (const int point : second[0])
  {
    const Point place = mesh.points[Index(point)].InPlane();
    EXPECT_LE(
      (arcs[0].At(arcs[0].Nearest(place)) - place).norm(), 1e-10 * domain.domain.Diagonal());
  }
  EXPECT_EQ(result.quads.quality.inverted, 0);
}
}

TEST(PeriodicQuads, MatchOnRandomDomainsWithGoodQuads)
{
  Random random(51377);
  double sum = 0.0;
  constexpr int Trials = 10;
  for (int trial = 0; trial < Trials; ++trial)
  {
    SCOPED_TRACE(trial);
    const PeriodicDomain domain = trial % 2 == 0 ? RandomPassage(random) : RandomSector(random);
    QuadRequest request = RequestFor(domain, random.Integer(150, 900));
    const QuadWorkflowResult result = MakeQuadMesh(domain.domain, request);
    ExpectPeriodic(domain, result);
    EXPECT_EQ(result.quads.counts.nodes, 0) << "of branch and cut: the flow is enough";
    EXPECT_NEAR(static_cast<double>(result.quads.mesh.quads.size()), request.quadCount,
      0.05 * request.quadCount + 1.0);
    request.sideRequests.clear();
    const QuadWorkflowResult without = MakeQuadMesh(domain.domain, request);
    sum += result.quads.quality.jacobian.min / without.quads.quality.jacobian.min;
    EXPECT_GT(result.quads.quality.jacobian.mean, 0.93 * without.quads.quality.jacobian.mean);
  }
  EXPECT_GT(sum / Trials, 0.85) << "worst quads relative to those without periodic sides";
}

TEST(PeriodicQuads, MatchWithLayersAndNumbers)
{
  Random random(90210);
  int made = 0;
  for (int trial = 0; trial < 6; ++trial)
  {
    SCOPED_TRACE(trial);
    const PeriodicDomain domain =
      trial % 2 == 0 ? RandomPassage(random, 0) : RandomSector(random, 0);
    QuadRequest request = RequestFor(domain, random.Integer(400, 900));
    const double size = std::sqrt(domain.domain.Area() / request.quadCount);
    int count = 0;
    if (trial < 3)
    {
      count = random.Integer(18, 26);
      request.sideRequests.push_back(CountOf(trial == 0 ? "a" : "b", count));
    }
    for (const char* name : { "low", "high" })
    {
      if (trial > 3 || std::string(name) == "low")
      {
        const double first = random.Uniform(0.05, 0.2) * size;
        request.sideRequests.push_back(LayerOf(name, first, random.Uniform(1.3, 1.5)));
      }
    }
    try
    {
      const QuadWorkflowResult result = MakeQuadMesh(domain.domain, request);
      ExpectPeriodic(domain, result);
      ++made;
      if (count > 0)
      {
        EXPECT_EQ(EdgesOf(result), count) << "layers included";
      }
    }
    catch (const Error& error)
    {
      const bool isNumber =
        std::string(error.what()).find("leave out this number") != std::string::npos;
      EXPECT_TRUE(isNumber || error.GetKind() == Error::Kind::LackOfRows) << error.what();
      if (isNumber)
      {
        request.sideRequests.erase(request.sideRequests.begin() + 1);
        EXPECT_NO_THROW(MakeQuadMesh(domain.domain, request));
        continue;
      }
      request.sideRequests.erase(
        request.sideRequests.begin()); // singularities are in the way, and not the pair
      EXPECT_THROW(MakeQuadMesh(domain.domain, request), Error);
    }
  }
  EXPECT_GE(made, 4);
}

TEST(PeriodicQuads, MatchInLargeMeshes)
{
  Random random(61);
  const PeriodicDomain domain = RandomPassage(random, 1);
  QuadRequest request = RequestFor(domain, 7000);
  const QuadWorkflowResult result = MakeQuadMesh(domain.domain, request);
  EXPECT_GT(result.quads.mesh.quads.size(), 6500U) << "smoothed with coarser meshes";
  ExpectPeriodic(domain, result);
  request.sideRequests.clear();
  const QuadWorkflowResult without = MakeQuadMesh(domain.domain, request);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.7 * without.quads.quality.jacobian.min);
}

TEST(PeriodicQuads, MatchWithAProgressionOfOneSide)
{
  Random random(62);
  const PeriodicDomain domain = RandomSector(random, 0);
  QuadRequest request = RequestFor(domain, 400);
  request.sideRequests.push_back(GradingOf("b", { 3.0 }));
  const QuadWorkflowResult result = MakeQuadMesh(domain.domain, request);
  ExpectPeriodic(domain, result);
  const QuadMesh& mesh = result.quads.mesh;
  const std::vector<int> side = PiecesOf(mesh, domain.sides.Find("a"))[0];
  const auto edge = [&](std::size_t i)
  { return (mesh.points[Index(side[i + 1])].place - mesh.points[Index(side[i])].place).norm(); };
  EXPECT_NEAR(edge(0) / edge(side.size() - 2), 3.0, 0.1) << "reversed on the other side";
  request.sideRequests.push_back(GradingOf("a", { 3.0 }));
  EXPECT_TRUE(
    Refuses([&] { MakeQuadMesh(domain.domain, request); },
      { "The periodic sides 'b' and 'a' have different", "prescribe them for one of both" }) ||
    Refuses([&] { MakeQuadMesh(domain.domain, request); },
      { "The periodic sides 'a' and 'b' have different", "prescribe them for one of both" }));
}

TEST(PeriodicQuads, AreSymmetricAndPeriodicInBothDirections)
{
  const PlanarDomain domain = MakePlanarDomain(
    { { { 0, 0 }, { 1.5, 0 }, { 1.5, 1 }, { 0, 1 } }, RegularPolygon(48, 0.2, { 0.75, 0.5 }) });
  QuadRequest request;
  request.quadCount = 300;
  request.sides = NameSides(domain);
  request.sideRequests = { PartnerOf("outer3", "outer1"), PartnerOf("outer0", "outer2") };
  const QuadWorkflowResult result = MakeQuadMesh(domain, request);
  EXPECT_EQ(result.quads.smoothing.symmetries, 4);
  const std::vector<PairedSides>& pairs = result.quads.mesh.periodic;
  ASSERT_EQ(pairs.size(), 2U);
  for (const PairedSides& pair : pairs)
  {
    EXPECT_EQ(pair.motion.angle, 0.0);
    EXPECT_LE(LargestMismatch(pair, result.quads.mesh), 1e-12);
  }
  EXPECT_NEAR((pairs[0].motion.shift - Point(1.5, 0.0)).norm(), 0.0, 1e-15);
  EXPECT_NEAR((pairs[1].motion.shift - Point(0.0, 1.0)).norm(), 0.0, 1e-15);
}

TEST(PeriodicQuads, MatchAroundACommonCorner)
{
  for (const double opening : { Pi / 3.0, Pi / 2.0 })
  {
    Loop sector = { { 0, 0 } }; // the centre of the rotation is on both sides
    for (int i = 0; i <= 20; ++i)
    {
      const double angle = 0.4 + opening * i / 20.0;
      sector.emplace_back(std::cos(angle), std::sin(angle));
    }
    const PlanarDomain domain = MakePlanarDomain({ sector });
    QuadRequest request;
    request.quadCount = 200;
    request.sides = NameSides(domain);
    std::vector<std::string> straight;
    for (const SideStart& start : request.sides.starts)
    {
      const Point next = start.place; // the arc starts at radius 1 and angle 0.4
      if ((next - Point(std::cos(0.4), std::sin(0.4))).norm() > 1e-9)
      {
        straight.push_back(request.sides.names[Index(start.side)]);
      }
    }
    ASSERT_EQ(straight.size(), 2U);
    request.sideRequests = { PartnerOf(straight[0], straight[1]) };
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    const PairedSides& pair = result.quads.mesh.periodic.at(0);
    EXPECT_NEAR(std::abs(pair.motion.angle), opening, 1e-12);
    EXPECT_LE(pair.motion.Centre().norm(), 1e-12);
    EXPECT_LE(LargestMismatch(result.quads.mesh), 1e-12);
  }
}

TEST(PeriodicQuads, MatchWithFewBlocks)
{
  Random random(852);
  for (int trial = 0; trial < 2; ++trial)
  {
    SCOPED_TRACE(trial);
    const PeriodicDomain domain =
      trial % 2 == 0 ? RandomPassage(random, 1) : RandomSector(random, 1);
    QuadRequest request = RequestFor(domain, random.Integer(300, 900));
    const std::size_t all = MakeQuadMesh(domain.domain, request).quads.blocks.blocks.size();
    request.merge = BlockMerge::Coarse;
    const QuadWorkflowResult result = MakeQuadMesh(domain.domain, request);
    ExpectPeriodic(domain, result);
    EXPECT_LE(result.quads.blocks.blocks.size(), all);
  }
}

/// Strips of quads lead from the left side to both the right side and the one above it, so the left
/// and the right side cannot have equal numbers.
TEST(PeriodicQuads, NamePairsThatFitNoMesh)
{
  const PlanarDomain domain =
    MakePlanarDomain({ { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 1.5, 1.5 }, { 1.5, 2.5 }, { 0, 2 } } });
  QuadRequest request;
  request.quadCount = 200;
  request.sides = NameSides(domain);
  request.sideRequests = { PartnerOf("outer5", "outer1") };
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(domain, request); },
    { "The periodic pair outer5:outer1 fits no mesh of these singularities; leave it out." }));
  // of a straight L-shape with both sides of length 1 paired, the side of length 2 has an even
  // number
  const PlanarDomain shape =
    MakePlanarDomain({ { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 1, 1 }, { 1, 2 }, { 0, 2 } } });
  request.sides = NameSides(shape);
  request.sideRequests = { PartnerOf("outer1", "outer3"), CountOf("outer5", 13) };
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(shape, request); },
    { "The periodic pair outer1:outer3 and outer5:13 contradict each other",
      "give outer5:14 or" }));
  request.sideRequests[1].count = 14;
  const QuadWorkflowResult result = MakeQuadMesh(shape, request);
  EXPECT_EQ(EdgesOf(result), 7);
}

TEST(PeriodicQuads, RefuseSidesThatAreNoImages)
{
  Random random(63);
  const PeriodicDomain domain = RandomPassage(random, 1);
  const auto expect =
    [&](const std::vector<std::array<std::string, 2>>& pairs, const std::string& reason)
  {
    EXPECT_TRUE(
      Refuses([&] { FindPairedSides(domain.domain, domain.sides, {}, pairs); }, { reason }));
  };
  EXPECT_EQ(FindPairedSides(domain.domain, domain.sides, {}, { { "b", "a" } }).size(), 1U);
  expect({ { "a", "c" } }, "The boundary has no side 'c' for a periodic pair; give");
  expect({ { "a", "a" } }, "The side 'a' is paired with itself");
  expect({ { "a", "b" }, { "low", "a" } }, "The side 'a' is in two periodic pairs");
  expect({ { "a", "hole0" } }, "The side 'hole0' is a closed curve");
  expect({ { "a", "low" } }, "The sides 'a' and 'low' are not images of each other");
  BoundarySides apart = domain.sides;
  for (SideStart& start : apart.starts)
  {
    start.side = start.side == apart.Find("low") ? apart.Find("high") : start.side;
  }
  EXPECT_TRUE(Refuses(
    [&] {
      FindPairedSides(domain.domain, apart, {}, { { "a", "high" } });
    },
    { "The periodic side 'high' has 2 pieces" }));
  // one point of b beside its place
  std::vector<Loop> loops = domain.domain.loops;
  const std::vector<LoopArc> arcs(loops.begin(), loops.end());
  const SideSpan span = FindSpan(domain.sides, arcs, domain.sides.Find("b"));
  const std::size_t vertex = arcs[Index(span.loop)].NearestVertex(span.start + 0.5 * span.length);
  for (const double part : { 0.2, 5.0 })
  {
    std::vector<Loop> moved = loops;
    const Point across = TurnedLeft(arcs[Index(span.loop)].Tangent(span.start + 0.5 * span.length));
    moved[Index(span.loop)][vertex] += part * PairReach * domain.domain.Diagonal() * across;
    const PlanarDomain other = { moved };
    if (part < 1.0)
    {
      EXPECT_EQ(FindPairedSides(other, domain.sides, {}, { { "a", "b" } }).size(), 1U);
      continue;
    }
    EXPECT_TRUE(Refuses(
      [&] {
        FindPairedSides(other, domain.sides, {}, { { "a", "b" } });
      },
      { "The sides 'a' and 'b' are not images of each other", "leave the pair out" }));
  }
}
}
