// PLOT3D and Exodus as their formats are read: exact numbers, order of points, names, empty groups.

#include "FormatChecks.h"
#include "MeshBlocks.h"
#include "MeshFormats.h"
#include "solvermesh/BlockChecks.h"

#include <cstring>
#include <sstream>

namespace crossfield::test
{
namespace
{
/// Reads the dimensions and variables of a classic netCDF file with 64-bit offsets.
class NetCdfReader
{
public:
  struct Variable
  {
    std::vector<std::string> dimensions;
    std::size_t type = 0;
    std::size_t begin = 0;
  };

  explicit NetCdfReader(std::string bytes)
    : Bytes(std::move(bytes))
  {
    EXPECT_EQ(this->Bytes.substr(0, 4), std::string("CDF\x02"));
    this->At = 8;
    std::vector<std::string> names;
    for (std::size_t i = this->List(10); i > 0; --i)
    {
      names.push_back(this->Text());
      this->Dimensions[names.back()] = this->Number(4);
    }
    this->SkipAttributes();
    for (std::size_t i = this->List(11); i > 0; --i)
    {
      const std::string name = this->Text();
      Variable variable;
      for (std::size_t d = this->Number(4); d > 0; --d)
      {
        variable.dimensions.push_back(names.at(this->Number(4)));
      }
      this->SkipAttributes();
      variable.type = this->Number(4);
      this->Number(4);
      variable.begin = this->Number(8);
      this->Variables[name] = variable;
    }
  }

  std::vector<double> Numbers(const std::string& name)
  {
    const Variable& variable = this->Variables.at(name);
    std::vector<double> values(this->Size(variable));
    this->At = variable.begin;
    for (double& value : values)
    {
      const std::uint64_t bits = this->Number(variable.type == 6 ? 8 : 4);
      if (variable.type == 6)
      {
        std::memcpy(&value, &bits, sizeof(bits));
      }
      else
      {
        value = static_cast<std::int32_t>(bits);
      }
    }
    return values;
  }

  std::vector<std::string> Texts(const std::string& name)
  {
    const Variable& variable = this->Variables.at(name);
    const std::size_t length = this->Dimensions.at(variable.dimensions.back());
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < this->Size(variable); i += length)
    {
      texts.emplace_back(this->Bytes.substr(variable.begin + i, length).c_str());
    }
    return texts;
  }

  std::map<std::string, std::size_t> Dimensions;
  std::map<std::string, Variable> Variables;

private:
  std::size_t Size(const Variable& variable) const
  {
    std::size_t size = 1;
    for (const std::string& dimension : variable.dimensions)
    {
      size *= this->Dimensions.at(dimension);
    }
    return size;
  }

  std::uint64_t Number(std::size_t width)
  {
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < width; ++i)
    {
      number = (number << 8) | static_cast<unsigned char>(this->Bytes.at(this->At++));
    }
    return number;
  }

  std::string Text()
  {
    const std::size_t size = this->Number(4);
    const std::string text = this->Bytes.substr(this->At, size);
    this->At += (size + 3) / 4 * 4;
    return text;
  }

  std::size_t List(std::size_t tag)
  {
    const std::size_t found = this->Number(4);
    const std::size_t size = this->Number(4);
    EXPECT_EQ(found, size == 0 ? 0 : tag);
    return size;
  }

  void SkipAttributes()
  {
    for (std::size_t i = this->List(12); i > 0; --i)
    {
      this->Text();
      const std::size_t type = this->Number(4);
      const std::size_t size = this->Number(4);
      this->At += type == 2 ? (size + 3) / 4 * 4 : 4 * size;
    }
  }

  std::string Bytes;
  std::size_t At = 0;
};
}

