#include "CutBlocks.h"

#include "BlockFaces.h"
#include "MeshBlocks.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
constexpr int Directions = 3;

/// Calls a function with the four starts of the edges of a block along a direction.
template <class Function>
void ForEachEdge(const MeshBlock& block, int direction, const Function& function)
{
  const int first = (direction + 1) % Directions;
  const int second = (direction + 2) % Directions;
  for (int edge = 0; edge < 4; ++edge)
  {
    std::array<int, 3> start{};
    start[first] = edge % 2 == 0 ? 0 : block.cells[first];
    start[second] = edge / 2 == 0 ? 0 : block.cells[second];
    function(start);
  }
}

/// Cuts of blocks, which go on through their neighbours.
class BlockCuts
{
public:
  BlockCuts(const std::vector<MeshBlock>& blocks, std::size_t points)
    : Blocks(blocks)
    , IsVertex(points, false)
  {
    for (const MeshBlock& block : blocks)
    {
      this->Cuts.emplace_back();
      for (int d = 0; d < Directions; ++d)
      {
        this->Cuts.back()[d].resize(Index(block.cells[d] + 1), false);
      }
      for (int d = 0; d < Directions; ++d)
      {
        this->Add(this->Cuts.size() - 1, d, 0);
        this->Add(this->Cuts.size() - 1, d, block.cells[d]);
      }
    }
  }

  void Add(std::size_t block, int direction, int index)
  {
    this->Cuts[block][direction][index] = true;
    ForEachEdge(this->Blocks[block], direction,
      [&](std::array<int, 3> start)
      {
        start[direction] = index;
        this->IsVertex[this->Blocks[block].NodeAt(start)] = true;
      });
  }

  /// Cuts a block in the middle, or counts that it has too few cells for it.
  void Halve(std::size_t block, int direction)
  {
    const int cells = this->Blocks[block].cells[direction];
    if (cells < 2)
    {
      ++this->TooShort;
      return;
    }
    this->Add(block, direction, cells / 2);
    ++this->Halvings;
  }

  /// Cuts blocks where their neighbours are cut.
  void Spread()
  {
    for (bool isNew = true; isNew;)
    {
      isNew = false;
      for (std::size_t b = 0; b < this->Blocks.size(); ++b)
      {
        for (int d = 0; d < Directions; ++d)
        {
          ForEachEdge(this->Blocks[b], d,
            [&](std::array<int, 3> place)
            {
              for (int t = 1; t < this->Blocks[b].cells[d]; ++t)
              {
                place[d] = t;
                if (!this->Cuts[b][d][t] && this->IsVertex[this->Blocks[b].NodeAt(place)])
                {
                  this->Add(b, d, t);
                  isNew = true;
                }
              }
            });
        }
      }
    }
  }

  int CountHalvings() const { return this->Halvings; }
  int CountTooShort() const { return this->TooShort; }

  std::vector<MeshBlock> Pieces() const
  {
    std::vector<MeshBlock> pieces;
    for (std::size_t b = 0; b < this->Blocks.size(); ++b)
    {
      std::array<std::vector<int>, Directions> at;
      std::array<int, 3> last{};
      for (std::size_t d = 0; d < at.size(); ++d)
      {
        for (int t = 0; t <= this->Blocks[b].cells[d]; ++t)
        {
          if (this->Cuts[b][d][t])
          {
            at[d].push_back(t);
          }
        }
        last[d] = static_cast<int>(at[d].size()) - 2;
      }
      ForEachIndex({ 0, 0, 0 }, last,
        [&](const std::array<int, 3>& index)
        {
          std::array<int, 3> low{};
          std::array<int, 3> high{};
          for (std::size_t d = 0; d < at.size(); ++d)
          {
            low[d] = at[d][index[d]];
            high[d] = at[d][Index(index[d]) + 1];
          }
          pieces.push_back(Piece(this->Blocks[b], low, high));
        });
    }
    return pieces;
  }

private:
  static MeshBlock Piece(
    const MeshBlock& block, const std::array<int, 3>& low, const std::array<int, 3>& high)
  {
    MeshBlock piece{ { high[0] - low[0], high[1] - low[1], high[2] - low[2] }, {} };
    ForEachIndex(low, high,
      [&](const std::array<int, 3>& index) { piece.nodes.push_back(block.NodeAt(index)); });
    return piece;
  }

  const std::vector<MeshBlock>& Blocks;
  std::vector<std::array<std::vector<bool>, Directions>> Cuts;
  std::vector<bool> IsVertex;
  int Halvings = 0;
  int TooShort = 0;
};

