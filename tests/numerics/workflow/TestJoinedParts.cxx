// Quads of domains with several parts.

#include "JoinedParts.h"

#include "BuiltinDomains.h"
#include "LayerChecks.h"
#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "Support.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{
DomainPart PartOf(const PlanarDomain& domain, const std::vector<std::string>& taken = {})
{
  return { domain, NameSides(domain, {}, taken), {} };
}

/// A disk, a ring to the right of it, and a square farther on.
std::vector<DomainPart> ThreeParts()
{
  const Similarity right{ 0.0, 1.0, Point(3.0, 0.0) };
  std::vector<DomainPart> parts = { PartOf(DiskOfEdges(0.1)) };
  parts.push_back(PartOf(right(RingOfEdges(0.1)), { "outer0" }));
  parts.push_back(PartOf(
    MakePlanarDomain({ { { 6, 0 }, { 7, 0 }, { 7, 1 }, { 6, 1 } } }), { "outer0", "outer1" }));
  return parts;
}

TEST(JoinedParts, HaveTheQuadsOfEachPart)
{
  const std::vector<DomainPart> parts = ThreeParts();
  QuadRequest request;
  request.quadCount = 900;
  const QuadWorkflowResult joined = MakeQuadsOfParts(parts, request);
  const QuadMesh& mesh = joined.quads.mesh;
  ASSERT_EQ(joined.part.size(), mesh.quads.size());
  EXPECT_EQ(mesh.EulerCharacteristic(), 1 + 0 + 1);
  ExpectSoundBlocks(joined.quads);
  EXPECT_EQ(joined.quads.tMesh.arcs.size(), joined.quads.counts.counts.size());
  EXPECT_EQ(mesh.sideNames,
    (std::vector<std::string>{
      "outer0", "outer1", "hole0", "outer2", "outer3", "outer4", "outer5" }));
  std::set<int> loops;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    loops.insert(edge.id);
  }
  EXPECT_EQ(loops, (std::set<int>{ 0, 1, 2, 3 }));
  // All sizes are nearly the same, and those of all quads together.
  const QuadQuality quality = MeasureQuads(mesh, joined.quads.size);
  EXPECT_EQ(quality.scaledJacobian, joined.quads.quality.scaledJacobian);
  EXPECT_EQ(quality.where, joined.quads.quality.where);
  EXPECT_DOUBLE_EQ(quality.jacobian.min, joined.quads.quality.jacobian.min);
  EXPECT_NEAR(quality.jacobian.mean, joined.quads.quality.jacobian.mean, 1e-12);
  EXPECT_NEAR(quality.size.mean, joined.quads.quality.size.mean, 1e-12);
  EXPECT_NEAR(quality.variation, joined.quads.quality.variation, 1e-9);
  EXPECT_DOUBLE_EQ(quality.bound, joined.quads.quality.bound);
  std::vector<SpacePoint> places;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const PartRequest own = SplitRequest(parts, request)[p];
    EXPECT_NEAR(own.request.quadCount, 900 * own.share, 0.5);
    const QuadWorkflowResult alone = MakeQuadMesh(parts[p].domain, own.request);
    EXPECT_EQ(std::count(joined.part.begin(), joined.part.end(), static_cast<int>(p)),
      static_cast<std::ptrdiff_t>(alone.quads.mesh.quads.size()));
    EXPECT_NEAR(alone.quads.quality.size.mean, quality.size.mean, 0.05 * quality.size.mean);
    for (const QuadPoint& point : alone.quads.mesh.points)
    {
      places.push_back(point.place);
    }
  }
  ASSERT_EQ(places.size(), mesh.points.size());
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    EXPECT_EQ(places[i], mesh.points[i].place);
  }
}

TEST(JoinedParts, OnePartIsTheMeshOfItsDomain)
{
  QuadRequest request;
  request.quadCount = 200;
  const PlanarDomain shape = Builtin("l-shape");
  const QuadWorkflowResult one = MakeQuadsOfParts({ PartOf(shape) }, request);
  const QuadWorkflowResult mesh = MakeQuadMesh(shape, request);
  ASSERT_EQ(one.quads.mesh.quads, mesh.quads.mesh.quads);
  EXPECT_EQ(one.warnings, mesh.warnings);
  EXPECT_EQ(one.part, std::vector<int>(mesh.quads.mesh.quads.size(), 0));
}

TEST(JoinedParts, HaveWhatIsPrescribedForThem)
{
  const std::vector<DomainPart> parts = ThreeParts();
  QuadRequest request;
  request.quadCount = 900;
  // The rows of the ring are 1 and 3; the disk has none, so its singularities are chosen.
  request.singularities = { { { 3.75, 0.0 }, 1, 0.0 }, { { 3.0, 0.7 }, -1, 0.0 } };
  request.sideRequests.resize(2);
  request.sideRequests[0].side = "hole0";
  request.sideRequests[0].count = 24;
  request.sideRequests[1].side = "outer4";
  request.sideRequests[1].count = 7;
  const std::vector<PartRequest> split = SplitRequest(parts, request);
  EXPECT_FALSE(split[0].request.singularities.has_value());
  EXPECT_EQ(split[1].rows, (std::vector<std::size_t>{ 0, 1 }));
  EXPECT_EQ(split[0].request.sideRequests.size(), 0U);
  EXPECT_EQ(split[1].request.sideRequests.size(), 1U);
  const QuadWorkflowResult result = MakeQuadsOfParts(parts, request);
  std::vector<int> edges(result.quads.mesh.sideNames.size());
  for (const QuadBoundaryEdge& edge : result.quads.mesh.boundary)
  {
    ++edges[static_cast<std::size_t>(edge.side)];
  }
  EXPECT_EQ(edges[2], 24);
  EXPECT_EQ(edges[5], 7);
  EXPECT_EQ(result.singularities.size(), 4U + 2U);
}