TEST(BlockFormats, Plot3dHasThePointsOfAllBlocks)
{
  for (const int dimension : { 2, 3 })
  {
    SolverMesh mesh = RandomBlocks(dimension, 11);
    PrepareMesh(mesh, MeshFormat::Plot3d);
    const std::vector<FileText> files = WriteMeshFiles(mesh, "folder/a.xyz");
    ASSERT_EQ(files.size(), 2U);
    EXPECT_EQ(files[1].name, "folder/a.nmf");
    std::istringstream text(files[0].text);
    std::size_t count = 0;
    text >> count;
    ASSERT_EQ(count, mesh.blocks.size());
    for (const MeshBlock& block : mesh.blocks)
    {
      for (int d = 0; d < dimension; ++d)
      {
        int points = 0;
        text >> points;
        EXPECT_EQ(points, block.cells[Index(d)] + 1);
      }
    }
    for (const MeshBlock& block : mesh.blocks)
    {
      for (int axis = 0; axis < dimension; ++axis)
      {
        for (const int node : block.nodes)
        {
          double value = 0.0;
          text >> value;
          EXPECT_EQ(value, mesh.points[Index(node)][axis]) << "to the last bit";
        }
      }
    }
    std::string rest;
    EXPECT_FALSE(text >> rest);
  }
}

TEST(BlockFormats, QuadsInSpaceAreOneLayerOfPoints)
{
  SolverMesh mesh = BlockGrid({ 1, 1, 0 }, { 2, 1, 0 }, 1);
  for (Eigen::Vector3d& point : mesh.points)
  {
    point.z() = point.x();
  }
  EXPECT_EQ(WriteMeshFiles(mesh, "a.xyz")[0].text.substr(0, 2), "1\n");
  std::istringstream text(WriteMeshFiles(mesh, "a.xyz")[0].text);
  int count = 0;
  std::array<int, 3> size{};
  text >> count >> size[0] >> size[1] >> size[2];
  EXPECT_EQ(size[2], 1);
}

