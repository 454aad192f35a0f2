// Hexahedra from quads: volumes, sides, blocks, prisms on the axis, and refusals.

#include "CellLattice.h"
#include "ElementNodes.h"
#include "Error.h"
#include "MeshBlocks.h"
#include "MeshFaces.h"
#include "Plane.h"
#include "PrismLattice.h"
#include "SidePairs.h"
#include "SweepQuads.h"
#include "formats/FormatChecks.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <set>

namespace crossfield::test
{
namespace
{
/// A rectangle of counter-clockwise quads of order 1 with its one block: x from 0, y from `low`.
SolverMesh Rectangle(int columns, int rows, double low)
{
  SolverMesh mesh;
  mesh.regionNames = { "domain" };
  mesh.sideNames = { "bottom", "right", "top", "left" };
  const auto at = [columns](int i, int j) { return i + j * (columns + 1); };
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      mesh.points.emplace_back(0.5 * i, low + 0.25 * j, 0.5);
    }
  }
  std::vector<BlockPlace> places;
  for (int j = 0; j < rows; ++j)
  {
    for (int i = 0; i < columns; ++i)
    {
      mesh.cells.insert(
        mesh.cells.end(), { at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1) });
      mesh.region.push_back(0);
      places.push_back({ 0, { i, j, 0 } });
    }
  }
  const auto add = [&](int side, int a, int b)
  {
    mesh.faces.insert(mesh.faces.end(), { a, b });
    mesh.side.push_back(side);
  };
  for (int i = 0; i < columns; ++i)
  {
    add(0, at(i, 0), at(i + 1, 0));
    add(2, at(i + 1, rows), at(i, rows));
  }
  for (int j = 0; j < rows; ++j)
  {
    add(1, at(columns, j), at(columns, j + 1));
    add(3, at(0, j + 1), at(0, j));
  }
  mesh.blocks = GatherBlocks(mesh, places);
  return mesh;
}

/// The volume inside the outward faces of the boundary, by the divergence theorem; faces are split at their middles.
double VolumeInside(const SolverMesh& mesh)
{
  const MeshFaces faces(mesh);
  const CellLattice lattice(3, mesh.order);
  double volume = 0.0;
  for (const std::vector<CellFace>& side : faces.OfSides())
  {
    for (const CellFace& face : side)
    {
      std::vector<Eigen::Vector3d> corners;
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const int position : lattice.FaceCorners(face.face))
      {
        corners.push_back(mesh.points[Index(mesh.Cell(face.cell)[position])]);
        middle += corners.back() / 4.0;
      }
      for (std::size_t i = 0; i < 4; ++i)
      {
        volume += corners[i].cross(corners[(i + 1) % 4]).dot(middle) / 6.0;
      }
    }
  }
  return volume;
}

