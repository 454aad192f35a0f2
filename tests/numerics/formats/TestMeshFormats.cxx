// Meshes in .msh, .inp and .su2: order of nodes, orientation, sides, exact numbers, refusals.

#include "MeshFormats.h"

#include "CellLattice.h"
#include "FormatChecks.h"
#include "TiedNodes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

namespace crossfield::test
{
namespace
{
using Table = std::vector<std::vector<int>>;

// Places of nodes from Gmsh's documentation, in steps of the element's order.
const std::map<std::string, Table> GmshPlaces = { { "1", { { 0 }, { 1 } } },
  { "8", { { 0 }, { 2 }, { 1 } } }, { "26", { { 0 }, { 3 }, { 1 }, { 2 } } },
  { "3", { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } },
  { "10",
    { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 }, { 1, 0 }, { 2, 1 }, { 1, 2 }, { 0, 1 }, { 1, 1 } } },
  { "36",
    { { 0, 0 }, { 3, 0 }, { 3, 3 }, { 0, 3 }, { 1, 0 }, { 2, 0 }, { 3, 1 }, { 3, 2 }, { 2, 3 },
      { 1, 3 }, { 0, 2 }, { 0, 1 }, { 1, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } } },
  { "5",
    { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 },
      { 0, 1, 1 } } },
  { "12",
    { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 },
      { 0, 2, 2 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 2, 1, 0 }, { 2, 0, 1 }, { 1, 2, 0 },
      { 2, 2, 1 }, { 0, 2, 1 }, { 1, 0, 2 }, { 0, 1, 2 }, { 2, 1, 2 }, { 1, 2, 2 }, { 1, 1, 0 },
      { 1, 0, 1 }, { 0, 1, 1 }, { 2, 1, 1 }, { 1, 2, 1 }, { 1, 1, 2 }, { 1, 1, 1 } } } };

/// Expects that the nodes of an element are where its type has them.
void ExpectPlaces(
  const LatticeMesh& lattice, const std::vector<std::size_t>& points, const Table& places)
{
  ASSERT_EQ(points.size(), places.size());
  const auto at = [&](std::size_t node) { return lattice.Places[points[node]]; };
  const std::size_t dimension = places[0].size();
  const int order = places[1][0];
  const std::array<std::size_t, 3> ends = { 1, 3, 4 }; // corners along the axes of the element
  for (std::size_t node = 0; node < points.size(); ++node)
  {
    Eigen::Vector3i place = at(0) * order;
    for (std::size_t axis = 0; axis < dimension; ++axis)
    {
      place += (at(ends[axis]) - at(0)) * places[node][axis];
    }
    EXPECT_EQ(place, at(node) * order) << "node " << node;
  }
}

int CountOf(const std::string& text, const std::string& part)
{
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}
}

TEST(MeshFormats, NodesInMshAreWhereGmshHasThem)
{
  for (const auto& [dimension, order] :
    { std::pair{ 2, 1 }, { 2, 2 }, { 2, 3 }, { 3, 1 }, { 3, 2 } })
  {
    for (const MshVersion version : { MshVersion::V22, MshVersion::V41 })
    {
      const LatticeMesh lattice(dimension, order, 4, 3, 17);
      ReadBack file(lattice);
      file.ReadMsh(Written(lattice.Mesh, "a.msh", version));
      std::map<std::string, int> counts;
      double area = 0.0;
      double byGreen = 0.0;
      for (const Element& element : file.Elements)
      {
        ++counts[file.Names.at(element.group)];
        ASSERT_EQ(GmshPlaces.count(element.type), 1U) << element.type;
        ExpectPlaces(lattice, element.points, GmshPlaces.at(element.type));
        const auto at = [&](std::size_t i) { return lattice.Mesh.points[element.points[i]]; };
        if (dimension == 2 && element.points.size() == Index(order + 1))
        {
          byGreen += 0.5 * (at(0).x() * at(1).y() - at(1).x() * at(0).y());
        }
        else if (dimension == 2)
        {
          const double size = (at(1) - at(0)).cross(at(3) - at(0)).z();
          EXPECT_GT(size, 0.0) << "counter-clockwise";
          area += size;
        }
        else if (element.type == "5" || element.type == "12")
        {
          EXPECT_GT((at(1) - at(0)).cross(at(3) - at(0)).dot(at(4) - at(0)), 0.0) << "right-handed";
        }
        else
        {
          const Eigen::Vector3d centre = 0.5 * (at(0) + at(2));
          const Eigen::Vector3d middle(2.0 * order / 3.0, 1.5 * order / 7.0, 0.15 * order);
          EXPECT_GT((at(1) - at(0)).cross(at(3) - at(0)).dot(centre - middle), 0.0) << "outward";
        }
      }
      EXPECT_NEAR(area, byGreen, 1e-12 * area) << "sides have the domain on the left";
      EXPECT_EQ(counts["left"], 6);
      EXPECT_EQ(counts["right"], 6);
      EXPECT_EQ(counts["bottom"], 4);
      EXPECT_EQ(counts["right side"], 3);
      EXPECT_EQ(counts["front"], dimension == 2 ? 0 : 12);
    }
  }
}

