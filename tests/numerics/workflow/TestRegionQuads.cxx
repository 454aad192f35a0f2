// Quads of several materials.

#include "RegionQuads.h"

#include "Error.h"
#include "JoinedParts.h"
#include "LayerChecks.h"
#include "MakeRegionSet.h"
#include "Partitions.h"
#include "RegionRequests.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace crossfield::test
{
namespace
{
QuadWorkflowResult QuadsOf(const MaterialCells& cells, int count)
{
  const RegionSet set = MakeRegionSet(cells);
  QuadRequest request;
  request.quadCount = count;
  return MakeQuadsOfRegions(set, PartsOf(set), request);
}

/// Expects one mesh of an area with the Euler number, whose blocks are each in one region.
void ExpectConforming(const QuadWorkflowResult& result, double area, int euler)
{
  const QuadMesh& mesh = result.quads.mesh;
  EXPECT_EQ(mesh.EulerCharacteristic(), euler);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  ExpectSoundBlocks(result.quads);
  std::vector<int> regionOf(result.quads.blocks.blocks.size(), -1);
  double sum = 0.0;
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    int& region = regionOf[static_cast<std::size_t>(result.quads.blocks.block[q])];
    EXPECT_TRUE(region < 0 || region == result.region[q]);
    region = result.region[q];
    const auto at = [&](std::size_t c)
    { return mesh.points[static_cast<std::size_t>(mesh.quads[q][c])].InPlane(); };
    sum += 0.5 * Cross(at(2) - at(0), at(3) - at(1));
  }
  EXPECT_NEAR(sum, area, 0.01 * area);
  // An edge between two regions is an edge of the interface, and no other one is.
  std::set<std::pair<int, int>> interfaces;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.kind == BoundaryKind::Interface)
    {
      EXPECT_TRUE(interfaces.insert(std::minmax(edge.points[0], edge.points[1])).second);
    }
  }
  std::set<std::pair<int, int>> between;
  const std::vector<int> twins = mesh.Twins();
  for (std::size_t side = 0; side < twins.size(); ++side)
  {
    if (twins[side] >= 0 &&
      result.region[side / 4] != result.region[static_cast<std::size_t>(twins[side]) / 4])
    {
      between.insert(
        std::minmax(mesh.quads[side / 4][side % 4], mesh.quads[side / 4][(side + 1) % 4]));
    }
  }
  EXPECT_EQ(interfaces, between);
  int irregular = 0;
  for (const QuadPoint& point : mesh.points)
  {
    EXPECT_EQ(point.valence, (point.curve.loop < 0 ? 4 : 2) - point.quarterIndex);
    irregular += point.quarterIndex;
  }
  EXPECT_EQ(irregular, 4 * euler);
  for (const RegionReport& region : result.regions)
  {
    EXPECT_EQ(region.requiredQuarters, region.givenQuarters);
    EXPECT_GT(region.quads, 0U);
  }
}

TEST(RegionQuads, AreThoseOfOneRegionAlongAStraightInterface)
{
  const QuadWorkflowResult cut = QuadsOf(ObliqueCut(90.0), 784);
  ExpectConforming(cut, 4.0, 1);
  EXPECT_NEAR(cut.quads.quality.jacobian.min, 1.0, 1e-10);
  EXPECT_EQ(cut.materials, (std::vector<std::string>{ "left", "right" }));
  ASSERT_EQ(cut.interfaces.size(), 1U);
  EXPECT_EQ(cut.interfaces[0].side, "left+right");
  EXPECT_NEAR(cut.interfaces[0].largestRatio, 1.0, 1e-9);
  const PlanarDomain square{ { { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } } } };
  QuadRequest request;
  request.quadCount = static_cast<int>(cut.quads.mesh.quads.size());
  const QuadWorkflowResult whole = MakeQuadsOfParts({ { square, NameSides(square), {} } }, request);
  const auto sorted = [](const QuadMesh& mesh)
  {
    std::vector<std::pair<double, double>> places;
    for (const QuadPoint& point : mesh.points)
    {
      // Places up to rounding, so that both meshes have the same order.
      places.emplace_back(std::round(1e8 * point.place.x()), std::round(1e8 * point.place.y()));
    }
    std::sort(places.begin(), places.end());
    return places;
  };
  const auto ofCut = sorted(cut.quads.mesh);
  auto ofWhole = sorted(whole.quads.mesh);
  if (ofCut != ofWhole)
  {
    // turned by 90°
    for (std::pair<double, double>& place : ofWhole)
    {
      std::swap(place.first, place.second);
    }
    std::sort(ofWhole.begin(), ofWhole.end());
  }
  EXPECT_EQ(ofCut, ofWhole);
}

