// Target sizes: what is requested holds, sizes grow as permitted from there, the number of quads is that of
// the request, and the report measures them.

#include "SizeTargets.h"

#include "BuiltinDomains.h"
#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "SideRequests.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
const double Slope = std::log(1.25);

/// A plate of 4 × 2 with a hole of radius 0.3 in its middle, whose sides are outer0 to outer3 and hole0.
PlanarDomain PlateWithHole()
{
  Loop hole = RegularPolygon(64, 0.3, { 2.0, 1.0 });
  return MakePlanarDomain({ { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 2.0 }, { 0.0, 2.0 } }, hole });
}

SideRequest InsideOf(const std::string& side, double size)
{
  SideRequest request;
  request.side = side;
  request.inside = size;
  return request;
}

SizeTargets TargetsOf(const PlanarDomain& domain, const QuadRequest& request)
{
  return WithSizeTargets(domain, Resolve(domain, request)).targets.value();
}

/// Returns ∫ dA / s² over the plate, by the midpoint rule.
double QuadsOf(const SizeTargets& targets)
{
  constexpr double Step = 0.01;
  double count = 0.0;
  for (double x = 0.5 * Step; x < 4.0; x += Step)
  {
    for (double y = 0.5 * Step; y < 2.0; y += Step)
    {
      if ((Point(x, y) - Point(2.0, 1.0)).norm() > 0.3)
      {
        count += std::pow(Step / targets.length({ x, y }), 2);
      }
    }
  }
  return count;
}

TEST(SizeTargets, GrowFromSidesAndPositions)
{
  const PlanarDomain plate = PlateWithHole();
  QuadRequest request;
  request.quadSize = 0.3;
  request.sideRequests = { SizeOf("hole0", 0.02) };
  request.sizesNear = { { { 3.5, 0.5 }, 0.05, 0.1 } };
  const SizeTargets targets = TargetsOf(plate, request);
  EXPECT_EQ(targets.factor, 1.0);
  for (const Point& place : { Point(2.3, 1.0), Point(2.5, 1.0), Point(2.0, 1.8), Point(1.0, 0.2),
         Point(0.1, 1.9), Point(3.5, 0.5), Point(3.58, 0.5), Point(3.5, 0.1), Point(4.0, 0.0) })
  {
    const double fromHole = 0.02 + Slope * ((place - Point(2.0, 1.0)).norm() - 0.3);
    const double fromPosition =
      0.05 + Slope * std::max(0.0, (place - Point(3.5, 0.5)).norm() - 0.1);
    EXPECT_NEAR(targets.length(place) / std::min({ 0.3, fromHole, fromPosition }), 1.0, 0.03)
      << Describe(place);
  }
  // A coarse side in finer surroundings, and bounds.
  request = {};
  request.quadSize = 0.1;
  request.sideRequests = { SizeOf("outer0", 0.25) };
  request.maximumSize = 0.2;
  const SizeTargets coarse = TargetsOf(plate, request);
  EXPECT_NEAR(coarse.length({ 1.0, 0.0 }), 0.2, 1e-3);
  EXPECT_NEAR(coarse.length({ 1.0, 0.5 }), 0.25 - 0.5 * Slope, 0.01);
  EXPECT_NEAR(coarse.length({ 1.0, 1.5 }), 0.1, 1e-3);
}

TEST(SizeTargets, TakeTheRequestedNumberOrSay)
{
  const PlanarDomain plate = PlateWithHole();
  QuadRequest request;
  request.sideRequests = { SizeOf("hole0", 0.02) };
  double least = 0.0;
  for (const int count : { 0, 1500, 4000, 500 })
  {
    request.quadCount = count;
    const SizeTargets targets = TargetsOf(plate, request);
    if (count == 0)
    {
      least = QuadsOf(targets);
      EXPECT_NEAR(targets.length({ 0.0, 0.0 }), std::sqrt(plate.Area() / DefaultQuads), 1e-3);
    }
    else
    {
      EXPECT_NEAR(QuadsOf(targets) / count, 1.0, 0.03) << count;
    }
    const bool isEnough = count == 0 || count >= 1500;
    EXPECT_EQ(targets.factor == 1.0, isEnough) << count << " of at least " << least;
    EXPECT_NEAR(targets.length({ 2.3, 1.0 }) / targets.factor, 0.02, 1e-3);
  }
}