TEST(MeshFormats, InpHasSerendipityElementsSetsAndSurfaces)
{
  for (const auto& [dimension, order] : { std::pair{ 2, 1 }, { 2, 2 }, { 3, 1 }, { 3, 2 } })
  {
    const LatticeMesh lattice(dimension, order, 4, 3, 23);
    ReadBack found(lattice);
    const std::string text = Written(lattice.Mesh, "a.inp");
    std::istringstream file(text);
    std::map<int, std::size_t> nodes;
    std::map<int, std::vector<std::size_t>> elements;
    std::map<std::string, std::set<int>> nodeSets;
    std::map<std::string, std::vector<std::pair<int, int>>> surfaces;
    std::string card;
    std::vector<int> row;
    for (std::string line; std::getline(file, line);)
    {
      if (line.rfind("**", 0) == 0 || line[0] == '*')
      {
        card = line;
        continue;
      }
      const bool continues = line.back() == ',';
      const bool isSurface = card.rfind("*SURFACE", 0) == 0;
      std::replace(line.begin(), line.end(), ',', ' ');
      std::istringstream entries(line);
      if (card.rfind("*NODE", 0) == 0)
      {
        int number = 0;
        std::string x;
        std::string y;
        std::string z;
        entries >> number >> x >> y >> z;
        EXPECT_LE(std::max({ x.size(), y.size(), z.size() }), 20U);
        nodes[number] = found.Find(std::stod(x), std::stod(y), std::stod(z));
        continue;
      }
      if (isSurface)
      {
        int element = 0;
        char s = 0;
        int face = 0;
        entries >> element >> s >> face;
        surfaces[card].emplace_back(element, face);
        continue;
      }
      std::size_t inLine = 0;
      for (int entry = 0; entries >> entry; ++inLine)
      {
        row.push_back(entry);
      }
      EXPECT_LE(inLine, 16U);
      if (continues)
      {
        continue;
      }
      if (card.rfind("*NSET", 0) == 0)
      {
        nodeSets[card.substr(card.rfind('=') + 1)].insert(row.begin(), row.end());
      }
      else if (card.rfind("*ELEMENT", 0) == 0)
      {
        for (std::size_t i = 1; i < row.size(); ++i)
        {
          elements[row[0]].push_back(nodes.at(row[i]));
        }
      }
      row.clear();
    }
    EXPECT_EQ(elements.size(), 12U);
    Table places = GmshPlaces.at(dimension == 2 ? (order == 1 ? "3" : "10") : "5");
    if (dimension == 2 && order == 2)
    {
      places.pop_back(); // the centre
    }
    if (dimension == 3 && order == 2)
    {
      for (std::vector<int>& corner : places)
      {
        for (int& index : corner)
        {
          index *= 2;
        }
      }
      for (const std::vector<int>& middle :
        Table{ { 1, 0, 0 }, { 2, 1, 0 }, { 1, 2, 0 }, { 0, 1, 0 }, { 1, 0, 2 }, { 2, 1, 2 },
          { 1, 2, 2 }, { 0, 1, 2 }, { 0, 0, 1 }, { 2, 0, 1 }, { 2, 2, 1 }, { 0, 2, 1 } })
      {
        places.push_back(middle);
      }
    }
    std::set<std::size_t> used;
    for (const auto& [number, points] : elements)
    {
      ExpectPlaces(lattice, points, places);
      used.insert(points.begin(), points.end());
    }
    EXPECT_EQ(used.size(), nodes.size()) << "nodes without an element";
    // Abaqus's faces, by corners from 1.
    const Table faces = dimension == 2 ? Table{ { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 1 } }
                                       : Table{ { 1, 2, 3, 4 }, { 5, 8, 7, 6 }, { 1, 5, 6, 2 },
                                           { 2, 6, 7, 3 }, { 3, 7, 8, 4 }, { 4, 8, 5, 1 } };
    const auto bottom = [&](int node) { return lattice.Places[nodes.at(node)].y() == 0; };
    std::size_t onBottom = 0;
    for (const auto& [number, point] : nodes)
    {
      onBottom += bottom(number) ? 1U : 0U;
    }
    ASSERT_EQ(nodeSets["bottom"].size(), onBottom);
    EXPECT_TRUE(std::all_of(nodeSets["bottom"].begin(), nodeSets["bottom"].end(), bottom));
    EXPECT_EQ(nodeSets.count("right_side"), 1U);
    const auto& surface = surfaces["*SURFACE, NAME=bottom, TYPE=ELEMENT"];
    EXPECT_EQ(surface.size(), 4U);
    for (const auto& [element, face] : surface)
    {
      for (const int corner : faces[Index(face - 1)])
      {
        EXPECT_EQ(lattice.Places[elements.at(element)[Index(corner - 1)]].y(), 0);
      }
    }
    EXPECT_EQ(CountOf(text, "** right_side: right side\n"), 1);
  }
}