TEST(JoinedParts, AnEmptyConfigurationHoldsForAllParts)
{
  QuadRequest request;
  request.singularities = Configuration();
  EXPECT_TRUE(SplitRequest(ThreeParts(), request)[2].request.singularities->empty());
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfParts(ThreeParts(), request); },
    { "Part 1 of 3", "add up to 0" }, Error::Kind::Inconsistent));
}

TEST(JoinedParts, RefuseSidesThatNoPartHas)
{
  QuadRequest request;
  request.sideRequests.resize(1);
  request.sideRequests[0].side = "outer6";
  EXPECT_TRUE(
    Refuses([&] { SplitRequest(ThreeParts(), request); }, { "no side 'outer6'", "'outer5'" }));
}

TEST(JoinedParts, HolesAreTheSidesOfAllInnerLoops)
{
  const Loop square = { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } };
  const Loop first = { { 1, 1 }, { 1, 2 }, { 2, 2 }, { 2, 1 } };
  const Loop second = { { 3, 3 }, { 3, 3.5 }, { 3.5, 3.5 }, { 3.5, 3 } };
  const PlanarDomain domain = MakePlanarDomain({ square, first, second });
  QuadRequest request;
  request.sideRequests.resize(2);
  request.sideRequests[0].side = "outer0";
  request.sideRequests[1].side = "holes";
  request.sideRequests[1].count = 5;
  request.cornerRows.emplace_back();
  request.cornerRows[0].side = "holes";
  const auto namesOf = [&](const DomainPart& part)
  {
    std::vector<std::string> names;
    const std::vector<PartRequest> split = SplitRequest({ part }, request);
    for (const SideRequest& one : split[0].request.sideRequests)
    {
      names.push_back(one.side);
    }
    return names;
  };
  EXPECT_EQ(namesOf(PartOf(domain)),
    (std::vector<std::string>{
      "outer0", "hole0", "hole1", "hole2", "hole3", "hole4", "hole5", "hole6", "hole7" }));
  EXPECT_EQ(SplitRequest({ PartOf(domain) }, request)[0].request.cornerRows.size(), 8U);
  // A side may have this name.
  const SegmentNames names = { { "holes", "a", "b", "c" }, { "d", "d", "d", "d" },
    { "e", "e", "e", "e" } };
  EXPECT_EQ(namesOf({ domain, NameSides(domain, names), {} }),
    (std::vector<std::string>{ "outer0", "holes" }));
}

TEST(JoinedParts, SizesNearPositionsAreThoseOfTheirPart)
{
  QuadRequest request;
  request.quadCount = 0;
  // About 1,000 quads in all parts together, not in each of them.
  const QuadWorkflowResult usual = MakeQuadsOfParts(ThreeParts(), request);
  EXPECT_NEAR(static_cast<double>(usual.quads.mesh.quads.size()), 1000.0, 50.0);
  EXPECT_FALSE(usual.sizes);
  request.quadSize = 0.1;
  const QuadWorkflowResult without = MakeQuadsOfParts(ThreeParts(), request);
  request.sizesNear = { { { 6.5, 0.5 }, 0.02, 0.1 } }; // in the square
  const QuadWorkflowResult with = MakeQuadsOfParts(ThreeParts(), request);
  std::array<std::ptrdiff_t, 3> before{};
  std::array<std::ptrdiff_t, 3> after{};
  for (int part = 0; part < 3; ++part)
  {
    before[part] = std::count(without.part.begin(), without.part.end(), part);
    after[part] = std::count(with.part.begin(), with.part.end(), part);
  }
  EXPECT_EQ(before[0], after[0]);
  EXPECT_EQ(before[1], after[1]);
  EXPECT_GT(after[2], before[2] + 50);
  ASSERT_TRUE(with.sizes);
  EXPECT_EQ(with.sizes->samples.size(), static_cast<std::size_t>(after[2]));
}

TEST(JoinedParts, CountsFollowPrescribedSizes)
{
  // Sizes of the square are a third of those elsewhere.
  QuadRequest request;
  request.sizing = Sizing::Field;
  request.prescribedSizes.length = [](const Point& place) { return place.x() > 5.0 ? 0.1 : 0.3; };
  const std::vector<PartRequest> split = SplitRequest(ThreeParts(), request);
  const double disk = Pi / 0.09;
  EXPECT_NEAR(split[2].share / split[0].share, 100.0 / disk, 0.01 * 100.0 / disk);
}
}
}
