// MakeQuadMesh gives the same mesh as its steps called one by one, and reports the singularities
// and corners that it used.

#include "QuadWorkflow.h"

#include "Layouts.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "MeshGrade.h"
#include "PoincareHopf.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns an ellipse, for which no singularity is at a symmetric position by chance.
PlanarDomain Ellipse()
{
  Loop loop = RegularPolygon(40);
  for (Point& point : loop)
  {
    point = { 0.8 * point.x(), 0.5 * point.y() };
  }
  return MakePlanarDomain({ loop });
}

void ExpectSamePoints(const QuadMesh& mesh, const QuadMesh& expected, double tolerance)
{
  ASSERT_EQ(mesh.points.size(), expected.points.size());
  ASSERT_EQ(mesh.quads, expected.quads);
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    EXPECT_LE((mesh.points[p].place - expected.points[p].place).norm(), tolerance);
  }
}

/// Returns whether a singularity is at the node of a mesh that belongs to it.
bool IsNode(const QuadMesh& mesh, const Singularity& singularity)
{
  return std::any_of(mesh.points.begin(), mesh.points.end(),
    [&](const QuadPoint& point)
    {
      return point.InPlane() == singularity.position &&
        point.quarterIndex == singularity.quarterIndex;
    });
}

int SumOfQuarters(const QuadWorkflowResult& result)
{
  int sum = TotalQuarters(result.singularities);
  for (const CornerChoice& corner : result.corners)
  {
    sum += corner.quarterIndex;
  }
  return sum;
}

TEST(QuadWorkflow, MakesTheMeshOfItsSteps)
{
  const PlanarDomain disk = DiskOfEdges(0.1);
  QuadRequest request;
  request.singularities = OnCircle(4, 0.6, 0.1, 1, 0.0);
  request.quadSize = 0.1;
  request.meshSize = 0.1;
  const QuadWorkflowResult result = MakeQuadMesh(disk, request);
  const SeamlessMap map = SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(disk, *request.singularities, 0.1)), *request.singularities);
  QuadOptions options;
  options.quadSize = 0.1;
  const QuadResult steps = MakeQuads(LayoutOf(map), options);
  ExpectSamePoints(result.quads.mesh, steps.mesh, 0.0);
  EXPECT_EQ(result.holonomyDefect, map.holonomyDefect);
  EXPECT_EQ(result.singularities.size(), 4U);
  EXPECT_TRUE(result.corners.empty());
  EXPECT_TRUE(result.events.empty());
  EXPECT_FALSE(result.optimum);
  EXPECT_FALSE(result.repair);
  EXPECT_EQ(result.seconds.choose, 0.0);
  EXPECT_GT(result.seconds.map, 0.0);
  EXPECT_EQ(CountExcess(result.quads, request.quadSize, request.quadCount), 0.0);
}

TEST(QuadWorkflow, ChoosesAsChooseConfigurationDoes)
{
  const PlanarDomain domain = Ellipse();
  for (const Sizing sizing : { Sizing::Conformal, Sizing::Uniform })
  {
    QuadRequest request;
    request.sizing = sizing;
    request.quadSize = 0.1;
    request.meshSize = 0.15;
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    AutomaticOptions options;
    options.optimizer.meshSize = 0.15;
    options.optimizer.sizes.sizing = sizing;
    options.quadSize = 0.1;
    const AutomaticConfiguration choice = ChooseConfiguration(domain, options);
    ASSERT_EQ(result.singularities.size(), choice.singularities.size());
    double moved = 0.0;
    for (std::size_t i = 0; i < choice.singularities.size(); ++i)
    {
      const Singularity& used = result.singularities[i];
      moved = std::max(moved, (used.position - choice.singularities[i].position).norm());
      EXPECT_EQ(used.quarterIndex, choice.singularities[i].quarterIndex);
      EXPECT_TRUE(IsNode(result.quads.mesh, used)) << Describe(used.position);
    }
    EXPECT_EQ(result.moved, moved);
    // Uniform sizes move them, by more than a tenth of a quad.
    const bool isConformal = sizing == Sizing::Conformal;
    EXPECT_EQ(moved < 1e-9, isConformal) << moved;
    ASSERT_GE(result.events.size(), choice.events.size());
    EXPECT_TRUE(std::equal(choice.events.begin(), choice.events.end(), result.events.begin()));
    EXPECT_EQ(result.events.size() == choice.events.size(), isConformal);
    EXPECT_EQ(result.events.back().find("to its node at") == std::string::npos, isConformal);
    ASSERT_TRUE(result.optimum);
    EXPECT_GT(result.seconds.choose, 0.0);
  }
}