TEST(SizeTargets, InsideASideOneSizeHolds)
{
  const PlanarDomain disk = DiskOfEdges(0.1);
  const std::string name = NameSides(disk).names[0];
  QuadRequest request;
  request.quadCount = 0;
  request.sideRequests = { InsideOf(name, 0.07) };
  const SizeTargets targets = TargetsOf(disk, request);
  EXPECT_NEAR(targets.length({ 0.3, 0.4 }), 0.07, 1e-9);
  // With a number of quads, all sizes are multiplied.
  request.quadCount = 1000;
  EXPECT_NEAR(TargetsOf(disk, request).factor, std::sqrt(disk.Area() / 1000) / 0.07, 1e-3);
  // Nothing is inside a hole but its edges.
  request = {};
  request.quadSize = 0.3;
  request.sideRequests = { InsideOf("hole0", 0.05) };
  EXPECT_NEAR(TargetsOf(PlateWithHole(), request).length({ 2.0, 1.3 }), 0.05, 1e-9);
}

TEST(SizeTargets, OfDataGrowAsPermittedAndASentenceSaysSo)
{
  const PlanarDomain plate = PlateWithHole();
  QuadRequest request;
  request.sizing = Sizing::Field;
  request.quadSize = 1.0;
  request.prescribedSizes.length = [](const Point& place) { return place.x() < 1.0 ? 0.05 : 0.2; };
  for (double x = 0.05; x < 4.0; x += 0.1)
  {
    for (double y = 0.05; y < 2.0; y += 0.1)
    {
      request.prescribedSizes.places.emplace_back(x, y);
    }
  }
  const SizeTargets limited = TargetsOf(plate, request);
  EXPECT_NEAR(limited.length({ 0.5, 1.0 }), 0.05, 1e-9);
  EXPECT_NEAR(limited.length({ 1.4, 0.3 }), 0.05 + 0.4 * Slope, 0.02);
  EXPECT_NE(limited.warning.find("limited to 1.25"), std::string::npos) << limited.warning;
  request.growth = 1e9;
  EXPECT_EQ(TargetsOf(plate, request).warning, "");
}

TEST(SizeTargets, AreRefusedWhereTheyMakeNoSense)
{
  const PlanarDomain plate = PlateWithHole();
  QuadRequest request;
  const auto expectRefusal = [&](const std::vector<std::string>& words)
  {
    EXPECT_TRUE(Refuses([&] { MakeQuadMesh(plate, request); }, words));
    request = {};
  };
  request.sizesNear = { { { 2.0, 1.0 }, 0.1, 0.2 } };
  expectRefusal({ "(2, 1)", "outside of the domain" });
  request.sideRequests = { InsideOf("outer1", 0.1) };
  expectRefusal({ "'outer1' encloses nothing", "--size-at" });
  request.sideRequests = { InsideOf("hole0", -0.1) };
  expectRefusal({ "size inside side 'hole0'" });
  request.sideRequests = { InsideOf("hole0", 0.1), InsideOf("hole0", 0.1) };
  expectRefusal({ "size inside of side 'hole0' is prescribed twice" });
  request.sideRequests = { SizeOf("hole0", 1e-12) };
  expectRefusal({ "edges of length 1e-12 at side 'hole0'", "larger size" });
  request.sizesNear = { { { 1.0, 1.0 }, 1e-12, 0.0 } };
  expectRefusal({ "1e-12 near (1, 1)", "larger size" });
  request.growth = 1.0;
  expectRefusal({ "growth", "above 1" });
  request.quadCount = -1;
  expectRefusal({ "number of quads is negative" });
  request.sizesNear = { { { 2.0, 1.0 }, 0.1, 0.4 } }; // around the hole
  EXPECT_GT(MakeQuadMesh(plate, request).quads.mesh.quads.size(), 100U);
}

