// Boundary layers of meshes whose rows are known, and prescriptions that are impossible.

#include "BoundaryLayers.h"

#include "Index.h"
#include "LayerChecks.h"
#include "LayerRows.h"
#include "MakePlanarDomain.h"
#include "QuadSides.h"
#include "QuadWorkflow.h"
#include "SideRequests.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace crossfield::test
{
namespace
{
/// Returns the same layer on all sides of a square.
std::vector<SideRequest> OnFourSides(double first, double growth = 1.2, int rows = 0)
{
  std::vector<SideRequest> layers;
  for (const char* name : { "outer0", "outer1", "outer2", "outer3" })
  {
    layers.push_back(LayerOf(name, first, growth, rows));
  }
  return layers;
}

PlanarDomain UnitSquare()
{
  return MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } } });
}

QuadRequest SquareRequest(const std::vector<SideRequest>& layers)
{
  QuadRequest request;
  request.quadSize = 0.05;
  request.singularities = Configuration();
  request.sideRequests = layers;
  return request;
}

/// Returns the sorted, distinct values of one coordinate of the points of a mesh.
std::vector<double> Coordinates(const QuadMesh& mesh, Eigen::Index axis)
{
  std::vector<double> values;
  for (const QuadPoint& point : mesh.points)
  {
    values.push_back(point.place[axis]);
  }
  std::sort(values.begin(), values.end());
  std::vector<double> distinct;
  for (const double value : values)
  {
    if (distinct.empty() || value > distinct.back() + 1e-9)
    {
      distinct.push_back(value);
    }
  }
  return distinct;
}

TEST(BoundaryLayers, OfASquareAreGeometricSeries)
{
  const double first = 1e-3;
  const QuadWorkflowResult result = MakeQuadMesh(UnitSquare(), SquareRequest(OnFourSides(first)));
  ASSERT_EQ(result.layers.size(), 4U);
  const LayerReport& report = result.layers[0];
  const double thickness = 0.05 * report.rowsReplaced;
  EXPECT_EQ(report.rows, RowsToFill(thickness, first, 1.2));
  EXPECT_NEAR(report.meanThickness, thickness, 1e-9);
  EXPECT_NEAR(report.minimumHeight, first, 1e-9);
  EXPECT_NEAR(report.maximumHeight, first, 1e-9);
  EXPECT_EQ(report.partInBounds, 1.0);
  EXPECT_LE(report.largestGrowth, 1.2);
  EXPECT_LE(report.largestRatio, 1.25);
  EXPECT_NEAR(result.quads.quality.jacobian.min, 1.0, 1e-9);
  // The points are a tensor product of the same series on all four sides.
  const std::vector<double> ends = RowEnds(thickness, first, report.rows);
  for (const Eigen::Index axis : { 0, 1 })
  {
    const std::vector<double> values = Coordinates(result.quads.mesh, axis);
    const int between = 20 - 2 * report.rowsReplaced;
    ASSERT_EQ(static_cast<int>(values.size()), 2 * report.rows + between + 1);
    for (std::size_t row = 0; row < ends.size(); ++row)
    {
      EXPECT_NEAR(values[row + 1], ends[row], 1e-9) << row;
      EXPECT_NEAR(values[values.size() - 2 - row], 1.0 - ends[row], 1e-9) << row;
    }
  }
  // One block in the middle, one for each band, and one for each crossing.
  EXPECT_EQ(result.quads.blocks.blocks.size(), 9U);
  ExpectSoundBlocks(result.quads);
}