void ExpectError(const SolverMesh& quads, const Sweep& sweep, const std::string& words)
{
  try
  {
    SweepQuads(quads, sweep);
    ADD_FAILURE() << "no error: " << words;
  }
  catch (const Error& error)
  {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

Sweep Rotation(double angle, int layers, int axis = 0)
{
  Sweep sweep;
  sweep.kind = Sweep::Rotation;
  sweep.angle = angle;
  sweep.layers = layers;
  sweep.axisDirection = axis == 0 ? Point(1.0, 0.0) : Point(0.0, 1.0);
  return sweep;
}
}

TEST(SweepQuads, ExtrusionHasVolumeSidesAndBlocks)
{
  const SolverMesh quads = Rectangle(4, 3, 1.0);
  Sweep sweep;
  sweep.layers = 5;
  sweep.height = 0.7;
  const SolverMesh swept = SweepQuads(quads, sweep);
  EXPECT_EQ(swept.CellCount(), 60);
  EXPECT_EQ(swept.points.size(), 20U * 6U);
  EXPECT_EQ(swept.FaceCount(), 14 * 5 + 2 * 12);
  EXPECT_NEAR(VolumeInside(swept), 2.0 * 0.75 * 0.7, 1e-14);
  EXPECT_EQ(swept.sideNames.back(), "front");
  EXPECT_EQ(swept.sweep.back, 4);
  ASSERT_EQ(swept.blocks.size(), 1U);
  const MeshBlock& block = swept.blocks[0];
  EXPECT_EQ(block.cells, (std::array<int, 3>{ 4, 3, 5 }));
  const auto at = [&](int i, int j, int k) -> const Eigen::Vector3d&
  { return swept.points[Index(block.nodes[Index(i + 5 * (j + 4 * k))])]; };
  EXPECT_EQ(at(2, 1, 5), Eigen::Vector3d(1.0, 1.25, 0.5 + 0.7));
  SolverMesh oriented = swept;
  OrientCells(oriented);
  EXPECT_EQ(oriented.cells, swept.cells) << "right-handed from the beginning";
}

TEST(SweepQuads, ExtrusionOfRandomDirectionsAndOrderTwo)
{
  for (const int order : { 1, 2 })
  {
    LatticeMesh lattice(2, order, 5, 4, 71);
    OrientCells(lattice.Mesh);
    Sweep sweep;
    sweep.layers = 3;
    sweep.height = 0.3;
    const SolverMesh swept = SweepQuads(lattice.Mesh, sweep);
    EXPECT_EQ(swept.order, order);
    const double extent = order == 1 ? 1.0 : 4.0; // lattice of order times as many points
    EXPECT_NEAR(VolumeInside(swept), extent * 5.0 / 3.0 * 4.0 / 7.0 * 0.3, 1e-14);
    std::set<int> used(swept.cells.begin(), swept.cells.end());
    EXPECT_EQ(used.size(), swept.points.size());
    for (std::size_t i = 0; i < swept.points.size(); ++i)
    {
      const Eigen::Vector3d& base = lattice.Mesh.points[Index(swept.sources.points[i])];
      EXPECT_EQ(swept.points[i].head<2>(), base.head<2>());
    }
  }
}

TEST(SweepQuads, ExtrusionInATiltedPlaneGoesAlongItsNormal)
{
  SolverMesh quads = Rectangle(2, 2, 0.0);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, -0.5).normalized()).toRotationMatrix();
  for (Eigen::Vector3d& point : quads.points)
  {
    point = turn * point;
  }
  Sweep sweep;
  sweep.height = 2.0;
  const SolverMesh swept = SweepQuads(quads, sweep);
  EXPECT_NEAR((swept.points[9] - quads.points[0] - 2.0 * turn.col(2)).norm(), 0.0, 1e-14);
  EXPECT_NEAR(VolumeInside(swept), 0.5 * 2.0, 1e-14);
  quads.points[4] += 0.01 * turn.col(2);
  ExpectError(quads, sweep, "is not in the plane of the others");
}

TEST(SweepQuads, RevolutionsTendToPappus)
{
  // Volume of a polygonal ring: the rotation angle is replaced by layers · sin(angle / layers) at the first order.
  const SolverMesh quads = Rectangle(3, 4, 1.0); // area 1.5, middle at y = 1.5
  for (const double angle : { 30.0, 90.0, 200.0, 360.0 })
  {
    double before = 0.0;
    for (const int layers : { 8, 16, 32 })
    {
      const SolverMesh swept = SweepQuads(quads, Rotation(angle, layers));
      const double error = std::abs(VolumeInside(swept) - 1.5 * 1.5 * angle * Pi / 180.0);
      EXPECT_EQ(swept.CellCount(), 12 * layers);
      if (before > 0.0)
      {
        EXPECT_NEAR(before / error, 4.0, 0.2) << angle << " degrees, " << layers << " layers";
      }
      before = error;
      SolverMesh oriented = swept;
      OrientCells(oriented);
      EXPECT_EQ(oriented.cells, swept.cells);
    }
  }
}

