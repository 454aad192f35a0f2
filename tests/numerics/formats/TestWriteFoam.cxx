// Cases of OpenFOAM: order of faces, closed cells, patches, prisms, periodic sides, zones, names.

#include "WriteFoam.h"

#include "FoamMesh.h"
#include "FormatChecks.h"
#include "MeshBlocks.h"
#include "Plane.h"
#include "SweepQuads.h"

#include <Eigen/Geometry>

#include <cmath>
#include <functional>
#include <set>

namespace crossfield::test
{
namespace
{

FoamMesh FacesOf(const SolverMesh& mesh)
{
  return MakeFoamMesh(mesh, MeshFaces(mesh));
}

/// Quads of a rectangle, columns × rows, from the points of a map of the unit square, as blocks of random sizes.
SolverMesh Rectangle(int columns, int rows,
  const std::function<Eigen::Vector3d(double, double)>& place, Random& random)
{
  SolverMesh mesh =
    LatticeMesh(2, 1, columns, rows, static_cast<std::uint32_t>(random.Integer(1, 1000))).Mesh;
  for (Eigen::Vector3d& point : mesh.points)
  {
    point = place(point.x() * 3.0 / columns, point.y() * 7.0 / rows);
  }
  mesh.regionNames = { "domain" };
  mesh.region.assign(mesh.region.size(), 0);
  OrientCells(mesh);
  return mesh;
}

Eigen::Vector3d UnitSquare(double u, double v)
{
  return { u, v, 0.0 };
}

/// Sums over a mesh of OpenFOAM: per cell the face vectors, which must vanish, and the volume.
struct CellSums
{
  CellSums(const SolverMesh& mesh, const FoamMesh& foam)
    : areas(mesh.region.size(), Eigen::Vector3d::Zero())
    , volumes(mesh.region.size(), 0.0)
    , faces(mesh.region.size(), 0)
  {
    for (std::size_t face = 0; face < foam.owner.size(); ++face)
    {
      std::vector<Eigen::Vector3d> corners;
      for (int i = foam.starts[face]; i < foam.starts[face + 1]; ++i)
      {
        corners.push_back(mesh.points[Index(foam.point[Index(foam.corners[Index(i)])])]);
      }
      EXPECT_GE(corners.size(), 3U);
      Eigen::Vector3d area = Eigen::Vector3d::Zero();
      double volume = 0.0; // by the divergence theorem, of the cone over the face
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      {
        const Eigen::Vector3d half =
          0.5 * (corners[i] - corners[0]).cross(corners[i + 1] - corners[0]);
        area += half;
        volume += half.dot(corners[0] + corners[i] + corners[i + 1]) / 9.0;
      }
      EXPECT_GT(area.norm(), 0.0);
      this->Add(foam.owner[face], area, volume);
      if (face < foam.neighbour.size())
      {
        this->Add(foam.neighbour[face], -area, -volume);
      }
    }
  }

  void Add(int cell, const Eigen::Vector3d& area, double volume)
  {
    this->areas[Index(cell)] += area;
    this->volumes[Index(cell)] += volume;
    ++this->faces[Index(cell)];
  }