TEST(RegionQuads, ReachTheAngleOfAnObliqueInterface)
{
  for (const double degrees : { 73.0, 60.0, 50.0 })
  {
    const QuadWorkflowResult cut = QuadsOf(ObliqueCut(degrees), 800);
    ExpectConforming(cut, 4.0, 1);
    EXPECT_NEAR(cut.quads.quality.jacobian.min, std::sin(degrees * Pi / 180.0), 0.01);
    EXPECT_TRUE(cut.singularities.empty());
  }
}

TEST(RegionQuads, MeetAroundAFibre)
{
  for (const double radius : { 0.3, 0.5, 0.7 })
  {
    const QuadWorkflowResult result = QuadsOf(FibreInSquare(radius), 800);
    ExpectConforming(result, 4.0, 1);
    EXPECT_EQ(result.singularities.size(), 8U);
    EXPECT_GT(result.quads.quality.jacobian.min, 0.83);
    EXPECT_EQ(result.quads.blocks.blocks.size(), 17U); // separatrices of both regions meet
    EXPECT_EQ(result.quads.mesh.sideNames[0], "fibre+matrix");
  }
}

TEST(RegionQuads, HaveAnIrregularNodeWhereThreeSectorsMeet)
{
  const QuadWorkflowResult result = QuadsOf(ThreeSectors(), 720);
  ExpectConforming(result, Pi, 1);
  EXPECT_EQ(result.singularities.size(), 3U);
  const auto centre = std::find_if(result.quads.mesh.points.begin(), result.quads.mesh.points.end(),
    [](const QuadPoint& point) { return point.InPlane().norm() < 1e-12; });
  ASSERT_NE(centre, result.quads.mesh.points.end());
  EXPECT_EQ(centre->valence, 3);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.72);
}

TEST(RegionQuads, ConformInTwentyRandomPartitions)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectConforming(QuadsOf(VoronoiCells(seed, 3), 900), 4.0, 1);
    ExpectConforming(QuadsOf(VoronoiCells(seed + 10, 3, true), 1200), 4.0, 1);
  }
}

TEST(RegionQuads, HaveCountsOfInterfaces)
{
  const RegionSet set = MakeRegionSet(ObliqueCut(75.0));
  QuadRequest request;
  request.quadCount = 800;
  request.sideRequests = { CountOf("left+right", 23) };
  const QuadWorkflowResult result = MakeQuadsOfRegions(set, PartsOf(set), request);
  ExpectConforming(result, 4.0, 1);
  int edges = 0;
  for (const QuadBoundaryEdge& edge : result.quads.mesh.boundary)
  {
    edges += edge.kind == BoundaryKind::Interface ? 1 : 0;
  }
  EXPECT_EQ(edges, 23);
}

TEST(RegionQuads, HaveSizesInsideOfMaterials)
{
  const RegionSet set = MakeRegionSet(FibreInSquare(0.4));
  QuadRequest request;
  request.quadSize = 0.12;
  SideRequest fibre;
  fibre.side = "fibre";
  fibre.inside = 0.05;
  request.sideRequests = { fibre };
  const QuadWorkflowResult result = MakeQuadsOfRegions(set, PartsOf(set), request);
  ExpectConforming(result, 4.0, 1);
  // Four singularities around the fibre leave a factor; sizes grow in the matrix from the interface.
  const double size = std::sqrt(Pi * 0.16 / static_cast<double>(result.regions[0].quads));
  EXPECT_GT(size, 0.045);
  EXPECT_LT(size, 0.065);
  EXPECT_GT(result.regions[1].quads, 300U);
  EXPECT_LT(result.regions[1].quads, 900U);
}