TEST(BoundaryLayers, OfEqualRowsAndOfQuads)
{
  // Quads have sides of 0.05; with a growth of 1, one row of them becomes five of 0.01 each.
  const QuadWorkflowResult equal =
    MakeQuadMesh(UnitSquare(), SquareRequest({ LayerOf("outer0", 0.01, 1.0) }));
  const std::vector<double> y = Coordinates(equal.quads.mesh, 1);
  ASSERT_EQ(y.size(), 21U + 4U);
  for (std::size_t i = 0; i < y.size(); ++i)
  {
    const auto row = static_cast<double>(i);
    EXPECT_NEAR(y[i], i < 5 ? 0.01 * row : 0.05 * (row - 4.0), 1e-12);
  }
  // Without a first height nothing is divided.
  SideRequest ofQuads = LayerOf("outer0", 0.0, 1.2, 7);
  ofQuads.layer->first.reset();
  const QuadWorkflowResult result = MakeQuadMesh(UnitSquare(), SquareRequest({ ofQuads }));
  EXPECT_EQ(result.quads.mesh.quads.size(), 400U);
  EXPECT_EQ(result.layers[0].rows, 7);
  EXPECT_EQ(result.layers[0].partInBounds, 1.0);
  EXPECT_NEAR(result.layers[0].meanThickness, 0.35, 1e-12);
  ofQuads.layer->rows = 21;
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(UnitSquare(), SquareRequest({ ofQuads })); },
    { "Only 20 rows beside 'outer0' are free", "21 are needed", "use smaller quads" }));
}

TEST(BoundaryLayers, RowsBehindACornerThatRowsLeaveGrowAsWell)
{
  const PlanarDomain step =
    MakePlanarDomain({ { { 0, 0 }, { 8, 0 }, { 8, 2 }, { -4, 2 }, { -4, 1 }, { 0, 1 } } });
  QuadRequest request;
  request.quadCount = 16000;
  request.cornerRows.emplace_back();
  request.cornerRows.back().position = Point(0.0, 1.0);
  request.cornerRows.back().rows = CornerRows::Leave;
  for (const char* name : { "outer0", "outer2", "outer4", "outer5" })
  {
    request.sideRequests.push_back(LayerOf(name, 1e-3));
  }
  const QuadWorkflowResult result = MakeQuadMesh(step, request);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  for (const LayerReport& report : result.layers)
  {
    EXPECT_LE(report.largestRatio, 3.0) << report.name; // 143 without rows there
    EXPECT_EQ(report.partInBounds, 1.0) << report.name;
  }
  ExpectSoundBlocks(result.quads);
}

TEST(BoundaryLayers, OfARingAreCircles)
{
  const PlanarDomain ring = MakePlanarDomain({ RegularPolygon(256), RegularPolygon(256, 0.4) });
  QuadRequest request;
  request.quadSize = 0.05;
  request.sideRequests = { LayerOf("hole0", 1e-4), LayerOf("outer0", 1e-3, 1.3) };
  for (const Sizing sizing : { Sizing::Conformal, Sizing::Uniform })
  {
    request.sizing = sizing;
    const QuadWorkflowResult result = MakeQuadMesh(ring, request);
    ASSERT_EQ(result.layers.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i)
    {
      EXPECT_EQ(result.layers[i].name, request.sideRequests[i].side);
      EXPECT_EQ(result.layers[i].partInBounds, 1.0);
      EXPECT_LE(result.layers[i].largestGrowth, request.sideRequests[i].layer->growth);
    }
    // Three annuli, cut along the same line.
    EXPECT_EQ(result.quads.blocks.blocks.size(), 3U);
    ExpectSoundBlocks(result.quads);
    EXPECT_GE(result.quads.quality.jacobian.min, 0.99);
  }
}

TEST(BoundaryLayers, PrescribedNumberOfRows)
{
  for (const int rows : { 20, 23, 30, 60 })
  {
    const QuadWorkflowResult result =
      MakeQuadMesh(UnitSquare(), SquareRequest(OnFourSides(1e-3, 1.25, rows)));
    const LayerReport& report = result.layers[0];
    EXPECT_EQ(report.rows, rows);
    EXPECT_NEAR(report.minimumHeight, 1e-3, 1e-9);
    EXPECT_NEAR(report.maximumHeight, 1e-3, 1e-9);
    EXPECT_LE(report.largestGrowth, 1.25 + 1e-9);
    EXPECT_GE(report.rowsReplaced, 1);
  }
}