TEST(MeshFormats, Su2HasCellsPointsAndMarkers)
{
  LatticeMesh lattice(2, 1, 2, 1, 5);
  lattice.Mesh.regionNames = { "domain" };
  lattice.Mesh.region = { 0, 0 };
  std::istringstream file(Written(lattice.Mesh, "a.su2"));
  ReadBack found(lattice);
  std::vector<std::array<int, 4>> cells;
  std::map<std::string, std::vector<std::array<int, 2>>> markers;
  std::vector<std::size_t> points;
  std::string word;
  int count = 0;
  ASSERT_TRUE(file >> word >> count && word == "NDIME=" && count == 2);
  ASSERT_TRUE(file >> word >> count && word == "NELEM=" && count == 2);
  for (int i = 0; i < count; ++i)
  {
    int type = 0;
    int number = 0;
    cells.emplace_back();
    file >> type;
    for (int& node : cells.back())
    {
      file >> node;
    }
    file >> number;
    EXPECT_TRUE(type == 9 && number == i);
  }
  ASSERT_TRUE(file >> word >> count && word == "NPOIN=" && count == 6);
  for (int i = 0; i < count; ++i)
  {
    double x = 0.0;
    double y = 0.0;
    int number = 0;
    file >> x >> y >> number;
    EXPECT_EQ(number, i);
    points.push_back(found.Find(x, y, 0.1));
  }
  ASSERT_TRUE(file >> word >> count && word == "NMARK=" && count == 4);
  for (int side = 0; side < 4; ++side)
  {
    std::string name;
    ASSERT_TRUE(file >> word >> name && word == "MARKER_TAG=");
    ASSERT_TRUE(file >> word >> count && word == "MARKER_ELEMS=");
    for (int i = 0; i < count; ++i)
    {
      int type = 0;
      std::array<int, 2> ends{};
      file >> type >> ends[0] >> ends[1];
      EXPECT_EQ(type, 3);
      markers[name].push_back(ends);
    }
  }
  EXPECT_FALSE(file >> word);
  const auto at = [&](int node) { return lattice.Mesh.points[points[Index(node)]]; };
  for (const std::array<int, 4>& cell : cells)
  {
    EXPECT_GT((at(cell[2]) - at(cell[0])).cross(at(cell[3]) - at(cell[1])).z(), 0.0);
  }
  ASSERT_EQ(markers["bottom"].size(), 2U);
  for (const auto& [first, second] : markers["bottom"])
  {
    EXPECT_EQ(at(first).y(), 0.0);
    EXPECT_LT(at(first).x(), at(second).x());
  }
  EXPECT_EQ(markers["right_side"].size(), 1U);
}

TEST(MeshFormats, NumbersAreExact)
{
  LatticeMesh lattice(2, 1, 1, 1, 1);
  lattice.Mesh.points[0].x() = -1.0 / 3.0 * 1e-300;
  lattice.Mesh.points[1].y() = std::nextafter(1.0, 2.0);
  ReadBack file(lattice);
  file.ReadMsh(Written(lattice.Mesh, "a.msh")); // finds points by exact coordinates
  EXPECT_EQ(file.Elements.size(), 5U);
  const std::string text = Written(lattice.Mesh, "a.inp");
  EXPECT_NE(text.find(" -3.333333333333e-301,"), std::string::npos) << text;
  EXPECT_NE(text.find(" 1.0000000000000002,"), std::string::npos) << text;
}