  std::vector<Eigen::Vector3d> areas;
  std::vector<double> volumes;
  std::vector<int> faces;
};

/// Expects what OpenFOAM demands of every mesh; returns the total volume.
double ExpectValid(const SolverMesh& mesh, const FoamMesh& foam)
{
  std::array<int, 2> before = { -1, -1 };
  for (std::size_t face = 0; face < foam.neighbour.size(); ++face)
  {
    const std::array<int, 2> cells = { foam.owner[face], foam.neighbour[face] };
    EXPECT_LT(cells[0], cells[1]);
    EXPECT_LE(before, cells);
    before = cells;
  }
  auto next = static_cast<int>(foam.neighbour.size());
  for (const FoamPatch& patch : foam.patches)
  {
    EXPECT_EQ(patch.start, next);
    EXPECT_GT(patch.count, 0);
    next += patch.count;
  }
  EXPECT_EQ(next, static_cast<int>(foam.owner.size()));
  EXPECT_EQ(foam.starts.size(), foam.owner.size() + 1);
  EXPECT_EQ(foam.starts.back(), static_cast<int>(foam.corners.size()));
  for (std::size_t face = 0; face < foam.owner.size(); ++face)
  {
    const auto first = foam.corners.begin() + foam.starts[face];
    const auto end = foam.corners.begin() + foam.starts[face + 1];
    EXPECT_EQ(std::set<int>(first, end).size(), static_cast<std::size_t>(end - first));
  }
  const CellSums sums(mesh, foam);
  double total = 0.0;
  for (std::size_t cell = 0; cell < sums.areas.size(); ++cell)
  {
    EXPECT_LT(sums.areas[cell].norm(), 1e-14) << "cell " << cell << " is not closed";
    EXPECT_GT(sums.volumes[cell], 0.0) << "the normals of cell " << cell << " point inwards";
    total += sums.volumes[cell];
  }
  return total;
}

const FoamPatch* Find(const FoamMesh& foam, const std::string& name)
{
  const auto found = std::find_if(foam.patches.begin(), foam.patches.end(),
    [&name](const FoamPatch& patch) { return patch.name == name; });
  return found == foam.patches.end() ? nullptr : &*found;
}
}

TEST(WriteFoam, CellsAreClosedAndFacesInOrder)
{
  Random random(41);
  for (int run = 0; run < 20; ++run)
  {
    const int columns = random.Integer(1, 6);
    const int rows = random.Integer(1, 6);
    Sweep sweep;
    sweep.layers = random.Integer(1, 4);
    sweep.height = 0.7;
    const SolverMesh mesh = SweepQuads(Rectangle(columns, rows, UnitSquare, random), sweep);
    const FoamMesh foam = FacesOf(mesh);
    EXPECT_NEAR(ExpectValid(mesh, foam), 0.7, 1e-12);
    const int quads = columns * rows;
    const int inPlane = (columns - 1) * rows + columns * (rows - 1);
    EXPECT_EQ(
      static_cast<int>(foam.neighbour.size()), inPlane * sweep.layers + quads * (sweep.layers - 1));
    ASSERT_NE(Find(foam, "right_side"), nullptr);
    EXPECT_EQ(Find(foam, "right_side")->count, rows * sweep.layers);
    EXPECT_EQ(Find(foam, "bottom")->count, columns * sweep.layers);
    const FoamPatch* both = Find(foam, "frontAndBack");
    EXPECT_EQ(both != nullptr, sweep.layers == 1);
    EXPECT_EQ(Find(foam, "front") != nullptr, sweep.layers > 1);
    if (both != nullptr)
    {
      EXPECT_EQ(both->type, "empty");
      EXPECT_EQ(both->count, 2 * quads);
    }
  }
}

TEST(WriteFoam, RevolutionsHaveWedgesAndPrisms)
{
  Random random(42);
  for (const bool touchesAxis : { false, true })
  {
    for (const int layers : { 1, 5 })
    {
      for (const double angle : { 4.0, 90.0, 360.0 })
      {
        if (layers == 1 && angle > 90.0)
        {
          continue;
        }
        const double inner = touchesAxis ? 0.0 : 1.0;
        Sweep sweep;
        sweep.kind = Sweep::Rotation;
        sweep.layers = layers;
        sweep.angle = angle;
        const auto place = [inner](double u, double v)
        { return Eigen::Vector3d(2.0 * u, inner + v, 0.0); };
        const SolverMesh mesh = SweepQuads(Rectangle(4, 3, place, random), sweep);
        const FoamMesh foam = FacesOf(mesh);
        // The area of the polygon that replaces the arc is that of its triangles.
        const double step = angle / 180.0 * Pi / layers;
        const double section = ((inner + 1.0) * (inner + 1.0) - inner * inner) / 2.0;
        EXPECT_NEAR(ExpectValid(mesh, foam), 2.0 * section * layers * std::sin(step), 1e-12);
        const CellSums sums(mesh, foam);
        EXPECT_EQ(
          std::count(sums.faces.begin(), sums.faces.end(), 5), touchesAxis ? 4 * layers : 0);
        EXPECT_EQ(Find(foam, "bottom") != nullptr, !touchesAxis);
        EXPECT_EQ(Find(foam, "back") != nullptr, angle < 360.0);
        if (angle < 360.0)
        {
          EXPECT_EQ(Find(foam, "back")->type, layers == 1 ? "wedge" : "patch");
        }
      }
    }
  }
}

TEST(WriteFoam, PeriodicSidesAreCyclicAndMatch)
{
  Random random(43);
  SolverMesh quads = Rectangle(5, 4, UnitSquare, random);
  SidePair pair;
  pair.first = 3;
  pair.second = 1;
  pair.motion(0, 3) = 1.0;
  quads.pairs = { pair };
  Sweep sweep;
  sweep.layers = 3;
  const SolverMesh mesh = SweepQuads(quads, sweep);
  const FoamMesh foam = FacesOf(mesh);
  ExpectValid(mesh, foam);
  const FoamPatch* left = Find(foam, "left_side");
  const FoamPatch* right = Find(foam, "right_side");
  ASSERT_TRUE(left != nullptr && right != nullptr);
  EXPECT_EQ(left->type, "cyclic");
  EXPECT_EQ(left->neighbour, "right_side");
  EXPECT_EQ(right->neighbour, "left_side");
  ASSERT_EQ(left->count, right->count);
  const auto corner = [&](int face, int i) -> const Eigen::Vector3d&
  {
    const int point = foam.corners[Index(foam.starts[Index(face)] + i)];
    return mesh.points[Index(foam.point[Index(point)])];
  };
  for (int i = 0; i < left->count; ++i)
  {
    for (int k = 0; k < 4; ++k) // the second face is seen from its other side
    {
      EXPECT_LT((corner(left->start + i, k) + Eigen::Vector3d::UnitX() -
                  corner(right->start + i, (4 - k) % 4))
                  .norm(),
        1e-12);
    }
  }
  EXPECT_NE(FoamTextOf(mesh, "constant/polyMesh/boundary").find("neighbourPatch right_side;"),
    std::string::npos);
}

TEST(WriteFoam, RegionsAndInnerSidesAreZones)
{
  SolverMesh quads = LatticeMesh(2, 1, 4, 3, 7).Mesh; // regions left and right
  quads.sideNames.emplace_back("between");
  std::map<std::pair<int, int>, std::set<int>> regions;
  for (int cell = 0; cell < quads.CellCount(); ++cell)
  {
    const int* n = quads.Cell(cell);
    for (const auto& [a, b] : { std::minmax(n[0], n[1]), std::minmax(n[1], n[3]),
           std::minmax(n[3], n[2]), std::minmax(n[2], n[0]) })
    {
      regions[{ a, b }].insert(quads.region[Index(cell)]);
    }
  }
  for (const auto& [edge, found] : regions)
  {
    if (found.size() == 2)
    {
      quads.faces.insert(quads.faces.end(), { edge.first, edge.second });
      quads.side.push_back(4);
    }
  }
  OrientCells(quads);
  Sweep sweep;
  sweep.layers = 2;
  const SolverMesh mesh = SweepQuads(quads, sweep);
  const FoamMesh foam = FacesOf(mesh);
  ExpectValid(mesh, foam);
  ASSERT_EQ(foam.cellZones.size(), 2U);
  EXPECT_EQ(foam.cellZones[0].members.size() + foam.cellZones[1].members.size(), 24U);
  ASSERT_EQ(foam.faceZones.size(), 1U);
  EXPECT_EQ(foam.faceZones[0].members.size(), 6U);
  for (const int face : foam.faceZones[0].members)
  {
    EXPECT_NE(
      mesh.region[Index(foam.owner[Index(face)])], mesh.region[Index(foam.neighbour[Index(face)])]);
  }
  EXPECT_EQ(Find(foam, "between"), nullptr);
  EXPECT_NE(FoamTextOf(mesh, "constant/polyMesh/faceZones").find("between\n{\n    type faceZone;"),
    std::string::npos);
}

TEST(WriteFoam, NamesAreWords)
{
  Random random(45);
  const std::string letters = "ab1 \"'/;{}()#$\\\tä";
  for (int run = 0; run < 200; ++run)
  {
    SolverMesh quads = Rectangle(1, 1, UnitSquare, random);
    for (std::string& name : quads.sideNames)
    {
      name.clear();
      for (int length = random.Integer(0, 6); length > 0; --length)
      {
        name += letters[Index(random.Integer(0, static_cast<int>(letters.size()) - 1))];
      }
    }
    std::sort(quads.sideNames.begin(), quads.sideNames.end());
    if (std::unique(quads.sideNames.begin(), quads.sideNames.end()) != quads.sideNames.end())
    {
      continue;
    }
    const SolverMesh mesh = SweepQuads(quads, {});
    std::set<std::string> names;
    for (const FoamPatch& patch : FacesOf(mesh).patches)
    {
      names.insert(patch.name);
      EXPECT_EQ(patch.name.find_first_of(" \"'/;{}()#$\\\t"), std::string::npos) << patch.name;
      EXPECT_TRUE(std::isalpha(static_cast<unsigned char>(patch.name[0]))) << patch.name;
    }
    EXPECT_EQ(names.size(), 5U);
  }
}

TEST(WriteFoam, AThousandSides)
{
  Random random(46);
  SolverMesh quads = Rectangle(500, 1, UnitSquare, random);
  quads.sideNames.clear();
  for (int face = 0; face < quads.FaceCount(); ++face)
  {
    quads.sideNames.push_back("side " + std::to_string(face));
    quads.side[Index(face)] = face;
  }
  const SolverMesh mesh = SweepQuads(quads, {});
  const FoamMesh foam = FacesOf(mesh);
  ExpectValid(mesh, foam);
  EXPECT_EQ(foam.patches.size(), 1003U);
}

TEST(WriteFoam, QuadsAreOneLayerOfAPowerOfTen)
{
  Random random(47);
  for (const auto& [size, thickness] :
    { std::pair(1.0, 0.1), std::pair(6.9, 0.1), std::pair(7.1, 1.0), std::pair(1e-3, 1e-4) })
  {
    const auto place = [size = size](double u, double v)
    { return Eigen::Vector3d(size * u, size * v, 0.0); };
    const SolverMesh quads = Rectangle(2, 2, place, random);
    EXPECT_NEAR(FoamThickness(quads) / thickness, 1.0, 1e-15);
  }
  const SolverMesh quads = Rectangle(2, 2, UnitSquare, random);
  const std::string points = FoamTextOf(quads, "constant/polyMesh/points");
  EXPECT_NE(points.find("18\n(\n"), std::string::npos);
  EXPECT_NE(points.find("(1 0.5 0.1)"), std::string::npos) << points;
}

TEST(WriteFoam, OneLayerIsNormalToAnAxis)
{
  Random random(48);
  const auto upright = [](double u, double v) { return Eigen::Vector3d(0.0, u, v); };
  EXPECT_NE(FoamTextOf(Rectangle(2, 2, upright, random), "constant/polyMesh/owner"), "");
  const auto tilted = [](double u, double v) { return Eigen::Vector3d(u, v, u); };
  const SolverMesh quads = Rectangle(2, 2, tilted, random);
  EXPECT_THROW(WriteFoam(quads), Error);
  Sweep sweep;
  sweep.layers = 2;
  const SolverMesh mesh = SweepQuads(quads, sweep);
  ExpectValid(mesh, FacesOf(mesh));
  EXPECT_EQ(WriteFoam(mesh).size(), 8U);
}

TEST(WriteFoam, RefusesFacesTwiceInACell)
{
  Random random(49);
  Sweep sweep;
  sweep.kind = Sweep::Rotation;
  sweep.angle = 360.0;
  const auto place = [](double u, double v) { return Eigen::Vector3d(u, 1.0 + v, 0.0); };
  EXPECT_THROW(FacesOf(SweepQuads(Rectangle(2, 2, place, random), sweep)), Error);
}

TEST(WriteFoam, FolderAndMarker)
{
  Random random(50);
  const SolverMesh quads = Rectangle(1, 1, UnitSquare, random);
  for (const auto& [name, marker, owner] :
    { std::array<std::string, 3>{ "a/b/", "a/b/b.foam", "a/b/constant/polyMesh/owner" },
      std::array<std::string, 3>{ "a/x.foam", "a/x.foam", "a/constant/polyMesh/owner" },
      std::array<std::string, 3>{ "X.FOAM", "X.FOAM", "constant/polyMesh/owner" },
      std::array<std::string, 3>{ "./", "./case.foam", "./constant/polyMesh/owner" },
      std::array<std::string, 3>{ "/", "/case.foam", "/constant/polyMesh/owner" } })
  {
    std::set<std::string> names;
    for (const FileText& file : WriteMeshFiles(quads, name))
    {
      names.insert(file.name);
    }
    EXPECT_EQ(names.count(marker), 1U) << name;
    EXPECT_EQ(names.count(owner), 1U) << name;
  }
  EXPECT_THROW(WriteMeshFiles(LatticeMesh(2, 2, 1, 1, 1).Mesh, "a/"), Error);
}
}