TEST(SweepQuads, AFullTurnIsClosed)
{
  const SolverMesh swept = SweepQuads(Rectangle(3, 2, 1.0), Rotation(360.0, 6));
  EXPECT_EQ(swept.points.size(), 12U * 6U);
  EXPECT_EQ(swept.sideNames.size(), 4U);
  EXPECT_EQ(swept.sweep.back, -1);
  EXPECT_EQ(swept.FaceCount(), 10 * 6);
  EXPECT_NO_THROW(MeshFaces{ swept });
}

TEST(SweepQuads, OneLayerIsAWedgeAroundTheQuads)
{
  const SolverMesh swept = SweepQuads(Rectangle(1, 1, 2.0), Rotation(10.0, 1));
  for (std::size_t i = 0; i < swept.points.size(); ++i)
  {
    const Eigen::Vector3d& point = swept.points[i];
    const double height = point.z() - 0.5;
    EXPECT_NEAR(std::atan2(height, point.y()) * 180.0 / Pi, i < 4 ? -5.0 : 5.0, 1e-12);
  }
}

TEST(SweepQuads, EdgesOnTheAxisGivePrisms)
{
  for (const double sign : { 1.0, -1.0 })
  {
    SolverMesh quads = Rectangle(4, 3, 0.0);
    for (Eigen::Vector3d& point : quads.points)
    {
      point.y() *= sign;
    }
    OrientCells(quads);
    const SolverMesh swept = SweepQuads(quads, Rotation(90.0, 32));
    int prisms = 0;
    for (int cell = 0; cell < swept.CellCount(); ++cell)
    {
      prisms += swept.CollapsedEdge(cell) >= 0 ? 1 : 0;
    }
    EXPECT_EQ(prisms, 4 * 32);
    EXPECT_EQ(swept.points.size(), 5U + 15U * 33U);
    EXPECT_EQ(
      swept.sideNames, (std::vector<std::string>{ "right", "top", "left", "back", "front" }))
      << "the side on the axis has no faces";
    EXPECT_NEAR(VolumeInside(swept) / (0.75 * 0.75 * 2.0 * Pi / 4.0), 1.0, 1e-3);
    for (const char* name : { "a.msh", "a.inp", "a.su2" })
    {
      EXPECT_GT(Written(swept, name).size(), 1000U);
    }
    const std::string inp = Written(swept, "a.inp");
    EXPECT_NE(inp.find("*ELEMENT, TYPE=C3D6, ELSET=domain\n"), std::string::npos);
  }
}

namespace
{
/// Place of a node of the lattice of a prism whose collapsed edge begins at a corner: linear
/// between its corners.
Eigen::Vector3d PlaceInPrism(int position, int collapsed)
{
  const std::array<double, 2> at = { 0.5 * (position % 3) - 0.5, 0.5 * (position / 3 % 3) - 0.5 };
  const double turn = -0.5 * Pi * collapsed;
  const double along = std::cos(turn) * at[0] - std::sin(turn) * at[1] + 0.5;
  const double away = std::sin(turn) * at[0] + std::cos(turn) * at[1] + 0.5;
  const double level = 0.5 * (position / 9);
  return { along, away * (1.0 - level), away * level };
}
}