TEST(BoundaryLayers, NothingMovesOutsideTheBand)
{
  const PlanarDomain domain = MakePlanarDomain({ RegularPolygon(128) });
  QuadRequest request;
  request.quadSize = 0.06;
  request.singularities = OnCircle(4, 0.45, 0.3, 1, 0.0);
  const QuadWorkflowResult plain = MakeQuadMesh(domain, request);
  request.sideRequests = { LayerOf("outer0", 1e-3) };
  const QuadWorkflowResult layered = MakeQuadMesh(domain, request);
  const LayerReport& report = layered.layers[0];
  const int columns = static_cast<int>(plain.quads.mesh.boundary.size());
  EXPECT_EQ(layered.quads.mesh.boundary.size(), plain.quads.mesh.boundary.size());
  EXPECT_EQ(layered.quads.mesh.quads.size(),
    plain.quads.mesh.quads.size() +
      static_cast<std::size_t>(columns * (report.rows - report.rowsReplaced)));
  // All points of the plain mesh are there, except those of the inner lines of the band.
  int same = 0;
  for (const QuadPoint& point : plain.quads.mesh.points)
  {
    same += std::any_of(layered.quads.mesh.points.begin(), layered.quads.mesh.points.end(),
              [&](const QuadPoint& other) {
                return (other.place - point.place).norm() < 1e-12 && other.valence == point.valence;
              })
      ? 1
      : 0;
  }
  EXPECT_EQ(
    same, static_cast<int>(plain.quads.mesh.points.size()) - columns * (report.rowsReplaced - 1));
  ExpectSoundBlocks(layered.quads);
}

TEST(BoundaryLayers, NumberOfQuadsIncludesTheRows)
{
  const PlanarDomain ring = MakePlanarDomain({ RegularPolygon(256), RegularPolygon(256, 0.4) });
  QuadRequest request;
  request.quadCount = 5000;
  request.sideRequests = { LayerOf("hole0", 1e-4) };
  const QuadWorkflowResult result = MakeQuadMesh(ring, request);
  EXPECT_NEAR(static_cast<double>(result.quads.mesh.quads.size()), 5000.0, 250.0);
  EXPECT_TRUE(result.warnings.empty());
}

TEST(BoundaryLayers, ChosenSingularitiesLeaveRoom)
{
  Loop hole = RegularPolygon(64, 0.2, Point(0.1, 0.0));
  const PlanarDomain domain =
    MakePlanarDomain({ { { -1.0, -1.0 }, { 1.0, -1.0 }, { 1.0, 1.0 }, { -1.0, 1.0 } }, hole });
  QuadRequest request;
  request.quadSize = 0.06;
  // As chosen without a layer, they leave too few rows, and the message says so.
  request.singularities = MakeQuadMesh(domain, request).singularities;
  request.sideRequests = { LayerOf("hole0", 1e-3) };
  std::string message;
  try
  {
    MakeQuadMesh(domain, request);
  }
  catch (const Error& error)
  {
    EXPECT_EQ(error.GetKind(), Error::Kind::LackOfRows);
    message = error.what();
  }
  for (const char* part :
    { "beside 'hole0'", "free of irregular nodes", "are needed", "move the singularities" })
  {
    EXPECT_NE(message.find(part), std::string::npos) << message;
  }
  // Both remedies work.
  const std::string before = "move the singularities ";
  const double away = std::stod(message.substr(message.find(before) + before.size()));
  QuadRequest moved = request;
  for (Singularity& singularity : *moved.singularities)
  {
    singularity.position += away * (singularity.position - Point(0.1, 0.0)).normalized();
  }
  EXPECT_NO_THROW(MakeQuadMesh(domain, moved)) << away;
  EXPECT_NE(message.find(", or leave them out"), std::string::npos) << message;
  request.singularities.reset();
  const QuadWorkflowResult result = MakeQuadMesh(domain, request);
  EXPECT_GE(result.layers[0].partInBounds, 0.95);
  EXPECT_LE(result.layers[0].largestRatio, 2.5);
  EXPECT_EQ(result.quads.quality.inverted, 0);
}