/// Returns the largest length of an edge along a direction over its chord.
double CurvatureAlong(const SolverMesh& mesh, const MeshBlock& block, int direction)
{
  double largest = 1.0;
  ForEachEdge(block, direction,
    [&](const std::array<int, 3>& start)
    {
      const std::vector<int> nodes = EdgeNodes(block, direction, start);
      const auto distance = [&mesh](int a, int b)
      { return (mesh.points[a] - mesh.points[b]).norm(); };
      double length = 0.0;
      for (std::size_t i = 1; i < nodes.size(); ++i)
      {
        length += distance(nodes[i - 1], nodes[i]);
      }
      const double chord = distance(nodes.front(), nodes.back());
      largest = std::max(largest, chord > 0.0 ? length / chord : 1.0);
    });
  return largest;
}

/// Returns whether at a corner of a block the directions to its neighbours, or between their far ends where it
/// is on the axis of a revolution, are left-handed or in a plane: the hexahedron of the corners is folded.
bool IsFolded(const SolverMesh& mesh, const MeshBlock& block)
{
  for (int corner = 0; corner < 8; ++corner)
  {
    std::array<int, 3> place{};
    double sign = 1.0;
    for (int d = 0; d < Directions; ++d)
    {
      const bool isEnd = (corner >> d & 1) == 1;
      place[d] = isEnd ? block.cells[d] : 0;
      sign *= isEnd ? -1.0 : 1.0;
    }
    const Eigen::Vector3d& origin = mesh.points[block.NodeAt(place)];
    Eigen::Matrix3d edges;
    for (int d = 0; d < Directions; ++d)
    {
      std::array<int, 3> other = place;
      other[d] = block.cells[d] - place[d];
      edges.col(d) = mesh.points[block.NodeAt(other)] - origin;
    }
    const bool isOnAxis = edges.colwise().norm().minCoeff() == 0.0;
    if (!isOnAxis && sign * edges.determinant() <= 0.0)
    {
      return true;
    }
  }
  return false;
}

/// Cuts folded blocks in the middle, across the direction along which they are most curved.
void CutFoldedBlocks(const SolverMesh& mesh, const std::vector<MeshBlock>& blocks, BlockCuts& cuts)
{
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    if (!IsFolded(mesh, blocks[b]))
    {
      continue;
    }
    int direction = 0; // too short if all are
    double largest = 0.0;
    for (int d = 0; d < Directions; ++d)
    {
      const double curvature = CurvatureAlong(mesh, blocks[b], d);
      if (blocks[b].cells[d] > 1 && curvature > largest)
      {
        largest = curvature;
        direction = d;
      }
    }
    cuts.Halve(b, direction);
  }
}

/// Cuts edges in the middle whose ends are those of another edge or one node.
void CutAmbiguousEdges(const std::vector<MeshBlock>& blocks, BlockCuts& cuts)
{
  std::map<std::pair<int, int>, std::vector<int>> edges;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    for (int d = 0; d < Directions; ++d)
    {
      ForEachEdge(blocks[b], d,
        [&](const std::array<int, 3>& start)
        {
          std::vector<int> nodes = EdgeNodes(blocks[b], d, start);
          if (nodes.front() > nodes.back())
          {
            std::reverse(nodes.begin(), nodes.end());
          }
          const bool isPoint = std::count(nodes.begin(), nodes.end(), nodes[0]) ==
            static_cast<std::ptrdiff_t>(nodes.size()); // on the axis of a revolution
          if (isPoint)
          {
            return;
          }
          const auto [edge, isFirst] =
            edges.emplace(std::make_pair(nodes.front(), nodes.back()), nodes);
          if (nodes.front() == nodes.back() || (!isFirst && edge->second != nodes))
          {
            cuts.Halve(b, d);
          }
        });
    }
  }
}
}

std::vector<MeshBlock> CutBlocks(const SolverMesh& mesh, const MeshFaces& faces)
{
  if (mesh.blocks.empty())
  {
    return {};
  }
  BlockCuts first(mesh.blocks, mesh.points.size());
  for (const BlockPatch& patch : FindBlockFaces(mesh, faces).patches)
  {
    for (int d = 0; d < Directions; ++d)
    {
      first.Add(Index(patch.range.block), d, patch.range.begin[d]);
      first.Add(Index(patch.range.block), d, patch.range.end[d]);
    }
  }
  first.Spread();
  std::vector<MeshBlock> blocks = first.Pieces();
  constexpr int MostHalvings = 6; // a spiral of 32 turns; more are needed if cells are inverted
  for (int halving = 0;; ++halving)
  {
    BlockCuts cuts(blocks, mesh.points.size());
    CutAmbiguousEdges(blocks, cuts);
    CutFoldedBlocks(mesh, blocks, cuts);
    if (cuts.CountTooShort() > 0 || (cuts.CountHalvings() > 0 && halving == MostHalvings))
    {
      return {};
    }
    if (cuts.CountHalvings() == 0)
    {
      return blocks;
    }
    cuts.Spread();
    blocks = cuts.Pieces();
  }
}
}