TEST(SweepQuads, NodesOfPrismsOfOrderTwoAreWhereTheirFormatsHaveThem)
{
  // Corners between which the nodes after the six corners are, from the documentation of each.
  using Pairs = std::vector<std::array<int, 2>>;
  const Pairs abaqus = { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 },
    { 1, 4 }, { 2, 5 } };
  Pairs vtk = abaqus;
  vtk.insert(vtk.end(), { { 0, 4 }, { 1, 5 }, { 2, 3 } }); // of faces 0143, 1254 and 2035
  const Pairs gmsh = { { 0, 1 }, { 0, 2 }, { 0, 3 }, { 1, 2 }, { 1, 4 }, { 2, 5 }, { 3, 4 },
    { 3, 5 }, { 4, 5 }, { 0, 4 }, { 0, 5 }, { 1, 5 } };
  for (int collapsed = 0; collapsed < 4; ++collapsed)
  {
    for (const auto& [format, pairs] : { std::pair(NodeOrder::Vtk, vtk),
           std::pair(NodeOrder::Abaqus, abaqus), std::pair(NodeOrder::Gmsh, gmsh) })
    {
      std::vector<Eigen::Vector3d> nodes;
      for (const int position : PrismPositions(2, collapsed, format))
      {
        nodes.push_back(PlaceInPrism(position, collapsed));
      }
      ASSERT_EQ(nodes.size(), 6 + pairs.size());
      for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        const Eigen::Vector3d middle =
          0.5 * (nodes[Index(pairs[i][0])] + nodes[Index(pairs[i][1])]);
        EXPECT_LT((nodes[6 + i] - middle).norm(), 1e-12) << collapsed << " " << i;
      }
      // The first triangle is opposite to the second, and its normal points to it, but for VTK.
      const double volume =
        (nodes[1] - nodes[0]).cross(nodes[2] - nodes[0]).dot(nodes[3] - nodes[0]);
      EXPECT_NEAR(volume, format == NodeOrder::Vtk ? -1.0 : 1.0, 1e-12);
    }
  }
}

TEST(SweepQuads, PrismsOfOrderTwoAreHexahedraOfFewerPoints)
{
  // A quad of order 2 on the axis and one above it.
  SolverMesh quads = LatticeMesh(2, 2, 1, 2, 3).Mesh;
  OrientCells(quads);
  const SolverMesh mesh = SweepQuads(quads, Rotation(60.0, 2));
  const ElementNodes nodes(mesh, NodeOrder::Vtk);
  std::vector<std::size_t> sizes;
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const std::vector<int> ofCell = nodes.OfCell(cell);
    sizes.push_back(ofCell.size());
    EXPECT_EQ(std::set<int>(ofCell.begin(), ofCell.end()).size(), ofCell.size());
  }
  std::sort(sizes.begin(), sizes.end());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{ 18, 18, 27, 27 }));
  std::set<std::size_t> faces;
  const MeshFaces boundary(mesh);
  for (const CellFace& face : boundary.BoundaryFaces())
  {
    faces.insert(nodes.OfFace(face).size());
  }
  EXPECT_EQ(faces, (std::set<std::size_t>{ 6, 9 }));
  for (const char* name : { "a.msh", "a.inp" })
  {
    EXPECT_GT(Written(mesh, name).size(), 1000U);
  }
  EXPECT_TRUE(
    Refuses([&] { Written(mesh, "a.ex2"); }, { ".ex2 has no prisms of order 2", "order 1" }));
}

TEST(SweepQuads, AnotherAxis)
{
  SolverMesh quads = Rectangle(2, 2, -0.5);
  const SolverMesh swept = SweepQuads(quads, Rotation(180.0, 24, 1));
  EXPECT_NEAR(VolumeInside(swept), 0.5 * Pi / 2.0, 0.01);
  EXPECT_NO_THROW(SweepQuads(quads, Rotation(90.0, 4, 0))) << "below the axis";
}

/// Turning the quads and the axis together turns the mesh, and Pappus gives its volume.
TEST(SweepQuads, AnyAxisInThePlane)
{
  const SolverMesh quads = Rectangle(2, 2, 1.0);
  const SolverMesh swept = SweepQuads(quads, Rotation(90.0, 24));
  const Eigen::Rotation2Dd turn(0.7);
  const Point shift(3.0, -2.0);
  SolverMesh other = quads;
  for (Eigen::Vector3d& point : other.points)
  {
    point.head<2>() = turn * point.head<2>() + shift;
  }
  Sweep sweep = Rotation(90.0, 24);
  sweep.axisPoint = shift + turn * Point(5.0, 0.0);
  sweep.axisDirection = turn * Point(-2.0, 0.0);
  const SolverMesh turned = SweepQuads(other, sweep);
  ASSERT_EQ(turned.points.size(), swept.points.size());
  for (std::size_t i = 0; i < swept.points.size(); ++i)
  {
    const Point expected = turn * swept.points[i].head<2>() + shift;
    EXPECT_LT((turned.points[i].head<2>() - expected).norm(), 1e-12);
    EXPECT_NEAR(turned.points[i].z(), swept.points[i].z(), 1e-12);
  }
  EXPECT_NEAR(VolumeInside(turned) / (0.5 * Pi * 1.25 * 0.5), 1.0, 1e-3);
  sweep.axisDirection = Point::Zero();
  ExpectError(other, sweep, "two different points");
}

