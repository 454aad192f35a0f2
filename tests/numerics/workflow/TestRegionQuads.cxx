// Quads of several materials.

#include "RegionQuads.h"

#include "Error.h"
#include "JoinedParts.h"
#include "LayerChecks.h"
#include "MakeRegionSet.h"
#include "NodeIndices.h"
#include "PoincareHopf.h"
#include "RegionNodes.h"
#include "RegionSides.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

namespace crossfield::test
{
namespace
{
/// Collects polygons of materials; points at equal places are one.
class CellMaker
{
public:
  void Add(const std::string& material, const Loop& polygon)
  {
    auto name = std::find(this->Cells.names.begin(), this->Cells.names.end(), material);
    this->Cells.materials.push_back(static_cast<int>(name - this->Cells.names.begin()));
    if (name == this->Cells.names.end())
    {
      this->Cells.names.push_back(material);
    }
    this->Cells.cells.emplace_back();
    for (const Point& point : polygon)
    {
      const auto key = std::make_pair(std::lround(1e7 * point.x()), std::lround(1e7 * point.y()));
      const auto [found, isNew] =
        this->Numbers.emplace(key, static_cast<int>(this->Cells.points.size()));
      if (isNew)
      {
        this->Cells.points.push_back(point);
      }
      std::vector<int>& cell = this->Cells.cells.back();
      if (cell.empty() || (cell.back() != found->second && cell.front() != found->second))
      {
        cell.push_back(found->second);
      }
    }
  }

  MaterialCells Cells;

private:
  std::map<std::pair<long, long>, int> Numbers;
};

Loop ArcOf(const Point& centre, double radius, double from, double to, int count)
{
  Loop points;
  for (int i = 0; i <= count; ++i)
  {
    const double angle = from + (to - from) * i / count;
    points.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
  }
  return points;
}

/// A square [−1, 1]² cut by the line through its centre at an angle with the x axis.
MaterialCells ObliqueCut(double degrees)
{
  const double x = 1.0 / std::tan(degrees * Pi / 180.0);
  CellMaker maker;
  maker.Add("left", { { -1, -1 }, { -x, -1 }, { x, 1 }, { -1, 1 } });
  maker.Add("right", { { -x, -1 }, { 1, -1 }, { 1, 1 }, { x, 1 } });
  return maker.Cells;
}

/// A disc of radius r in a square [−1, 1]².
MaterialCells FibreInSquare(double r)
{
  constexpr int Half = 40;
  const Loop upper = ArcOf(Point::Zero(), r, 0.0, Pi, Half);
  const Loop lower = ArcOf(Point::Zero(), r, -Pi, 0.0, Half);
  Loop fibre(upper.begin(), upper.end() - 1);
  fibre.insert(fibre.end(), lower.begin(), lower.end() - 1);
  CellMaker maker;
  maker.Add("fibre", fibre);
  Loop above = { { 1, 0 }, { 1, 1 }, { -1, 1 }, { -1, 0 } };
  above.insert(above.end(), upper.rbegin(), upper.rend());
  Loop below = { { -1, 0 }, { -1, -1 }, { 1, -1 }, { 1, 0 } };
  below.insert(below.end(), lower.rbegin(), lower.rend());
  maker.Add("matrix", above);
  maker.Add("matrix", below);
  return maker.Cells;
}

/// Three sectors of 120° of a disc.
MaterialCells ThreeSectors()
{
  CellMaker maker;
  for (int i = 0; i < 3; ++i)
  {
    Loop sector = ArcOf(Point::Zero(), 1.0, 2.0 * Pi * i / 3.0, 2.0 * Pi * (i + 1) / 3.0, 40);
    sector.push_back(Point::Zero());
    maker.Add(std::string(1, static_cast<char>('a' + i)), sector);
  }
  return maker.Cells;
}

/// Returns the part of a polygon where (x − middle) · normal ≤ 0.
Loop Clip(const Loop& polygon, const Point& middle, const Point& normal)
{
  Loop clipped;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double da = (a - middle).dot(normal);
    const double db = (b - middle).dot(normal);
    if (da <= 0.0)
    {
      clipped.push_back(a);
    }
    if ((da <= 0.0) != (db <= 0.0))
    {
      clipped.push_back(a + da / (da - db) * (b - a));
    }
  }
  return clipped;
}

/// The Voronoi cells of points of a jittered grid in a square, each of a material of its own.
MaterialCells VoronoiCells(unsigned seed, int rows)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> jitter(-0.3, 0.3);
  std::vector<Point> seeds;
  for (int i = 0; i < rows * rows; ++i)
  {
    const double x = i % rows + 0.5 + jitter(random);
    const double y = i / rows + 0.5 + jitter(random);
    seeds.emplace_back(2.0 * x / rows - 1.0, 2.0 * y / rows - 1.0);
  }
  std::vector<Loop> cells;
  for (const Point& own : seeds)
  {
    Loop cell = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    for (const Point& other : seeds)
    {
      if (other != own)
      {
        cell = Clip(cell, 0.5 * (own + other), other - own);
      }
    }
    cells.push_back(cell);
  }
  CellMaker maker;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    maker.Add("m" + std::to_string(i), cells[i]);
  }
  return maker.Cells;
}