TEST(QuadWorkflow, WhatItUsedGivesTheSameMesh)
{
  QuadRequest request;
  request.quadCount = 300;
  request.sizing = Sizing::Conformal; // other sizes move the nodes
  const PlanarDomain star = Builtin("star");
  const QuadWorkflowResult chosen = MakeQuadMesh(star, request);
  // Five corners of index 2 are capped, and singularities make up for it.
  EXPECT_EQ(chosen.corners.size(), 10U);
  EXPECT_EQ(SumOfQuarters(chosen), 4);
  EXPECT_TRUE(std::all_of(chosen.corners.begin(), chosen.corners.end(),
    [](const CornerChoice& corner) { return corner.quarterIndex <= 1; }));
  request.singularities = chosen.singularities;
  request.corners = chosen.corners;
  request.capCorners = false;
  const QuadWorkflowResult again = MakeQuadMesh(star, request);
  ExpectSamePoints(again.quads.mesh, chosen.quads.mesh, 1e-9);
}

TEST(QuadWorkflow, CornersUsedAreAllOfTheBoundary)
{
  QuadRequest request;
  request.quadSize = 0.25;
  const QuadWorkflowResult result = MakeQuadMesh(LShape(), request);
  EXPECT_EQ(result.corners.size(), 6U);
  EXPECT_EQ(SumOfQuarters(result), 4);
}

TEST(QuadWorkflow, SingularitiesAreAtTheirPositionsAfterRepair)
{
  const PlanarDomain ring = RingOfEdges(0.05);
  QuadRequest request;
  request.singularities = Join(OnCircle(4, 0.8, 0.25, 1, 0.0), OnCircle(4, 0.55, 0.1, -1, 0.0));
  request.quadSize = 0.1;
  request.repairHolonomy = true;
  const QuadWorkflowResult result = MakeQuadMesh(ring, request);
  ASSERT_TRUE(result.repair);
  EXPECT_GT(result.repair->largestMove, 0.01);
  ASSERT_EQ(result.holonomyDefect.size(), 1U);
  EXPECT_LT(std::abs(result.holonomyDefect[0]), NoticeableDefect);
  double largest = 0.0;
  for (std::size_t i = 0; i < 8; ++i)
  {
    const Point& position = result.singularities[i].position;
    largest = std::max(largest, (position - (*request.singularities)[i].position).norm());
    EXPECT_TRUE(std::any_of(result.quads.mesh.points.begin(), result.quads.mesh.points.end(),
      [&position](const QuadPoint& point) { return (point.InPlane() - position).norm() < 1e-9; }));
  }
  EXPECT_EQ(largest, result.repair->largestMove);
  // The report of moves includes the repair.
  EXPECT_NEAR(result.moved, largest, 1e-9);
  EXPECT_GT(result.seconds.choose, 0.0);
}

/// Half of the way leaves about half of the defect, and less stretch.
TEST(QuadWorkflow, RepairsAPartOfTheHolonomy)
{
  const PlanarDomain ring = RingOfEdges(0.05);
  QuadRequest request;
  request.singularities = Join(OnCircle(4, 0.8, 0.25, 1, 0.0), OnCircle(4, 0.55, 0.1, -1, 0.0));
  request.quadSize = 0.1;
  const QuadWorkflowResult none = MakeQuadMesh(ring, request);
  request.repairHolonomy = true;
  request.repairPart = 0.5;
  const QuadWorkflowResult half = MakeQuadMesh(ring, request);
  ASSERT_TRUE(half.repair);
  const double defect = half.repair->before[0];
  EXPECT_NEAR(none.holonomyDefect[0], defect, 0.01 * std::abs(defect));
  EXPECT_NEAR(half.holonomyDefect[0], 0.5 * defect, 0.05 * std::abs(defect));
  double largest = 0.0;
  for (std::size_t i = 0; i < 8; ++i)
  {
    largest = std::max(largest,
      (half.repair->singularities[i].position - (*request.singularities)[i].position).norm());
  }
  EXPECT_NEAR(largest, half.repair->largestMove, 1e-12);
}

TEST(QuadWorkflow, ThinDomainsHaveAMap)
{
  for (const double length : { 40.0, 1000.0 })
  {
    const PlanarDomain strip =
      MakePlanarDomain({ { { 0.0, 0.0 }, { length, 0.0 }, { length, 1.0 }, { 0.0, 1.0 } } });
    QuadRequest request;
    request.singularities = Configuration{};
    request.quadSize = 0.5;
    const QuadWorkflowResult result = MakeQuadMesh(strip, request);
    EXPECT_EQ(result.quads.mesh.quads.size(), static_cast<std::size_t>(4.0 * length));
    EXPECT_NEAR(result.quads.quality.jacobian.min, 1.0, 1e-9);
    EXPECT_TRUE(result.events.empty());
  }
}

