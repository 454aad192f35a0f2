#pragma once

#include "Index.h"
#include "MeshFormats.h"
#include "SolverMesh.h"
#include "Support.h"
#include "WriteFoam.h"

#include <algorithm>
#include <array>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace crossfield::test
{
/// Returns the text of a format that has one file.
inline std::string Written(
  const SolverMesh& mesh, const std::string& name, MshVersion version = MshVersion::V41)
{
  return WriteMeshFiles(mesh, name, version).at(0).text;
}

/// Returns the text of a file of a case of OpenFOAM, an empty one if there is no such file.
inline std::string FoamTextOf(const SolverMesh& mesh, const std::string& file)
{
  for (const auto& [name, text] : WriteFoam(mesh))
  {
    if (name == file)
    {
      return text;
    }
  }
  return "";
}

/// Points on a lattice of columns × rows (× 1) cells; cells and faces have random directions.
class LatticeMesh
{
public:
  LatticeMesh(int dimension, int order, int columns, int rows, std::uint32_t seed)
    : Random_(seed)
  {
    SolverMesh& mesh = this->Mesh;
    mesh.dimension = dimension;
    mesh.order = order;
    mesh.regionNames = { "left", "right" };
    mesh.sideNames = { "bottom", "right side", "top", "left side", "back", "front" };
    mesh.sideNames.resize(dimension == 2 ? 4 : 6);
    const std::array<int, 3> cells = { columns, rows, dimension == 2 ? 0 : 1 };
    const std::array<int, 3> size = { columns * order + 1, rows * order + 1, cells[2] * order + 1 };
    for (int n = 0; n < size[0] * size[1] * size[2]; ++n)
    {
      this->Places.push_back(
        Eigen::Vector3i(n % size[0], n / size[0] % size[1], n / (size[0] * size[1])));
    }
    this->Random_.Shuffle(this->Places); // else numbers of nodes would be those of the lattice
    std::vector<int> numbers(this->Places.size());
    for (std::size_t i = 0; i < this->Places.size(); ++i)
    {
      const Eigen::Vector3i& p = this->Places[i];
      numbers[Index(p.x() + size[0] * (p.y() + size[1] * p.z()))] = static_cast<int>(i);
      mesh.points.emplace_back(p.x() / 3.0, p.y() / 7.0, dimension == 2 ? 0.1 : p.z() * 0.3);
    }
    const auto at = [&](int i, int j, int k)
    { return numbers[Index(i + size[0] * (j + size[1] * k))]; };
    const int p = order;
    for (int cell = 0; cell < columns * rows; ++cell)
    {
      const int i = cell % columns * p;
      const int j = cell / columns * p;
      const bool isTurned = this->Random_.Integer(0, 1) == 1;
      for (int c = 0; c <= (dimension == 2 ? 0 : p); ++c)
      {
        for (int b = 0; b <= p; ++b)
        {
          for (int a = 0; a <= p; ++a)
          {
            mesh.cells.push_back(isTurned ? at(i + b, j + a, c) : at(i + a, j + b, c));
          }
        }
      }
      mesh.region.push_back(2 * i < columns * p ? 0 : 1);
      const auto add = [&](bool isBoundary, int side, std::vector<int> corners)
      {
        if (isBoundary)
        {
          std::rotate(
            corners.begin(), corners.begin() + this->Random_.Integer(0, 1), corners.end());
          mesh.faces.insert(mesh.faces.end(), corners.begin(), corners.end());
          mesh.side.push_back(side);
        }
      };
      const auto wall = [&](int i0, int j0, int i1, int j1)
      {
        return dimension == 2
          ? std::vector<int>{ at(i0, j0, 0), at(i1, j1, 0) }
          : std::vector<int>{ at(i0, j0, 0), at(i1, j1, 0), at(i1, j1, p), at(i0, j0, p) };
      };
      add(j == 0, 0, wall(i, j, i + p, j));
      add(i + p == columns * p, 1, wall(i + p, j, i + p, j + p));
      add(j + p == rows * p, 2, wall(i, j + p, i + p, j + p));
      add(i == 0, 3, wall(i, j, i, j + p));
      for (int k = 0; dimension == 3 && k < 2; ++k)
      {
        add(true, 4 + k,
          { at(i, j, k * p), at(i + p, j, k * p), at(i + p, j + p, k * p), at(i, j + p, k * p) });
      }
    }
  }

  SolverMesh Mesh;
  std::vector<Eigen::Vector3i> Places; ///< Per point, its indices in the lattice.

private:
  Random Random_;
};

/// An element of a file: its type, group, and points of the mesh in the order of the file.
struct Element
{
  std::string type;
  int group = 0;
  std::vector<std::size_t> points;
};

/// A file as its format is read, with the point of the mesh that is at each node, found by its coordinates.
class ReadBack
{
public:
  explicit ReadBack(const LatticeMesh& lattice)
  {
    for (std::size_t i = 0; i < lattice.Mesh.points.size(); ++i)
    {
      const Eigen::Vector3d& p = lattice.Mesh.points[i];
      this->Points[{ p.x(), p.y(), p.z() }] = i;
    }
  }

  std::size_t Find(double x, double y, double z) const
  {
    const auto found = this->Points.find({ x, y, z });
    EXPECT_NE(found, this->Points.end())
      << "the coordinates are not those of a point to the last bit";
    return found == this->Points.end() ? 0 : found->second;
  }

  void ReadMsh(const std::string& text)
  {
    std::istringstream file(text);
    std::string word;
    double version = 0.0;
    std::map<int, std::size_t> nodes;
    const auto skipTo = [&](const std::string& section)
    {
      while (file >> word && word != section)
      {
      }
      ASSERT_EQ(word, section);
    };
    skipTo("$MeshFormat");
    file >> version;
    skipTo("$PhysicalNames");
    int count = 0;
    file >> count;
    for (int i = 0; i < count; ++i)
    {
      int dimension = 0;
      int tag = 0;
      file >> dimension >> tag >> std::ws;
      std::getline(file, word);
      this->Names[tag] = word.substr(1, word.size() - 2);
    }
    skipTo("$Nodes");
    int blocks = 1;
    file >> (version > 4.0 ? blocks : count);
    if (version > 4.0)
    {
      file >> count >> word >> word;
    }
    for (int block = 0; block < blocks; ++block)
    {
      std::vector<int> tags;
      int inBlock = count;
      if (version > 4.0)
      {
        file >> word >> word >> word >> inBlock;
        for (int i = 0; i < inBlock; ++i)
        {
          tags.emplace_back();
          file >> tags.back();
        }
      }
      for (int i = 0; i < inBlock; ++i)
      {
        int tag = 0;
        if (version < 4.0)
        {
          file >> tag;
          tags.push_back(tag);
        }
        double x = 0.0;
        double y = 0.0;
        double z = 0.0;
        file >> x >> y >> z;
        nodes[tags[Index(i)]] = this->Find(x, y, z);
      }
    }
    EXPECT_EQ(nodes.size(), static_cast<std::size_t>(count));
    skipTo("$Elements");
    file >> (version > 4.0 ? blocks : count);
    if (version > 4.0)
    {
      file >> count >> word >> word;
    }
    for (int block = 0; block < blocks; ++block)
    {
      Element element;
      int inBlock = count;
      if (version > 4.0)
      {
        file >> word >> element.group >> element.type >> inBlock;
      }
      for (int i = 0; i < inBlock; ++i)
      {
        file >> word;
        if (version < 4.0)
        {
          file >> element.type >> word >> element.group >> word;
        }
        std::getline(file, word);
        std::istringstream line(word);
        element.points.clear();
        for (int node = 0; line >> node;)
        {
          element.points.push_back(nodes.at(node));
        }
        this->Elements.push_back(element);
      }
    }
    EXPECT_EQ(this->Elements.size(), static_cast<std::size_t>(count));
  }

  std::map<int, std::string> Names;
  std::vector<Element> Elements;

private:
  std::map<std::array<double, 3>, std::size_t> Points;
};
}
