#pragma once

// Meshes of structured blocks: random ones with random directions, a ring, a C-grid and a revolution.

#include "Index.h"
#include "SolverMesh.h"
#include "Support.h"
#include "SweepQuads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <vector>

namespace crossfield::test
{
/// Builds a mesh from blocks of points on an integer lattice: equal places are one point. Faces of one
/// block only are the boundary; `sideOf` names them, given the middle of the face times four.
class BlockBuilder
{
public:
  using Place = std::array<int, 3>;

  explicit BlockBuilder(int dimension)
  {
    this->Mesh.dimension = dimension;
    this->Mesh.order = 1;
    this->Mesh.regionNames = { "domain" };
  }

  /// Adds a block with the places of its points, the first index fastest.
  void Add(const std::array<int, 3>& cells, const std::vector<Place>& places)
  {
    MeshBlock block = { cells, {} };
    for (const Place& place : places)
    {
      const auto [number, isNew] =
        this->Numbers.emplace(place, static_cast<int>(this->Places.size()));
      if (isNew)
      {
        this->Places.push_back(place);
      }
      block.nodes.push_back(number->second);
    }
    this->Mesh.blocks.push_back(block);
  }

  SolverMesh Build(std::uint32_t seed, const std::vector<std::string>& names,
    const std::function<int(const Place&)>& sideOf)
  {
    SolverMesh& mesh = this->Mesh;
    mesh.sideNames = names;
    Random random(seed);
    std::vector<int> order;
    for (int i = 0; i < static_cast<int>(this->Places.size()); ++i)
    {
      order.push_back(i);
    }
    random.Shuffle(order); // new number of each point
    mesh.points.resize(order.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      const Place& p = this->Places[i];
      mesh.points[Index(order[i])] = Eigen::Vector3d(p[0] / 3.0, p[1] / 7.0, p[2] / 9.0);
    }
    std::map<std::vector<int>, std::vector<int>> faces;
    const bool isFlat = mesh.dimension == 2;
    for (MeshBlock& block : mesh.blocks)
    {
      for (int& node : block.nodes)
      {
        node = order[Index(node)];
      }
      const auto& n = block.cells;
      for (int cell = 0; cell < n[0] * n[1] * std::max(n[2], 1); ++cell)
      {
        const std::array<int, 3> at = { cell % n[0], cell / n[0] % n[1], cell / (n[0] * n[1]) };
        std::vector<int> corners;
        for (int c = 0; c < (isFlat ? 4 : 8); ++c)
        {
          const std::size_t place = Index(at[0] + (c & 1)) +
            Index(n[0] + 1) *
              (Index(at[1] + (c >> 1 & 1)) + Index(n[1] + 1) * Index(at[2] + (c >> 2)));
          corners.push_back(block.nodes[place]);
        }
        mesh.cells.insert(mesh.cells.end(), corners.begin(), corners.end());
        mesh.region.push_back(0);
        for (int face = 0; face < 2 * mesh.dimension; ++face)
        {
          std::vector<int> ofFace;
          for (int c = 0; c < static_cast<int>(corners.size()); ++c)
          {
            if ((c >> (face / 2) & 1) == face % 2)
            {
              ofFace.push_back(corners[Index(c)]);
            }
          }
          std::vector<int> key = ofFace;
          std::sort(key.begin(), key.end());
          if (ofFace.size() == 4)
          {
            std::swap(ofFace[2], ofFace[3]);
          }
          const auto [found, isNew] = faces.emplace(key, ofFace);
          if (!isNew)
          {
            found->second.clear();
          }
        }
      }
    }
    for (const auto& [key, corners] : faces)
    {
      if (corners.empty())
      {
        continue;
      }
      Place middle{};
      for (const int corner : corners)
      {
        const auto at = std::find(order.begin(), order.end(), corner) - order.begin();
        for (std::size_t d = 0; d < 3; ++d)
        {
          middle[d] += this->Places[static_cast<std::size_t>(at)][d] * (isFlat ? 2 : 1);
        }
      }
      mesh.faces.insert(mesh.faces.end(), corners.begin(), corners.end());
      mesh.side.push_back(sideOf(middle));
    }
    return mesh;
  }

private:
  SolverMesh Mesh;
  std::map<Place, int> Numbers;
  std::vector<Place> Places;
};

/// Adds the box of lattice cells between two places as a block with a random right-handed frame.
inline void AddBox(const std::array<int, 3>& low, const std::array<int, 3>& size, int dimension,
  Random& random, BlockBuilder& builder)
{
  std::array<std::size_t, 3> axis = { 0, 1, 2 };
  std::array<bool, 3> isReversed{};
  Eigen::Matrix3d frame;
  do
  {
    frame.setZero();
    if (random.Integer(0, 1) == 1)
    {
      std::swap(axis[0], axis[1]);
    }
    if (dimension == 3)
    {
      std::swap(axis[2], axis[Index(random.Integer(0, 2))]);
    }
    for (std::size_t d = 0; d < 3; ++d)
    {
      isReversed[d] = (dimension == 3 || d < 2) && random.Integer(0, 1) == 1;
      frame(static_cast<int>(axis[d]), static_cast<int>(d)) = isReversed[d] ? -1.0 : 1.0;
    }
  } while (frame.determinant() < 0.0);
  std::array<int, 3> cells{};
  for (std::size_t d = 0; d < 3; ++d)
  {
    cells[d] = size[axis[d]];
  }
  std::vector<BlockBuilder::Place> places;
  for (int k = 0; k <= cells[2]; ++k)
  {
    for (int j = 0; j <= cells[1]; ++j)
    {
      for (int i = 0; i <= cells[0]; ++i)
      {
        const std::array<int, 3> step = { i, j, k };
        BlockBuilder::Place place = low;
        for (std::size_t d = 0; d < 3; ++d)
        {
          place[axis[d]] += isReversed[d] ? cells[d] - step[d] : step[d];
        }
        places.push_back(place);
      }
    }
  }
  builder.Add(cells, places);
}

/// Returns a box of equal blocks with random frames; in two dimensions the third number of both is 0. Sides
/// are called by axis and end.
inline SolverMesh BlockGrid(
  const std::array<int, 3>& blocks, const std::array<int, 3>& cells, std::uint32_t seed)
{
  const int dimension = cells[2] == 0 ? 2 : 3;
  Random random(seed);
  BlockBuilder builder(dimension);
  for (int b = 0; b < blocks[0] * blocks[1] * std::max(blocks[2], 1); ++b)
  {
    const std::array<int, 3> low = { b % blocks[0] * cells[0], b / blocks[0] % blocks[1] * cells[1],
      b / (blocks[0] * blocks[1]) * cells[2] };
    AddBox(low, cells, dimension, random, builder);
  }
  return builder.Build(seed, { "bottom", "top", "left", "right", "back", "front" },
    [&](const BlockBuilder::Place& middle)
    {
      const std::array<std::size_t, 3> axes = { 1, 0, 2 };
      for (std::size_t i = 0; i < 3; ++i)
      {
        const std::size_t d = axes[i];
        if (middle[d] == 0 && (d < 2 || dimension == 3))
        {
          return static_cast<int>(2 * i);
        }
        if (cells[d] > 0 && middle[d] == 4 * blocks[d] * cells[d])
        {
          return static_cast<int>(2 * i + 1);
        }
      }
      return -1;
    });
}

/// Returns some blocks of a lattice with random numbers of cells, and random names.
inline SolverMesh RandomBlocks(int dimension, std::uint32_t seed)
{
  Random random(seed);
  BlockBuilder builder(dimension);
  std::array<std::vector<int>, 3> cuts;
  for (std::size_t d = 0; d < 3; ++d)
  {
    cuts[d] = { 0 };
    const int count = static_cast<int>(d) < dimension ? random.Integer(1, 3) : 0;
    for (int i = 0; i < count; ++i)
    {
      cuts[d].push_back(cuts[d].back() + random.Integer(1, 4));
    }
    if (count == 0)
    {
      cuts[d].push_back(0);
    }
  }
  for (std::size_t k = 0; k + 1 < cuts[2].size(); ++k)
  {
    for (std::size_t j = 0; j + 1 < cuts[1].size(); ++j)
    {
      for (std::size_t i = 0; i + 1 < cuts[0].size(); ++i)
      {
        if (i + j + k == 0 || random.Integer(0, 3) > 0)
        {
          AddBox({ cuts[0][i], cuts[1][j], cuts[2][k] },
            { cuts[0][i + 1] - cuts[0][i], cuts[1][j + 1] - cuts[1][j],
              cuts[2][k + 1] - cuts[2][k] },
            dimension, random, builder);
        }
      }
    }
  }
  return builder.Build(seed, { "a", "b", "c" },
    [&](const BlockBuilder::Place&)
    { return random.Integer(0, 5) == 0 ? random.Integer(1, 2) : 0; });
}

/// Returns one block around a circle, which is its own neighbour; with layers in three dimensions.
inline SolverMesh Ring(int around, int rows, int layers)
{
  BlockBuilder builder(layers == 0 ? 2 : 3);
  std::vector<BlockBuilder::Place> places;
  for (int k = 0; k <= layers; ++k)
  {
    for (int j = 0; j <= rows; ++j)
    {
      for (int i = 0; i <= around; ++i)
      {
        places.push_back({ i % around, j, k });
      }
    }
  }
  builder.Add({ around, rows, layers }, places);
  SolverMesh mesh = builder.Build(5, { "inner", "outer", "back", "front" },
    [&](const BlockBuilder::Place& middle)
    { return middle[1] == 0 ? 0 : (middle[1] == 4 * rows ? 1 : (middle[2] == 0 ? 2 : 3)); });
  for (Eigen::Vector3d& point : mesh.points) // from the lattice to the ring
  {
    const double angle = -2.0 * Pi * std::round(point.x() * 3.0) / around;
    const double radius = 1.0 + point.y();
    point = Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), point.z());
  }
  return mesh;
}