TEST(SizeTargets, AnyNumberOfQuadsInAStripHasAMesh)
{
  const PlanarDomain strip =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 0.3 }, { 0.0, 0.3 } } });
  QuadRequest request;
  request.sizing = Sizing::Field;
  request.prescribedSizes.length = [](const Point& place)
  { return 0.1 * std::pow(2.0, place.x() / 3.0); };
  request.singularities = Configuration();
  for (int count = 30; count < 70; ++count)
  {
    request.quadCount = count;
    const QuadWorkflowResult result = MakeQuadMesh(strip, request);
    const auto quads = static_cast<double>(result.quads.mesh.quads.size());
    ASSERT_GT(quads, 0.0);
    EXPECT_EQ(std::abs(quads / count - 1.0) > 0.05, AnyHas(result.warnings, "No number of quads"));
  }
}

TEST(SizeReport, MeasuresWhatIsInTheMesh)
{
  const PlanarDomain plate = PlateWithHole();
  QuadRequest request;
  request.quadSize = 0.25;
  request.sideRequests = { SizeOf("hole0", 0.06) };
  request.sizesNear = { { { 3.7, 0.3 }, 0.1, 0.0 } };
  const QuadWorkflowResult result = MakeQuadMesh(plate, request);
  ASSERT_TRUE(result.sizes);
  const SizeReport& report = *result.sizes;
  const QuadMesh& mesh = result.quads.mesh;
  ASSERT_EQ(report.samples.size(), mesh.quads.size());
  const SizeTargets targets = TargetsOf(plate, request);
  double area = 0.0;
  double met = 0.0;
  std::size_t count = 0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    const auto at = [&](std::size_t corner)
    { return mesh.points[mesh.quads[q][corner]].InPlane(); };
    const double own = 0.5 * Cross(at(2) - at(0), at(3) - at(1));
    const double ratio = std::sqrt(own) / targets.length(0.25 * (at(0) + at(1) + at(2) + at(3)));
    const bool isMet = ratio > 0.8 && ratio < 1.25;
    area += own;
    met += isMet ? own : 0.0;
    count += isMet ? 1 : 0;
  }
  EXPECT_NEAR(area, plate.Area(), 0.01 * plate.Area());
  EXPECT_NEAR(report.AreaShare(), met / area, 1e-12);
  EXPECT_NEAR(
    report.QuadShare(), static_cast<double>(count) / static_cast<double>(mesh.quads.size()), 1e-12);
  ASSERT_EQ(report.sets.size(), 2U);
  EXPECT_EQ(report.sets[0].name, "hole0");
  EXPECT_NEAR(report.sets[0].Median(), 1.0, 0.3);
  EXPECT_EQ(report.sets[0].ratios.size(),
    std::count_if(mesh.boundary.begin(), mesh.boundary.end(),
      [](const QuadBoundaryEdge& edge) { return edge.kind == BoundaryKind::Inner; }));
  EXPECT_EQ(report.sets[1].name, "3.7,0.3");
  EXPECT_GE(report.sets[1].ratios.size(), 1U);
  EXPECT_GT(report.largestJump, 1.0);
  EXPECT_EQ(report.nodesAdded, 0);
  // Without requested sizes there is no report.
  EXPECT_FALSE(MakeQuadMesh(plate, QuadRequest{}).sizes);
}

TEST(SizeTargets, AreMetByChosenSingularities)
{
  const PlanarDomain plate = PlateWithHole();
  QuadRequest request;
  request.quadSize = 0.25;
  request.sideRequests = { SizeOf("hole0", 0.03) };
  request.sizesNear = { { { 3.5, 0.5 }, 0.05, 0.1 } };
  const QuadWorkflowResult chosen = MakeQuadMesh(plate, request);
  EXPECT_EQ(chosen.sizes.value().Met(), 1.0);
  EXPECT_GT(chosen.quads.quality.jacobian.min, 0.7);
  EXPECT_EQ(chosen.quads.quality.inverted, 0);
  // A number of quads multiplies h, not these sizes.
  request.quadSize = 0.0;
  request.quadCount = 1500;
  const QuadWorkflowResult counted = MakeQuadMesh(plate, request);
  EXPECT_NEAR(static_cast<double>(counted.quads.mesh.quads.size()), 1500.0, 75.0);
  EXPECT_EQ(counted.sizes.value().factor, 1.0);
}

