#include "MeshBlocks.h"

#include "CellLattice.h"
#include "Error.h"
#include "Index.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace crossfield
{
namespace
{
constexpr int Turns = 4; // a quad can be turned

/// Sets the nodes of a block and returns whether its cells agree. Of prisms, whose corners begin at their edge on
/// the axis, corner `turn` is at their indices.
bool Fill(const SolverMesh& mesh, const std::vector<BlockPlace>& places,
  const std::vector<std::size_t>& cells, int turn, MeshBlock& block)
{
  const CellLattice lattice(mesh.dimension, mesh.order);
  std::fill(block.nodes.begin(), block.nodes.end(), -1);
  for (const std::size_t cell : cells)
  {
    const int* nodes = mesh.Cell(static_cast<int>(cell));
    const auto node = [&](int corner) { return nodes[lattice.Corner(corner)]; };
    const bool isPrism = mesh.dimension == 3 && node(0) == node(4) && node(1) == node(5);
    for (int corner = 0; corner < (mesh.dimension == 2 ? 4 : 8); ++corner)
    {
      std::array<int, 3> index = places[cell].index;
      index[0] += corner % 4 == 1 || corner % 4 == 2 ? 1 : 0;
      index[1] += corner % 4 >= 2 ? 1 : 0;
      index[2] += corner >= 4 ? 1 : 0;
      int& place = block.nodes[block.PlaceOf(index)];
      const int turned = isPrism ? (corner + turn) % 4 + corner / 4 * 4 : corner;
      if (place >= 0 && place != node(turned))
      {
        return false;
      }
      place = node(turned);
    }
  }
  return std::find(block.nodes.begin(), block.nodes.end(), -1) == block.nodes.end();
}

/// Returns twice the area or six times the volume of the cells, up to a positive factor.
double SignedSize(const SolverMesh& mesh, const MeshBlock& block)
{
  double size = 0.0;
  const bool isFlat = mesh.dimension == 2;
  const std::array<int, 3> last = { block.cells[0] - 1, block.cells[1] - 1,
    isFlat ? 0 : block.cells[2] - 1 };
  ForEachIndex({ 0, 0, 0 }, last,
    [&](const std::array<int, 3>& at)
    {
      const auto corner = [&](int i, int j, int k) -> const Eigen::Vector3d& {
        return mesh.points[block.NodeAt({ at[0] + i, at[1] + j, at[2] + k })];
      };
      const Eigen::Vector3d normal =
        (corner(1, 1, 0) - corner(0, 0, 0)).cross(corner(0, 1, 0) - corner(1, 0, 0));
      size += isFlat
        ? normal.z()
        : normal.dot(corner(0, 0, 1) + corner(1, 1, 1) - corner(0, 0, 0) - corner(1, 1, 0));
    });
  return size;
}

void Transpose(MeshBlock& block)
{
  MeshBlock turned = block;
  std::swap(turned.cells[0], turned.cells[1]);
  ForEachIndex({ 0, 0, 0 }, block.cells,
    [&](const std::array<int, 3>& at) {
      turned.nodes[turned.PlaceOf({ at[1], at[0], at[2] })] = block.NodeAt(at);
    });
  block = std::move(turned);
}
}

std::vector<MeshBlock> GatherBlocks(const SolverMesh& mesh, const std::vector<BlockPlace>& places)
{
  std::vector<MeshBlock> blocks;
  std::vector<std::vector<std::size_t>> cellsOf; // per block
  for (std::size_t cell = 0; cell < places.size(); ++cell)
  {
    const BlockPlace& place = places[cell];
    if (place.block < 0 || Index(place.block) >= places.size() ||
      *std::min_element(place.index.begin(), place.index.end()) < 0)
    {
      return {};
    }
    if (Index(place.block) >= blocks.size())
    {
      blocks.resize(Index(place.block) + 1, { { 0, 0, 0 }, {} });
      cellsOf.resize(blocks.size());
    }
    for (std::size_t d = 0; d < Index(mesh.dimension); ++d)
    {
      int& count = blocks[place.block].cells[d];
      count = std::max(count, place.index[d] + 1);
    }
    cellsOf[place.block].push_back(cell);
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const std::array<int, 3>& n = blocks[b].cells;
    const std::size_t layers = mesh.dimension == 2 ? 1 : Index(n[2]);
    if (cellsOf[b].empty() || Index(n[0]) * Index(n[1]) * layers != cellsOf[b].size())
    {
      return {};
    }
    blocks[b].nodes.resize(Index(n[0] + 1) * Index(n[1] + 1) * Index(n[2] + 1));
    int turn = 0;
    while (turn < Turns && !Fill(mesh, places, cellsOf[b], turn, blocks[b]))
    {
      ++turn;
    }
    if (turn == Turns)
    {
      return {};
    }
  }
  return blocks;
}

std::vector<int> EdgeNodes(const MeshBlock& block, int direction, std::array<int, 3> start)
{
  std::vector<int> nodes;
  for (int t = 0; t <= block.cells[direction]; ++t)
  {
    start[direction] = t;
    nodes.push_back(block.NodeAt(start));
  }
  return nodes;
}

void RequireBlocks(const SolverMesh& mesh, const std::string& format)
{
  if (mesh.blocks.empty())
  {
    throw Error("The format " + format +
      " has structured blocks only, and the cells of this mesh have no arrays BlockId, I and J; give the "
      "quads of a Quad Mesher, or write a .msh or .vtu file.");
  }
  const auto isPoint = [&mesh](int node) { return node >= 0 && Index(node) < mesh.points.size(); };
  const double mostPoints = 8.0 * (static_cast<double>(mesh.points.size()) + mesh.CellCount());
  double cells = 0.0;
  bool isValid = true;
  for (const MeshBlock& block : mesh.blocks)
  {
    const bool isFlat = mesh.dimension == 2;
    const auto& n = block.cells;
    isValid = isValid && n[0] > 0 && n[1] > 0 && (isFlat ? n[2] == 0 : n[2] > 0);
    const double points = (n[0] + 1.0) * (n[1] + 1.0) * (n[2] + 1.0);
    isValid = isValid && points <= mostPoints &&
      block.nodes.size() == static_cast<std::size_t>(points) &&
      std::all_of(block.nodes.begin(), block.nodes.end(), isPoint);
    cells += static_cast<double>(n[0]) * n[1] * (isFlat ? 1 : n[2]);
  }
  if (!isValid || cells != mesh.CellCount())
  {
    throw Error(
      "The mesh is damaged: its blocks do not have the cells of the mesh; make it again.");
  }
}

void OrientBlocks(SolverMesh& mesh)
{
  if (mesh.dimension == 2 && !mesh.HasConstantHeight())
  {
    return;
  }
  for (MeshBlock& block : mesh.blocks)
  {
    if (SignedSize(mesh, block) < 0.0)
    {
      Transpose(block);
    }
  }
}
}