/// Returns one block around a body with a wake behind it: the first `wake` edges of row 0 are the last ones.
inline SolverMesh CGrid(int wake, int body, int rows)
{
  BlockBuilder builder(2);
  const int columns = 2 * wake + body;
  std::vector<BlockBuilder::Place> places;
  for (int j = 0; j <= rows; ++j)
  {
    for (int i = 0; i <= columns; ++i)
    {
      const bool isUpper = i > wake + body || (j == 0 && i == wake + body);
      places.push_back({ j == 0 && isUpper ? columns - i : i, j, 0 });
    }
  }
  builder.Add({ columns, rows, 0 }, places);
  return builder.Build(5, { "body", "far" },
    [&](const BlockBuilder::Place& middle) { return middle[1] == 0 ? 0 : 1; });
}

/// Returns blocks of quads above the line y = 0, two of which touch it, revolved about it.
inline SolverMesh Revolved(double angle)
{
  BlockBuilder builder(2);
  for (const auto& [x, y] : { std::pair{ 0, 0 }, { 3, 0 }, { 0, 2 }, { 3, 2 } })
  {
    std::vector<BlockBuilder::Place> places;
    for (int j = 0; j <= 2; ++j)
    {
      for (int i = 0; i <= 3; ++i)
      {
        places.push_back({ x + i, y + j, 0 });
      }
    }
    builder.Add({ 3, 2, 0 }, places);
  }
  const SolverMesh quads = builder.Build(4, { "axis", "left", "right", "top" },
    [&](const BlockBuilder::Place& middle)
    { return middle[1] == 0 ? 0 : (middle[0] == 0 ? 1 : (middle[0] == 24 ? 2 : 3)); });
  Sweep sweep;
  sweep.kind = Sweep::Rotation;
  sweep.angle = angle;
  sweep.layers = 6;
  return SweepQuads(quads, sweep);
}
}