TEST(MeshFormats, RefusesWhatAFormatCannotHave)
{
  const auto expect = [](const SolverMesh& mesh, const std::string& name, const std::string& reason)
  {
    try
    {
      Written(mesh, name);
      ADD_FAILURE() << "no error: " << reason;
    }
    catch (const Error& error)
    {
      EXPECT_NE(std::string(error.what()).find(reason), std::string::npos) << error.what();
    }
  };
  const SolverMesh third = LatticeMesh(2, 3, 2, 2, 1).Mesh;
  expect(third, "a.inp", "no elements of order 3");
  expect(third, "a.su2", "order 1 only");
  SolverMesh mesh = LatticeMesh(2, 1, 2, 2, 1).Mesh;
  expect(mesh, "a.su2", "no regions, and this mesh has 2");
  SolverMesh tilted = mesh;
  tilted.points[0].z() += 1.0;
  tilted.regionNames.resize(1);
  tilted.region.assign(4, 0);
  expect(tilted, "a.su2", "z = const");
  SolverMesh missing = mesh;
  missing.faces.resize(missing.faces.size() - 2);
  missing.side.pop_back();
  expect(missing, "a.msh", "belongs to no side");
  SolverMesh twice = mesh;
  twice.faces.insert(twice.faces.end(), { twice.faces[1], twice.faces[0] });
  twice.side.push_back(1);
  expect(twice, "a.msh", "given twice");
  SolverMesh foreign = mesh;
  const CellLattice lattice(2, 1);
  foreign.faces.insert(foreign.faces.end(),
    { mesh.cells[Index(lattice.Corner(0))], mesh.cells[Index(lattice.Corner(2))] });
  foreign.side.push_back(0);
  expect(foreign, "a.msh", "belongs to no cell");
  SolverMesh inside = mesh;
  inside.regionNames.resize(1);
  inside.region.assign(4, 0);
  const std::set<int> first(mesh.cells.begin(), mesh.cells.begin() + 4);
  for (int i = 4; i < 8; ++i)
  {
    if (first.count(mesh.cells[Index(i)]) > 0)
    {
      inside.faces.push_back(mesh.cells[Index(i)]);
    }
  }
  inside.side.push_back(0);
  expect(inside, "a.su2", "'bottom' is inside");
  SolverMesh damaged = mesh;
  damaged.cells[3] = 9;
  expect(damaged, "a.msh", "damaged");
  damaged = mesh;
  damaged.side[0] = 4;
  expect(damaged, "a.msh", "damaged");
}

TEST(MeshFormats, PointsOfPeriodicSidesAreTiedToOne)
{
  // Sides left and right, bottom and top: the four corners are one point, which is the only one
  // that is not tied.
  SolverMesh square = LatticeMesh(2, 2, 3, 2, 5).Mesh;
  SidePair across{ 3, 1, Eigen::Matrix4d::Identity() };
  SidePair along{ 0, 2, Eigen::Matrix4d::Identity() };
  const auto extent = [&square](int axis)
  {
    double largest = 0.0;
    for (const Eigen::Vector3d& point : square.points)
    {
      largest = std::max(largest, point[axis]);
    }
    return largest;
  };
  across.motion(0, 3) = extent(0);
  along.motion(1, 3) = extent(1);
  square.pairs = { across, along };
  OrientCells(square);
  const std::vector<TiedNode> ties = TieNodes(square, MeshFaces(square));
  EXPECT_EQ(ties.size(), 3U + 3U + 5U); // corners, and points inside of sides of 2 and of 3 quads
  std::set<int> tied;
  for (const TiedNode& tie : ties)
  {
    EXPECT_TRUE(tied.insert(tie.node).second) << "twice";
    EXPECT_TRUE(tie.rotation.isIdentity());
  }
  for (const TiedNode& tie : ties)
  {
    EXPECT_EQ(tied.count(tie.other), 0U) << "a chain";
  }
  const std::string text = Written(square, "a.inp");
  EXPECT_EQ(CountOf(text, ", 1., "), 2 * static_cast<int>(ties.size()));
}
}
