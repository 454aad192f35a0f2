// Quads of symmetric parts are symmetric, with chosen singularities and with what is prescribed for
// sides; layers have room whatever the number of quads; corners are nodes.

#include "QuadWorkflow.h"

#include "BoundarySymmetry.h"
#include "MakePlanarDomain.h"
#include "MeshGrade.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
Loop Moved(Loop loop, const Point& shift, double angle = 0.0)
{
  for (Point& point : loop)
  {
    point = Eigen::Rotation2Dd(angle) * Point(point + shift);
  }
  return loop;
}

PlanarDomain Flange(int holes)
{
  std::vector<Loop> loops = { RegularPolygon(20 * holes) };
  for (int i = 0; i < holes; ++i)
  {
    loops.push_back(Moved(RegularPolygon(32, 0.1), { 0.65, 0.0 }, 2.0 * Pi * i / holes));
  }
  return MakePlanarDomain(loops);
}

PlanarDomain Gear(int teeth)
{
  Loop gear;
  for (int i = 0; i < teeth; ++i)
  {
    for (const auto& [part, radius] :
      { std::pair(-0.25, 0.8), std::pair(-0.15, 1.0), std::pair(0.15, 1.0), std::pair(0.25, 0.8) })
    {
      const double angle = 2.0 * Pi * (i + part) / teeth;
      gear.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  }
  return MakePlanarDomain({ gear });
}

PlanarDomain Star(int tips)
{
  Loop star;
  for (int i = 0; i < 2 * tips; ++i)
  {
    const double radius = i % 2 == 0 ? 1.0 : 0.6;
    star.emplace_back(radius * std::cos(Pi * i / tips), radius * std::sin(Pi * i / tips));
  }
  return MakePlanarDomain({ star });
}

PlanarDomain PlateWithHoles(int columns, int rows)
{
  const double width = columns;
  const double height = rows;
  std::vector<Loop> loops = { { { 0.0, 0.0 }, { width, 0.0 }, { width, height },
    { 0.0, height } } };
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      loops.push_back(Moved(RegularPolygon(32, 0.2), { i + 0.5, j + 0.5 }));
    }
  }
  return MakePlanarDomain(loops);
}

QuadWorkflowResult QuadsOf(const PlanarDomain& domain, int count)
{
  QuadRequest request;
  request.quadCount = count;
  return MakeQuadMesh(domain, request);
}

/// Expects that the points of a mesh are those of its images under symmetries of the domain, as
/// many as the report says.
void ExpectSymmetric(const PlanarDomain& domain, const QuadWorkflowResult& result)
{
  const double reach = 1e-9 * domain.Diagonal();
  const std::vector<QuadPoint>& points = result.quads.mesh.points;
  int count = 0;
  for (const Isometry& element : FindSymmetries(domain).Elements())
  {
    count += std::all_of(points.begin(), points.end(),
               [&](const QuadPoint& point)
               {
                 const Point image = element(point.InPlane());
                 return std::any_of(points.begin(), points.end(),
                   [&](const QuadPoint& other)
                   { return (other.InPlane() - image).squaredNorm() <= reach * reach; });
               })
      ? 1
      : 0;
  }
  EXPECT_GE(count, result.quads.smoothing.symmetries);
}