/// Index 2 takes the whole half turn of a smooth boundary.
TEST(QuadWorkflow, RefusesASmoothBoundaryPointOfIndexTwo)
{
  const PlanarDomain disk = DiskOfEdges(0.1);
  QuadRequest request;
  request.singularities =
    Configuration{ { disk.loops[0][5], 2 }, { { 0.0, 0.3 }, 1 }, { { -0.5, 0.0 }, 1 } };
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(disk, request); },
    { Describe(disk.loops[0][5]), "quarter index 2", "index 1 inside the domain" }));
  request.singularities = Configuration{ { 0.7 * disk.loops[0][2], 1 },
    { 0.7 * disk.loops[0][8], 1 }, { { 0.0, 0.3 }, 1 }, { { -0.5, 0.0 }, 1 } };
  EXPECT_EQ(MakeQuadMesh(disk, request).quads.quality.inverted, 0);
}

TEST(QuadWorkflow, RefusesMoreQuadsThanTheMaximum)
{
  QuadRequest request;
  for (const double size : { 1e-7, 1e-12, 1e-100, 1e-300 })
  {
    request.quadSize = size;
    EXPECT_TRUE(
      Refuses([&] { MakeQuadMesh(LShape(), request); }, { "maximum of 5e+07", "a larger size" }));
  }
  request.quadSize = 0.0;
  request.quadCount = 2000000000;
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(LShape(), request); }, { "fewer quads" }));
}

TEST(PrescribedSizes, AreRelativeToTheirMeanAndContinuedFromTheBoundary)
{
  const PlanarDomain plate =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 1.0 }, { 0.0, 1.0 } } });
  const SharedPlanarTopology topology = ShareTopology(MeshThroughPoints(plate, {}, 0.1));
  const auto size = [](const Point& place) { return 0.2 * std::exp(0.4 * place.x()); };
  for (const bool isOnBoundaryOnly : { false, true })
  {
    const RelativeSizes sizes = ComputeRelativeSizes({ size, isOnBoundaryOnly, {} }, *topology);
    // The number of quads is ∫ dA / h² = 25 (1 − e^{−2.4}) / 0.8.
    EXPECT_NEAR(sizes.mean, std::sqrt(3.0 * 0.8 / (25.0 * (1.0 - std::exp(-2.4)))), 1e-3);
    for (const Point& place : { Point(0.1, 0.1), Point(1.52, 0.48), Point(3.0, 1.0) })
    {
      EXPECT_NEAR(sizes.mean * sizes.field(place) / size(place), 1.0, 1e-3);
    }
  }
}

TEST(QuadWorkflow, EllipsesOfAnyRatioHaveQuads)
{
  int points = 230; // those at the tips are closer together or farther apart than quads
  for (const double ratio : { 2.0, 12.0, 28.0, 45.0, 90.0 })
  {
    SCOPED_TRACE(ratio);
    Loop loop = RegularPolygon(points);
    for (Point& point : loop)
    {
      point.x() *= ratio;
    }
    const QuadWorkflowResult result = MakeQuadMesh(MakePlanarDomain({ loop }), QuadRequest{});
    EXPECT_GT(result.quads.quality.jacobian.min, 0.3);
    const std::string worst = DescribeWorstQuad(result.quads.mesh, result.quads.quality);
    EXPECT_TRUE(worst.empty()) << worst;
    points += 100;
  }
}

TEST(QuadWorkflow, WarnsOfNodeWithoutAngle)
{
  // Two quads at an interior node of valence 2 have 180° each.
  const PlanarDomain disk = DiskOfEdges(0.05);
  QuadRequest request;
  request.singularities =
    Configuration{ { { -0.4, 0.1 }, 2, 0.0 }, { { 0.3, 0.4 }, 1, 0.0 }, { { 0.4, -0.4 }, 1, 0.0 } };
  request.quadCount = 400;
  const QuadWorkflowResult result = MakeQuadMesh(disk, request);
  EXPECT_LT(result.quads.quality.jacobian.min, 0.05);
  EXPECT_LT((result.quads.quality.where - SpacePoint(-0.4, 0.1, 0.0)).norm(), 0.2);
  const std::vector<std::string>& warnings = result.warnings;
  const auto worst = std::find_if(warnings.begin(), warnings.end(),
    [](const std::string& warning) { return warning.find("valence 2") != std::string::npos; });
  ASSERT_NE(worst, warnings.end());
  EXPECT_NE(worst->find("--split"), std::string::npos) << *worst;
}
}
}