TEST(BoundaryLayers, NoMoveIsOfferedBeyondTheDomain)
{
  const PlanarDomain domain = MakePlanarDomain({ RegularPolygon(64, 1.0) });
  QuadRequest request;
  request.quadCount = 300;
  request.singularities = Configuration{ { { 0.5, 0.5 }, 1 }, { { -0.5, 0.5 }, 1 },
    { { -0.5, -0.5 }, 1 }, { { 0.5, -0.5 }, 1 } };
  request.sideRequests = { LayerOf("outer0", 0.01) };
  std::string message;
  try
  {
    MakeQuadMesh(domain, request);
  }
  catch (const Error& error)
  {
    message = error.what();
  }
  EXPECT_EQ(message.find("move the singularities"), std::string::npos) << message;
  EXPECT_NE(message.find("; leave the singularities out"), std::string::npos) << message;
  request.singularities.reset();
  EXPECT_NO_THROW(MakeQuadMesh(domain, request));
}

/// Returns a profile of sharp trailing edge (NACA 0012), from the trailing edge over the upper
/// side.
Loop Profile(int pieces)
{
  Loop loop;
  const auto thickness = [](double x)
  {
    return 0.6 *
      (0.2969 * std::sqrt(x) - 0.126 * x - 0.3516 * x * x + 0.2843 * x * x * x -
        0.1036 * x * x * x * x);
  };
  for (int i = 0; i < 2 * pieces; ++i)
  {
    const double x = 0.5 * (1.0 + std::cos(Pi * i / pieces));
    loop.emplace_back(x, i == 0 ? 0.0 : i <= pieces ? thickness(x) : -thickness(x));
  }
  return loop;
}

/// Returns a far field with a round front and a straight outlet.
Loop FarField(double radius)
{
  Loop loop;
  for (int i = 0; i <= 90; ++i)
  {
    const double angle = 0.5 * Pi + Pi * i / 90.0;
    loop.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  for (int i = 1; i <= 30; ++i)
  {
    loop.emplace_back(radius * i / 30.0, -radius);
  }
  for (int i = 30; i > 0; --i)
  {
    loop.emplace_back(radius * i / 30.0, radius);
  }
  return loop;
}

TEST(BoundaryLayers, OfAProfileGiveACGrid)
{
  const PlanarDomain domain = MakePlanarDomain({ FarField(10.0), Profile(80) });
  QuadRequest request;
  request.quadCount = 10000;
  request.sizing = Sizing::Conformal;
  request.sideRequests = { LayerOf("hole0", 1e-4) };
  const QuadWorkflowResult result = MakeQuadMesh(domain, request);
  EXPECT_TRUE(result.singularities.empty());
  const auto edge = std::find_if(result.corners.begin(), result.corners.end(),
    [](const CornerChoice& corner) { return corner.position == Point(1.0, 0.0); });
  ASSERT_NE(edge, result.corners.end());
  EXPECT_EQ(edge->quarterIndex, -2);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GE(result.quads.quality.jacobian.min, 0.90);
  const LayerReport& report = result.layers[0];
  EXPECT_EQ(report.partInBounds, 1.0);
  EXPECT_LE(report.largestGrowth, 1.2);
  EXPECT_LE(report.largestRatio, 2.0);
  ExpectSoundBlocks(result.quads);
  // The wake: along the line behind the trailing edge, the first row becomes higher with the
  // distance from it, relative to the chord of length 1.
  const QuadMesh& mesh = result.quads.mesh;
  int compared = 0;
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const Point from = mesh.points[static_cast<std::size_t>(quad[c])].InPlane();
      const Point upwards =
        mesh.points[static_cast<std::size_t>(quad[(c + 1) % 4])].InPlane() - from;
      if (from.x() > 1.0 && std::abs(from.y()) < 1e-6 && upwards.y() > std::abs(upwards.x()))
      {
        const double t = from.x() - 1.0;
        const double prescribed = 1e-4 * (1.0 + 5.0 * t * t / (t + 0.5));
        EXPECT_NEAR(upwards.norm(), prescribed, 0.05 * prescribed) << from.x();
        ++compared;
      }
    }
  }
  EXPECT_GE(compared, 10);
}

TEST(BoundaryLayers, EdgesOfAProfileAndItsWakeChangeGradually)
{
  const PlanarDomain domain = MakePlanarDomain({ FarField(10.0), Profile(80) });
  for (const int edges : { 100, 180 })
  {
    QuadRequest request;
    request.quadCount = 100 * edges;
    request.sizing = Sizing::Conformal;
    request.sideRequests = { LayerOf("hole0", 1e-3) };
    request.sideRequests[0].count = edges;
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    EXPECT_GE(result.quads.quality.jacobian.min, 0.90) << edges;
    EXPECT_LE(result.layers[0].largestRatio, 2.3) << edges; // 3.5 and 4.7 without graded strips
  }
}