std::vector<DomainPart> PartsOf(const RegionSet& set)
{
  std::vector<DomainPart> parts;
  std::vector<std::string> taken;
  for (std::size_t r = 0; r < set.regions.size(); ++r)
  {
    parts.push_back({ set.regions[r].domain, SidesOfRegion(set, r, {}, taken), {} });
    const BoundarySides& sides = parts.back().sides;
    taken.insert(taken.end(), sides.names.begin() + sides.given, sides.names.end());
  }
  return parts;
}

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

std::vector<int> IndicesAt(const std::vector<double>& degrees, bool isOnBoundary)
{
  NodeCorners node;
  node.isOnBoundary = isOnBoundary;
  for (const double angle : degrees)
  {
    node.corners.push_back(
      { static_cast<int>(node.corners.size()), angle * Pi / 180.0, std::nullopt });
  }
  return ChooseNodeIndices({ node }, std::vector<int>(degrees.size(), 1))[0];
}

TEST(RegionNodes, HaveIndicesThatAreChosenTogether)
{
  EXPECT_EQ(IndicesAt({ 120, 120, 120 }, false), (std::vector<int>{ 1, 1, 1 }));
  EXPECT_EQ(IndexOfNode({ 1, 1, 1 }, false), 1);
  EXPECT_EQ(IndicesAt({ 70, 110, 70, 110 }, false), (std::vector<int>{ 1, 1, 1, 1 }));
  EXPECT_EQ(IndexOfNode({ 1, 1, 1, 1 }, false), 0);
  EXPECT_EQ(IndicesAt({ 60, 120 }, true), (std::vector<int>{ 1, 1 }));
  EXPECT_EQ(IndexOfNode({ 1, 1 }, true), 0);
  EXPECT_EQ(IndicesAt({ 90, 90, 180 }, false), (std::vector<int>{ 1, 1, 0 }));
  EXPECT_EQ(IndicesAt({ 90, 270 }, false), (std::vector<int>{ 1, -1 }));
}

TEST(RegionNodes, AreRegularWhereThatSparesIrregularNodes)
{
  // A region without singularities of its own gives the fourth quad; only one of the three does.
  NodeCorners node;
  node.corners = { { 0, 2.0 * Pi / 3.0, std::nullopt }, { 1, 2.0 * Pi / 3.0, std::nullopt },
    { 2, 2.0 * Pi / 3.0, std::nullopt } };
  const std::vector<int> indices = ChooseNodeIndices({ node }, { 1, 0, 1 })[0];
  EXPECT_EQ(indices, (std::vector<int>{ 1, 0, 1 }));
  node.corners[1].prescribed = 1;
  EXPECT_EQ(ChooseNodeIndices({ node }, { 1, 0, 1 })[0], (std::vector<int>{ 1, 1, 1 }));
}

