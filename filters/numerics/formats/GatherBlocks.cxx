#include "GatherBlocks.h"

#include "BlockLattice.h"
#include "CellLattice.h"
#include "Index.h"

#include <algorithm>

namespace crossfield
{
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
  const CellLattice lattice(mesh.dimension, mesh.order);
  for (std::size_t cell = 0; cell < places.size(); ++cell)
  {
    ExportBlock& block = blocks[Index(places[cell].block)];
    for (int corner = 0; corner < (isFlat ? 4 : 8); ++corner)
    {
      std::array<int, 3> index = places[cell].index;
      index[0] += corner % 4 == 1 || corner % 4 == 2 ? 1 : 0;
      index[1] += corner % 4 >= 2 ? 1 : 0;
      index[2] += corner >= 4 ? 1 : 0;
      int& node = block.nodes[BlockPoint(block, index)];
      const int point = mesh.Cell(static_cast<int>(cell))[lattice.Corner(corner)];
      if (node >= 0 && node != point)
      {
        return {};
      }
      node = point;
    }
  }
  const auto isComplete = [](const ExportBlock& block)
  { return std::find(block.nodes.begin(), block.nodes.end(), -1) == block.nodes.end(); };
  return std::all_of(blocks.begin(), blocks.end(), isComplete) ? blocks
                                                               : std::vector<ExportBlock>();
}
}