TEST(BoundaryLayers, ImpossiblePrescriptionsAreRefused)
{
  const PlanarDomain square = UnitSquare();
  const auto refuses =
    [&](const std::vector<SideRequest>& layers, const std::vector<std::string>& parts)
  { return Refuses([&] { MakeQuadMesh(square, SquareRequest(layers)); }, parts); };
  EXPECT_TRUE(refuses(
    { LayerOf("wall", 1e-3) }, { "no side 'wall'", "'outer0', 'outer1', 'outer2' or 'outer3'" }));
  EXPECT_TRUE(refuses({ LayerOf("outer0", 0.0) }, { "first height of 0", "positive" }));
  EXPECT_TRUE(refuses({ LayerOf("outer0", -1.0) }, { "first height of -1" }));
  EXPECT_TRUE(refuses({ LayerOf("outer0", 1e-3, 0.9) }, { "growth of 0.9", "from 1 to 3" }));
  EXPECT_TRUE(refuses({ LayerOf("outer0", 1e-3, 5.0) }, { "growth of 5", "from 1 to 3" }));
  EXPECT_TRUE(refuses({ LayerOf("outer0", 1e-3, 1.2, -2) }, { "-2 rows" }));
  EXPECT_TRUE(
    refuses({ LayerOf("outer0", 1e-3), LayerOf("outer0", 1e-4) }, { "'outer0' has two layers" }));
  EXPECT_TRUE(
    refuses({ LayerOf("outer0", 0.2) }, { "first height 0.2", "is not below the height 0.05" }));
  EXPECT_TRUE(
    refuses({ LayerOf("outer0", 1e-3, 1.2, 3) }, { "needs 14 rows", "but 3 are prescribed" }));
  EXPECT_TRUE(
    refuses({ LayerOf("outer0", 1e-2, 1.2, 1000) }, { "at least 10 thick", "fewer rows" }));
  // Too few quads between two sides.
  QuadRequest narrow = SquareRequest(OnFourSides(1e-3, 1.05));
  narrow.quadSize = 0.25;
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(square, narrow); }, { "use smaller quads" }));
  narrow.quadSize = 1.0;
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(square, narrow); }, { "use smaller quads" }));
}

TEST(BoundaryLayers, PrescribedNumbersOfEdgesHold)
{
  const PlanarDomain square = UnitSquare();
  const auto withCount =
    [&](const std::vector<SideRequest>& layers, const std::string& side, int count)
  {
    QuadRequest request = SquareRequest(layers);
    request.sides = NameSides(square);
    request.sideRequests.push_back(CountOf(side, count));
    return request;
  };
  // The layer ends on the sides beside it and adds edges to them, but not to its own side.
  const std::vector<SideRequest> one = { LayerOf("outer0", 1e-3) };
  for (const std::vector<SideRequest>& layers : { one, OnFourSides(1e-3) })
  {
    for (const auto& [name, count] : std::map<std::string, int>{
           { "outer0", 58 }, { "outer1", 59 }, { "outer2", 60 }, { "outer3", 90 } })
    {
      const QuadRequest request = withCount(layers, name, count);
      const QuadWorkflowResult result = MakeQuadMesh(square, request);
      EXPECT_EQ(MeasureSides(result.quads.mesh)[Index(request.sides.Find(name))].edges, count);
      EXPECT_NEAR(result.layers[0].minimumHeight, 1e-3, 1e-9);
    }
  }
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(square, withCount(one, "outer1", 18)); },
    { "With the layer of 'outer0', side 'outer1' has ", " edges, but 18 are prescribed",
      "leave out this number or the layer." }));
  EXPECT_TRUE(Refuses([&] { MakeQuadMesh(square, withCount(OnFourSides(1e-3), "outer1", 18)); },
    { "With the layers, side 'outer1' has ", "the layer that ends on the side." }));
}
}
}
