#include "GatherBlocks.h"

#include "BlockLattice.h"
#include "CellLattice.h"
#include "Index.h"

#include <algorithm>

namespace crossfield
{
namespace
{
constexpr int Turns = 4; // a quad can be turned

/// Sets the nodes of a block and returns whether its cells agree. Of prisms, whose corners begin at their edge on
/// the axis, corner `turn` is at their indices.
bool Fill(const ExportMesh& mesh, const std::vector<BlockPlace>& places,
  const std::vector<std::size_t>& cells, int turn, ExportBlock& block)
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
      int& place = block.nodes[BlockPoint(block, index)];
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
}

std::vector<ExportBlock> GatherBlocks(const ExportMesh& mesh, const std::vector<BlockPlace>& places)
{
  const bool isFlat = mesh.dimension == 2;
  std::vector<ExportBlock> blocks;
  std::vector<std::size_t> cellsInBlock;
  for (const BlockPlace& place : places)
  {
    if (place.block < 0 || Index(place.block) >= places.size() ||
      *std::min_element(place.index.begin(), place.index.end()) < 0)
    {
      return {};
    }
    if (Index(place.block) >= blocks.size())
    {
      blocks.resize(Index(place.block) + 1, { { 0, 0, 0 }, {} });
      cellsInBlock.resize(blocks.size(), 0);
    }
    std::array<int, 3>& cells = blocks[Index(place.block)].cells;
    for (std::size_t i = 0; i < (isFlat ? 2U : 3U); ++i)
    {
      cells[i] = std::max(cells[i], place.index[i] + 1);
    }
    ++cellsInBlock[Index(place.block)];
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const std::array<int, 3>& cells = blocks[b].cells;
    const std::size_t layers = isFlat ? 1 : Index(cells[2]);
    if (cellsInBlock[b] == 0 || Index(cells[0]) * Index(cells[1]) * layers != cellsInBlock[b])
    {
      return {};
    }
    blocks[b].nodes.assign(Index(cells[0] + 1) * Index(cells[1] + 1) * Index(cells[2] + 1), -1);
  }
  std::vector<std::vector<std::size_t>> cellsOf(blocks.size());
  for (std::size_t cell = 0; cell < places.size(); ++cell)
  {
    cellsOf[Index(places[cell].block)].push_back(cell);
  }
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
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
}