TEST(SweepQuads, LayersGrowByARatio)
{
  SolverMesh quads = LatticeMesh(2, 2, 2, 2, 1).Mesh;
  OrientCells(quads);
  Sweep sweep;
  sweep.layers = 3;
  sweep.height = 7.0;
  sweep.ratio = 4.0; // heights 1, 2 and 4
  std::set<double> heights;
  for (const Eigen::Vector3d& point : SweepQuads(quads, sweep).points)
  {
    heights.insert(std::round(1e9 * (point.z() - quads.points[0].z())) / 1e9);
  }
  EXPECT_EQ(heights, (std::set<double>{ 0.0, 0.5, 1.0, 2.0, 3.0, 5.0, 7.0 }));
  sweep.ratio = 0.0;
  ExpectError(quads, sweep, "ratio of the last to the first layer must be positive");
}

TEST(SweepQuads, PeriodicSidesStayPeriodicAlongTheAxis)
{
  SolverMesh quads = Rectangle(4, 3, 1.0);
  SidePair pair;
  pair.first = 3;
  pair.second = 1;
  pair.motion(0, 3) = 2.0;
  quads.pairs = { pair };
  Sweep extrusion;
  extrusion.layers = 2;
  for (const Sweep& sweep : { extrusion, Rotation(45.0, 3) })
  {
    const SolverMesh swept = SweepQuads(quads, sweep);
    ASSERT_EQ(swept.pairs.size(), 1U);
    EXPECT_EQ(MatchPair(swept, MeshFaces(swept), swept.pairs[0]).nodes.size(),
      4U * Index(sweep.layers + 1));
  }
  for (Eigen::Vector3d& point : quads.points)
  {
    point.x() += 1.0;
  }
  EXPECT_TRUE(SweepQuads(quads, Rotation(45.0, 3, 1)).pairs.empty());
}

TEST(SweepQuads, EndsWithANameThatASideHas)
{
  SolverMesh quads = Rectangle(1, 1, 1.0);
  quads.sideNames = { "front", "front_2", "back", "left" };
  EXPECT_EQ(SweepQuads(quads, {}).sideNames,
    (std::vector<std::string>{ "front", "front_2", "back", "left", "back_2", "front_3" }));
}

TEST(SweepQuads, Refusals)
{
  const SolverMesh quads = Rectangle(2, 2, 1.0);
  Sweep sweep;
  sweep.height = 0.0;
  ExpectError(quads, sweep, "height of an extrusion must be positive");
  sweep.height = std::nan("");
  ExpectError(quads, sweep, "height of an extrusion must be positive");
  sweep.layers = 0;
  ExpectError(quads, sweep, "give at least 1");
  ExpectError(quads, Rotation(0.0, 1), "more than 0 and at most 360");
  ExpectError(quads, Rotation(361.0, 1), "more than 0 and at most 360");
  ExpectError({}, Sweep(), "no quads");
  ExpectError(LatticeMesh(2, 3, 2, 2, 1).Mesh, Sweep(), "order 3");
  ExpectError(Rectangle(2, 4, -0.5), Rotation(90.0, 2), "both sides of the axis");
  SolverMesh corner = Rectangle(1, 1, 0.0);
  corner.points[1].y() = 0.1;
  ExpectError(corner, Rotation(90.0, 2), "other than one edge");
  SolverMesh tilted = quads;
  tilted.points[0].z() += 1.0;
  ExpectError(tilted, Rotation(90.0, 2), "z = const");
}
}