TEST(RegionQuads, HaveSizesThatGrowAcrossInterfaces)
{
  const RegionSet set = MakeRegionSet(FibreInSquare(0.4));
  QuadRequest request;
  SideRequest fibre;
  fibre.side = "fibre";
  fibre.inside = 0.04;
  SideRequest matrix;
  matrix.side = "matrix";
  matrix.inside = 0.12;
  request.sideRequests = { fibre, matrix };
  const QuadWorkflowResult result = MakeQuadsOfRegions(set, PartsOf(set), request);
  ExpectConforming(result, 4.0, 1);
  // Those of the matrix are three times as large away from the fibre, but not beside it.
  ASSERT_TRUE(result.sizes);
  EXPECT_GT(result.sizes->AreaShare(), 0.8);
  EXPECT_LT(result.interfaces.at(0).medianRatio, 1.5);
  EXPECT_LT(result.interfaces.at(0).largestRatio, 2.0);
}

TEST(RegionQuads, KeepGivenSingularities)
{
  const RegionSet set = MakeRegionSet(FibreInSquare(0.5));
  QuadRequest request;
  request.quadCount = 800;
  for (int i = 0; i < 4; ++i)
  {
    const double angle = Pi * (0.25 + 0.5 * i);
    const Point direction(std::cos(angle), std::sin(angle));
    request.singularities = request.singularities.value_or(Configuration());
    request.singularities->push_back({ 0.35 * direction, 1 });
    request.singularities->push_back({ 0.7 * direction, -1 });
  }
  const QuadWorkflowResult result = MakeQuadsOfRegions(set, PartsOf(set), request);
  ExpectConforming(result, 4.0, 1);
  // Five blocks in the fibre and twelve around it: separatrices meet at the interface.
  EXPECT_LE(result.quads.blocks.blocks.size(), 17U);
}

TEST(RegionQuads, HoldSingularitiesExactly)
{
  const RegionSet set = MakeRegionSet(FibreInSquare(0.5));
  QuadRequest request;
  request.quadCount = 800;
  request.hold = true;
  request.singularities = Configuration{ { { 0.27, 0.21 }, 1 }, { { -0.2, 0.26 }, 1 },
    { { -0.24, -0.25 }, 1 }, { { 0.25, -0.23 }, 1 } };
  for (const double x : { 0.65, -0.65 })
  {
    request.singularities->push_back({ { x, 0.65 }, -1 });
    request.singularities->push_back({ { x, -0.65 }, -1 });
  }
  const QuadWorkflowResult result = MakeQuadsOfRegions(set, PartsOf(set), request);
  ExpectConforming(result, 4.0, 1);
  EXPECT_LT(result.moved, 1e-12);
  ASSERT_TRUE(result.moves);
  EXPECT_TRUE(result.moves->empty());
  EXPECT_GT(result.quads.quality.jacobian.min, 0.5);
}

TEST(RegionQuads, RefuseWhatIsNotAvailable)
{
  const RegionSet set = MakeRegionSet(ObliqueCut(75.0));
  QuadRequest request;
  request.merge = BlockMerge::Clean;
  EXPECT_THROW(MakeQuadsOfRegions(set, PartsOf(set), request), Error);
}

/// Quads of a square with lines, some of them open.
QuadWorkflowResult QuadsAlong(const std::vector<std::pair<std::string, Loop>>& lines,
  const std::vector<std::string>& open, QuadRequest request)
{
  RegionSet set = MakeRegionSet(SquareWithLines(lines));
  OpenInterfaces(open, set);
  request.quadCount = 400;
  return MakeQuadsOfRegions(set, PartsOf(set), request);
}

std::size_t PointsAt(const QuadMesh& mesh, const Point& place)
{
  return static_cast<std::size_t>(std::count_if(mesh.points.begin(), mesh.points.end(),
    [&place](const QuadPoint& point) { return (point.InPlane() - place).norm() < 1e-12; }));
}