TEST(BlockFormats, ExodusHasElementsAndSideSets)
{
  for (const auto& [dimension, order] : { std::pair{ 2, 1 }, { 2, 2 }, { 3, 1 }, { 3, 2 } })
  {
    const LatticeMesh lattice(dimension, order, 4, 3, 17);
    SolverMesh mesh = lattice.Mesh;
    mesh.sideNames.emplace_back("empty");
    mesh.regionNames.emplace_back("empty too");
    const std::string bytes = Written(mesh, "a.exo");
    NetCdfReader file(bytes);
    ReadBack points(lattice);
    const auto coordinates = [&](const char* name)
    {
      return file.Variables.count(name) > 0
        ? file.Numbers(name)
        : std::vector<double>(file.Dimensions.at("num_nodes"), 0.1); // the z of this lattice
    };
    const std::vector<double> x = coordinates("coordx");
    const std::vector<double> y = coordinates("coordy");
    const std::vector<double> z = coordinates("coordz");
    std::vector<std::size_t> pointOf;
    for (std::size_t node = 0; node < x.size(); ++node)
    {
      pointOf.push_back(points.Find(x[node], y[node], z[node]));
    }
    EXPECT_EQ(file.Texts("eb_names"), mesh.regionNames);
    EXPECT_EQ(file.Texts("ss_names"), mesh.sideNames);
    EXPECT_EQ(file.Numbers("eb_status"), (std::vector<double>{ 1.0, 1.0, 0.0 }));
    EXPECT_EQ(file.Variables.count("connect3") + file.Variables.count("elem_ss7"), 0U);
    EXPECT_EQ(file.Dimensions.at("num_elem"), 12U);
    // The corners of side sets are those of the faces: sides of Exodus, from 1.
    const std::vector<std::vector<int>> sides = dimension == 2
      ? std::vector<std::vector<int>>{ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } }
      : std::vector<std::vector<int>>{ { 0, 1, 5, 4 }, { 1, 2, 6, 5 }, { 2, 3, 7, 6 },
          { 0, 4, 7, 3 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
    std::vector<std::vector<double>> elements;
    for (const char* block : { "connect1", "connect2" })
    {
      const std::vector<double> nodes = file.Numbers(block);
      const std::size_t size =
        file.Dimensions.at(std::string("num_nod_per_el") + block[std::strlen(block) - 1]);
      for (std::size_t i = 0; i < nodes.size(); i += size)
      {
        elements.emplace_back(nodes.begin() + static_cast<std::ptrdiff_t>(i),
          nodes.begin() + static_cast<std::ptrdiff_t>(i + size));
      }
    }
    const std::size_t corners = Index(mesh.CornersOfFace());
    for (std::size_t side = 0; side + 1 < mesh.sideNames.size(); ++side)
    {
      const std::vector<double> element = file.Numbers("elem_ss" + std::to_string(side + 1));
      const std::vector<double> number = file.Numbers("side_ss" + std::to_string(side + 1));
      std::size_t next = 0;
      for (int face = 0; face < mesh.FaceCount(); ++face)
      {
        if (mesh.side[Index(face)] != static_cast<int>(side))
        {
          continue;
        }
        std::vector<std::size_t> found;
        for (const int corner : sides.at(static_cast<std::size_t>(number.at(next)) - 1))
        {
          const double node =
            elements.at(static_cast<std::size_t>(element.at(next)) - 1)[Index(corner)];
          found.push_back(pointOf[static_cast<std::size_t>(node) - 1]);
        }
        std::vector<std::size_t> expected;
        for (std::size_t c = 0; c < corners; ++c)
        {
          expected.push_back(Index(mesh.faces[Index(face) * corners + c]));
        }
        std::sort(found.begin(), found.end());
        std::sort(expected.begin(), expected.end());
        EXPECT_EQ(found, expected);
        ++next;
      }
      EXPECT_EQ(next, element.size());
    }
  }
}

TEST(BlockFormats, NamesOfExodusAreCutAndDifferent)
{
  SolverMesh mesh = BlockGrid({ 1, 1, 0 }, { 2, 1, 0 }, 1);
  mesh.sideNames[0] = std::string(40, 'a') + "1";
  mesh.sideNames[1] = std::string(40, 'a') + "2";
  mesh.sideNames[2] = "größe 'x' \"y\"";
  const std::vector<std::string> names = NetCdfReader(Written(mesh, "a.e")).Texts("ss_names");
  EXPECT_EQ(names[0], std::string(32, 'a'));
  EXPECT_EQ(names[1], std::string(30, 'a') + "_2");
  EXPECT_EQ(names[2], "größe 'x' 'y'");
}

TEST(BlockFormats, WhatCannotBeWrittenIsRefused)
{
  const auto write = [](const SolverMesh& mesh, const char* name)
  { return [&mesh, name] { WriteMeshFiles(mesh, name); }; };
  SolverMesh mesh = BlockGrid({ 2, 1, 0 }, { 2, 1, 0 }, 1);
  EXPECT_TRUE(Refuses(write(mesh, "a.med"), { "ending", ".cgns", ".xyz" }));
  EXPECT_TRUE(Refuses(write(mesh, "a.cgns"), { "vtkQuadMeshWriter" }));
  mesh.blocks.clear();
  EXPECT_TRUE(Refuses(write(mesh, "a.xyz"), { "BlockId" }));
  mesh.points[0].x() = std::nan("");
  EXPECT_TRUE(Refuses(write(mesh, "a.ex2"), { "not finite" }));
  EXPECT_TRUE(Refuses(write(SolverMesh(), "a.ex2"), { "no cells" }));
  for (const char* name : { "a.xyz", "a.cgns" })
  {
    EXPECT_TRUE(Refuses([name] { RequireOrder(MeshFormatOf(name), 2); }, { "order 1 only" }));
  }
  EXPECT_TRUE(Refuses([] { RequireOrder(MeshFormatOf("a.E"), 3); }, { "no elements of order 3" }));
}
}