TEST(SymmetricQuads, PartsKeepTheirSymmetries)
{
  struct Case
  {
    const char* name;
    PlanarDomain domain;
    int least; ///< Number of symmetries with the identity.
  };
  const std::vector<Case> cases = { { "triangle", MakePlanarDomain({ RegularPolygon(3) }), 6 },
    { "pentagon", MakePlanarDomain({ RegularPolygon(5) }), 10 },
    { "hexagon", MakePlanarDomain({ RegularPolygon(6) }), 4 },
    { "heptagon", MakePlanarDomain({ RegularPolygon(7) }), 2 },
    { "octagon", MakePlanarDomain({ RegularPolygon(8) }), 8 },
    { "nonagon", MakePlanarDomain({ RegularPolygon(9) }), 2 },
    { "nut", MakePlanarDomain({ RegularPolygon(6), RegularPolygon(48, 0.5) }), 12 },
    { "flange3", Flange(3), 2 }, { "flange4", Flange(4), 8 }, { "flange6", Flange(6), 2 },
    { "gear6", Gear(6), 4 }, { "gear8", Gear(8), 8 }, { "gear12", Gear(12), 4 },
    { "star5", Star(5), 10 }, { "star6", Star(6), 2 }, { "plate2x2", PlateWithHoles(2, 2), 8 },
    { "plate3x2", PlateWithHoles(3, 2), 4 } };
  for (const Case& one : cases)
  {
    for (const int count : { 400, 1000 })
    {
      SCOPED_TRACE(one.name + (" with " + std::to_string(count)));
      const QuadWorkflowResult result = QuadsOf(one.domain, count);
      EXPECT_EQ(result.quads.quality.inverted, 0);
      EXPECT_GE(result.quads.smoothing.symmetries, one.least);
      ExpectSymmetric(one.domain, result);
    }
  }
}

TEST(SymmetricQuads, PrescriptionsThatAreSymmetricKeepAMirror)
{
  const PlanarDomain plate = PlateWithHoles(2, 2);
  QuadRequest request;
  request.quadCount = 2000;
  request.sideRequests = { CountOf("hole0", 40) };
  const QuadWorkflowResult even = MakeQuadMesh(plate, request);
  EXPECT_EQ(even.quads.smoothing.symmetries, 2); // about a diagonal
  ExpectSymmetric(plate, even);
}

/// Returns a channel with a round cylinder whose centre is a little off the axis.
PlanarDomain Channel()
{
  return MakePlanarDomain(
    { { { -0.5, -0.2 }, { 2.0, -0.2 }, { 2.0, 0.21 }, { -0.5, 0.21 } }, RegularPolygon(64, 0.05) });
}

TEST(SymmetricQuads, LayersHaveRoomWhateverTheNumberOfQuads)
{
  for (const int count : { 2000, 10000, 30000 })
  {
    QuadRequest request;
    request.quadCount = count;
    request.sideRequests = { LayerOf("hole0", 1e-3), LayerOf("outer0", 1e-3) };
    const QuadWorkflowResult result = MakeQuadMesh(Channel(), request);
    EXPECT_TRUE(result.warnings.empty()) << count;
    ASSERT_EQ(result.layers.size(), 2U);
    for (const LayerReport& layer : result.layers)
    {
      EXPECT_EQ(layer.partInBounds, 1.0) << count;
      EXPECT_LE(layer.largestRatio, 2.25) << count; // the step behind a layer that is accepted
    }
  }
}

TEST(SymmetricQuads, LayersWithoutRoomForTheirRowsAreThinWithAWarning)
{
  QuadRequest request;
  request.quadCount = 150;
  request.sideRequests = { LayerOf("hole0", 2e-3) };
  const QuadWorkflowResult result = MakeQuadMesh(Channel(), request);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  ASSERT_EQ(result.layers.size(), 1U);
  EXPECT_FALSE(result.layers[0].lack.empty());
  EXPECT_TRUE(AnyHas(result.warnings, "heights of neighbours differ by up to"));
  EXPECT_GT(result.attempts.size(), 1U);
}

TEST(SymmetricQuads, CornersWithoutASingularityAreNodes)
{
  // Chamfers that are a few quads long.
  const PlanarDomain plate = MakePlanarDomain({ { { 0.2, 0.0 }, { 2.8, 0.0 }, { 3.0, 0.2 },
    { 3.0, 1.8 }, { 2.8, 2.0 }, { 0.2, 2.0 }, { 0.0, 1.8 }, { 0.0, 0.2 } } });
  const QuadWorkflowResult result = QuadsOf(plate, 1000);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_LT(AreaError(result.quads), 1e-12);
  for (const Point& corner : plate.loops[0])
  {
    EXPECT_TRUE(std::any_of(result.quads.mesh.points.begin(), result.quads.mesh.points.end(),
      [&](const QuadPoint& point) { return (point.InPlane() - corner).norm() < 1e-12; }));
  }
}
}
}