TEST(RegionQuads, ALineOfAUniformMeshChangesNothing)
{
  const QuadWorkflowResult result = QuadsAlong({ { "line", { { -1, 0 }, { 0, 0 } } } }, {}, {});
  const QuadMesh& mesh = result.quads.mesh;
  ASSERT_EQ(mesh.quads.size(), 400U);
  ASSERT_EQ(mesh.points.size(), 441U);
  for (const QuadPoint& point : mesh.points)
  {
    const bool isCorner = std::abs(point.place.x()) == 1.0 && std::abs(point.place.y()) == 1.0;
    EXPECT_EQ(point.quarterIndex, isCorner ? 1 : 0) << point.place.transpose();
    // To a part of an edge: the slit was open while the map was made.
    for (const double x : { point.place.x(), point.place.y() })
    {
      EXPECT_NEAR(10.0 * x, std::round(10.0 * x), 0.01);
    }
    if (std::abs(point.place.y()) < 0.01 && point.place.x() <= 0.0)
    {
      EXPECT_EQ(point.place.y(), 0.0);
    }
  }
}

TEST(RegionQuads, AnOpenLineHasTwoNodesButAtItsEnd)
{
  const QuadWorkflowResult result =
    QuadsAlong({ { "crack", { { -1, 0 }, { 0, 0 } } } }, { "crack" }, {});
  const QuadMesh& mesh = result.quads.mesh;
  ASSERT_EQ(mesh.points.size(), 441U + 10U);
  EXPECT_EQ(PointsAt(mesh, { -1, 0 }), 2U);
  EXPECT_EQ(PointsAt(mesh, { 0, 0 }), 1U);
  std::map<std::string, int> edges;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    EXPECT_EQ(edge.kind, BoundaryKind::Outer); // the crack starts at the boundary
    ++edges[mesh.sideNames[static_cast<std::size_t>(edge.side)]];
  }
  EXPECT_EQ(edges["crack.left"], 10);
  EXPECT_EQ(edges["crack.right"], 10);
  EXPECT_EQ(mesh.EulerCharacteristic(), 1);
  // One inside is an inner loop.
  const QuadWorkflowResult inner =
    QuadsAlong({ { "crack", { { -0.5, 0 }, { 0.5, 0 } } } }, { "crack" }, {});
  EXPECT_EQ(inner.quads.mesh.EulerCharacteristic(), 0);
  EXPECT_EQ(inner.quads.quality.inverted, 0);
  EXPECT_GT(inner.quads.quality.jacobian.min, 0.99);
  for (const QuadBoundaryEdge& edge : inner.quads.mesh.boundary)
  {
    const std::string& side = inner.quads.mesh.sideNames[static_cast<std::size_t>(edge.side)];
    EXPECT_EQ(edge.kind == BoundaryKind::Inner, side.compare(0, 5, "crack") == 0);
  }
  EXPECT_THROW(QuadsAlong({ { "a", { { -1, 0 }, { 0, 0 } } } }, { "b" }, {}), Error);
}

TEST(RegionQuads, ObliqueLinesThatCrossAreConforming)
{
  const QuadWorkflowResult result = QuadsAlong(
    { { "a", { { -0.6, 0.05 }, { 0.5, 0.1 } } }, { "b", { { 0.05, -0.5 }, { 0.1, 0.6 } } } }, {},
    {});
  EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), 1);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.95);
  EXPECT_TRUE(result.singularities.empty());
}

TEST(RegionQuads, CountsOfLinesHoldOnBothSides)
{
  QuadRequest request;
  request.sideRequests.emplace_back();
  request.sideRequests.back().side = "crack";
  request.sideRequests.back().count = 14;
  const QuadWorkflowResult result =
    QuadsAlong({ { "crack", { { -1, 0 }, { 0, 0 } } } }, { "crack" }, request);
  std::map<std::string, int> edges;
  for (const QuadBoundaryEdge& edge : result.quads.mesh.boundary)
  {
    ++edges[result.quads.mesh.sideNames[static_cast<std::size_t>(edge.side)]];
  }
  EXPECT_EQ(edges["crack.left"], 14);
  EXPECT_EQ(edges["crack.right"], 14);
}

TEST(RegionQuads, NodesAreAtRequestedPlaces)
{
  QuadRequest request;
  request.nodes = { { 0.33, 0.41 }, { -0.52, 0.0 },
    { 1.0, 0.23 } }; // inside, on the line, on the boundary
  const QuadWorkflowResult result =
    QuadsAlong({ { "line", { { -1, 0 }, { 0, 0 } } } }, {}, request);
  for (const Point& place : request.nodes)
  {
    EXPECT_EQ(PointsAt(result.quads.mesh, place), 1U) << place.transpose();
  }
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.7);
}
}
}