TEST(SizeTargets, PairsAreAddedToGivenSingularitiesOnRequestOnly)
{
  const PlanarDomain disk = DiskOfEdges(0.05);
  QuadRequest request;
  request.quadSize = 0.2;
  request.sizesNear = { { { 0.0, 0.0 }, 0.03, 0.3 } };
  request.singularities = OnCircle(4, 0.6, 0.0, 1, 0.0);
  const QuadWorkflowResult without = MakeQuadMesh(disk, request);
  EXPECT_EQ(without.singularities.size(), 4U);
  EXPECT_EQ(without.sizes.value().nodesAdded, 0);
  EXPECT_TRUE(AnyHas(without.warnings, "Sizes are met within 25 %"));
  request.pairs = 6;
  const QuadWorkflowResult with = MakeQuadMesh(disk, request);
  EXPECT_GT(with.singularities.size(), 4U);
  EXPECT_LE(with.singularities.size(), 16U);
  EXPECT_EQ(with.sizes.value().nodesAdded, static_cast<int>(with.singularities.size()) - 4);
  EXPECT_GT(with.sizes->Met(), without.sizes->Met() + 0.2);
  EXPECT_TRUE(AnyHas(with.events, "of singularities were added for the target sizes"));
}

TEST(SizeTargets, StripsTakeTheMiddleOfTheirTargets)
{
  // Sizes that double along a strip: with the geometric mean of both ends all quads are within 25 %.
  const PlanarDomain box =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 1.0 }, { 0.0, 1.0 } } });
  QuadRequest request;
  request.sizing = Sizing::Field;
  request.quadSize = 1.0;
  request.prescribedSizes.length = [](const Point& place)
  { return 0.05 * std::pow(2.0, 0.25 * place.x()); };
  request.singularities = Configuration();
  const SizeReport report = MakeQuadMesh(box, request).sizes.value();
  EXPECT_EQ(report.AreaShare(), 1.0);
  EXPECT_EQ(report.QuadShare(), 1.0);
}

TEST(SizeReport, SaysWhereSizesAreMissed)
{
  SizeReport report;
  for (int i = 0; i < 10; ++i)
  {
    report.samples.push_back({ 1.0, i < 9 ? 1.0 : 0.5 });
  }
  EXPECT_EQ(DescribeMissedSizes(report), "");
  report.samples.push_back({ 1.0, 0.5 });
  report.sets = { { "good", { 1.1, 0.9 } }, { "bad", { 2.0, 2.0, 2.1 } } };
  const std::string sentence = DescribeMissedSizes(report);
  EXPECT_NE(sentence.find("82 % of the area"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("at 'bad' quads have 2 times"), std::string::npos) << sentence;
  EXPECT_EQ(report.FineMedian(), 2.0);
  // A set that is too small to count in the shares.
  report.samples.assign(100, { 1.0, 1.0 });
  EXPECT_EQ(DescribeMissedSizes(report), "");
  report.sets[1].ratios = { 2.1 };
  EXPECT_NE(DescribeMissedSizes(report).find("at 'bad' quads have 2.1 times"), std::string::npos);
}

TEST(SizeReport, LayersAreNotMeasuredButTheirJumps)
{
  const PlanarDomain disk = DiskOfEdges(0.1);
  const std::string name = NameSides(disk).names[0];
  QuadRequest request;
  request.quadSize = 0.1;
  request.minimumSize = 0.05;
  const std::size_t before = MakeQuadMesh(disk, request).sizes.value().samples.size();
  request.sideRequests = { LayerOf(name, 0.005, 1.2) };
  const QuadWorkflowResult result = MakeQuadMesh(disk, request);
  EXPECT_LT(result.sizes.value().samples.size(), before);
  EXPECT_LT(result.sizes->samples.size(), result.quads.mesh.quads.size());
}
}
}