TEST(RegionSet, HasPiecesWithEqualPointsOnBothSides)
{
  for (const unsigned seed : { 1U, 2U, 3U, 4U, 5U })
  {
    const RegionSet set = MakeRegionSet(VoronoiCells(seed, 4));
    ASSERT_EQ(set.regions.size(), 16U);
    const std::vector<DomainPart> parts = PartsOf(set);
    using Segment = std::array<double, 4>;
    std::map<Segment, int> sides;
    for (const Region& region : set.regions)
    {
      for (const Loop& loop : region.domain.loops)
      {
        for (std::size_t i = 0; i < loop.size(); ++i)
        {
          const Point& a = loop[i];
          const Point& b = loop[(i + 1) % loop.size()];
          ++sides[{ a.x(), a.y(), b.x(), b.y() }];
        }
      }
    }
    std::size_t inside = 0;
    for (const auto& [segment, count] : sides)
    {
      EXPECT_EQ(count, 1);
      const bool isPaired = sides.count({ segment[2], segment[3], segment[0], segment[1] }) > 0;
      const bool isOnOutline = std::abs(segment[0]) == 1.0 || std::abs(segment[1]) == 1.0;
      EXPECT_TRUE(isPaired || isOnOutline);
      inside += isPaired ? 1 : 0;
    }
    std::size_t pieces = 0;
    for (const InterfacePiece& piece : set.interfaces)
    {
      pieces += piece.line.size() - 1;
      EXPECT_LT(piece.regions[0], piece.regions[1]);
      for (const int region : piece.regions)
      {
        EXPECT_GE(parts[static_cast<std::size_t>(region)].sides.Find(piece.name), 0);
      }
    }
    EXPECT_EQ(2 * pieces, inside);
    // What singularities, nodes and corners have together is 4χ.
    const auto corners =
      FindNodeCorners(set, std::vector<std::vector<CornerChoice>>(set.regions.size()));
    int sum = 4; // the corners of the square, in one region each
    std::vector<std::vector<CornerChoice>> choices(set.regions.size());
    for (std::size_t n = 0; n < corners.size(); ++n)
    {
      sum += IndexAt(set.nodes[n], corners[n]);
      for (const RegionCorner& corner : corners[n])
      {
        choices[corner.region].push_back({ corner.corner.position, corner.quarterIndex });
      }
    }
    for (std::size_t r = 0; r < set.regions.size(); ++r)
    {
      sum += CountQuarters(set.regions[r].domain.loops, 0, DefaultCornerAngle, choices[r])
               .requiredInteriorQuarters;
    }
    EXPECT_EQ(sum, 4);
  }
}

TEST(RegionSet, DoesNotDependOnTheOrderOfCells)
{
  MaterialCells cells = VoronoiCells(7, 3);
  const RegionSet set = MakeRegionSet(cells);
  std::reverse(cells.cells.begin(), cells.cells.end());
  std::reverse(cells.materials.begin(), cells.materials.end());
  for (std::vector<int>& cell : cells.cells)
  {
    std::reverse(cell.begin(), cell.end());
  }
  const RegionSet other = MakeRegionSet(cells);
  ASSERT_EQ(other.regions.size(), set.regions.size());
  for (std::size_t r = 0; r < set.regions.size(); ++r)
  {
    EXPECT_EQ(other.regions[r].domain.loops, set.regions[r].domain.loops);
  }
  ASSERT_EQ(other.interfaces.size(), set.interfaces.size());
  for (std::size_t p = 0; p < set.interfaces.size(); ++p)
  {
    EXPECT_EQ(other.interfaces[p].name, set.interfaces[p].name);
    EXPECT_EQ(other.interfaces[p].line, set.interfaces[p].line);
  }
}

TEST(RegionSet, RefusesOverlappingCells)
{
  CellMaker maker;
  maker.Add("a", { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
  maker.Add("b", { { 0, 0 }, { 1, 0 }, { 1, 2 }, { 0, 2 } });
  EXPECT_THROW(MakeRegionSet(maker.Cells), Error);
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

TEST(RegionQuads, ConformInRandomPartitions)
{
  for (unsigned seed = 0; seed < 10; ++seed)
  {
    SCOPED_TRACE(seed);
    ExpectConforming(QuadsOf(VoronoiCells(seed, 3), 900), 4.0, 1);
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

TEST(RegionQuads, RefuseWhatIsNotAvailable)
{
  const RegionSet set = MakeRegionSet(ObliqueCut(75.0));
  QuadRequest request;
  request.merge = BlockMerge::Clean;
  EXPECT_THROW(MakeQuadsOfRegions(set, PartsOf(set), request), Error);
}
}
}
