#include "CutBlocks.h"

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
    start[Index(first)] = edge % 2 == 0 ? 0 : block.cells[Index(first)];
    start[Index(second)] = edge / 2 == 0 ? 0 : block.cells[Index(second)];
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
        this->Cuts.back()[Index(d)].resize(Index(block.cells[Index(d)] + 1), false);
      }
      for (int d = 0; d < Directions; ++d)
      {
        this->Add(this->Cuts.size() - 1, d, 0);
        this->Add(this->Cuts.size() - 1, d, block.cells[Index(d)]);
      }
    }
  }

  void Add(std::size_t block, int direction, int index)
  {
    this->Cuts[block][Index(direction)][Index(index)] = true;
    ForEachEdge(this->Blocks[block], direction,
      [&](std::array<int, 3> start)
      {
        start[Index(direction)] = index;
        this->IsVertex[Index(this->Blocks[block].NodeAt(start))] = true;
      });
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
              for (int t = 1; t < this->Blocks[b].cells[Index(d)]; ++t)
              {
                place[Index(d)] = t;
                if (!this->Cuts[b][Index(d)][Index(t)] &&
                  this->IsVertex[Index(this->Blocks[b].NodeAt(place))])
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

  std::vector<MeshBlock> Pieces() const
  {
    std::vector<MeshBlock> pieces;
    for (std::size_t b = 0; b < this->Blocks.size(); ++b)
    {
      std::array<std::vector<int>, Directions> at;
      for (std::size_t d = 0; d < at.size(); ++d)
      {
        for (int t = 0; t <= this->Blocks[b].cells[d]; ++t)
        {
          if (this->Cuts[b][d][Index(t)])
          {
            at[d].push_back(t);
          }
        }
      }
      for (std::size_t k = 0; k + 1 < at[2].size(); ++k)
      {
        for (std::size_t j = 0; j + 1 < at[1].size(); ++j)
        {
          for (std::size_t i = 0; i + 1 < at[0].size(); ++i)
          {
            pieces.push_back(Piece(this->Blocks[b], { at[0][i], at[1][j], at[2][k] },
              { at[0][i + 1], at[1][j + 1], at[2][k + 1] }));
          }
        }
      }
    }
    return pieces;
  }

private:
  static MeshBlock Piece(
    const MeshBlock& block, const std::array<int, 3>& low, const std::array<int, 3>& high)
  {
    MeshBlock piece{ { high[0] - low[0], high[1] - low[1], high[2] - low[2] }, {} };
    for (int k = low[2]; k <= high[2]; ++k)
    {
      for (int j = low[1]; j <= high[1]; ++j)
      {
        for (int i = low[0]; i <= high[0]; ++i)
        {
          piece.nodes.push_back(block.NodeAt({ i, j, k }));
        }
      }
    }
    return piece;
  }

  const std::vector<MeshBlock>& Blocks;
  std::vector<std::array<std::vector<bool>, Directions>> Cuts;
  std::vector<bool> IsVertex;
};

/// Cuts blocks where the side changes along one of their faces.
void CutAtSides(
  const std::vector<MeshBlock>& blocks, const MeshFaces& faces, int directions, BlockCuts& cuts)
{
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    const MeshBlock& block = blocks[b];
    for (int d = 0; d < 2 * directions; ++d)
    {
      const int normal = d / 2;
      const int first = (normal + 1) % Directions;
      const int second = (normal + 2) % Directions;
      std::array<int, 3> place{};
      place[Index(normal)] = d % 2 == 0 ? 0 : block.cells[Index(normal)];
      const auto sideAt = [&](int a, int c)
      {
        std::array<int, 4> corners{};
        for (int corner = 0; corner < 4; ++corner)
        {
          place[Index(first)] = a + (corner == 1 || corner == 2 ? 1 : 0);
          place[Index(second)] = c + corner / 2;
          corners[Index(corner)] = block.NodeAt(place);
        }
        return faces.SideOf(MeshFaces::MakeKey(corners.data(), corners.size()));
      };
      std::vector<int> before;
      for (int a = 0; a < block.cells[Index(first)]; ++a)
      {
        std::vector<int> row;
        for (int c = 0; c < block.cells[Index(second)]; ++c)
        {
          row.push_back(sideAt(a, c));
          if (c > 0 && row[Index(c)] != row[Index(c - 1)])
          {
            cuts.Add(b, second, c);
          }
        }
        if (a > 0 && row != before)
        {
          cuts.Add(b, first, a);
        }
        before = row;
      }
    }
  }
}

/// Returns the largest length of an edge along a direction over its chord.
double CurvatureAlong(const SolverMesh& mesh, const MeshBlock& block, int direction)
{
  double largest = 1.0;
  ForEachEdge(block, direction,
    [&](const std::array<int, 3>& start)
    {
      const std::vector<int> nodes = EdgeNodes(block, direction, start);
      const auto distance = [&mesh](int a, int b)
      { return (mesh.points[Index(a)] - mesh.points[Index(b)]).norm(); };
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
      place[Index(d)] = isEnd ? block.cells[Index(d)] : 0;
      sign *= isEnd ? -1.0 : 1.0;
    }
    const Eigen::Vector3d& origin = mesh.points[Index(block.NodeAt(place))];
    Eigen::Matrix3d edges;
    for (int d = 0; d < Directions; ++d)
    {
      std::array<int, 3> other = place;
      other[Index(d)] = block.cells[Index(d)] - place[Index(d)];
      edges.col(d) = mesh.points[Index(block.NodeAt(other))] - origin;
    }
    const bool isOnAxis = edges.colwise().norm().minCoeff() == 0.0;
    if (!isOnAxis && sign * edges.determinant() <= 0.0)
    {
      return true;
    }
  }
  return false;
}

/// Cuts folded blocks in the middle, across the direction along which they are most curved. Returns and sets the
/// same as CutAmbiguousEdges.
int CutFoldedBlocks(
  const SolverMesh& mesh, const std::vector<MeshBlock>& blocks, BlockCuts& cuts, bool& isNew)
{
  int tooShort = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    if (!IsFolded(mesh, blocks[b]))
    {
      continue;
    }
    int direction = -1;
    double largest = 0.0;
    for (int d = 0; d < Directions; ++d)
    {
      const double curvature = CurvatureAlong(mesh, blocks[b], d);
      if (blocks[b].cells[Index(d)] > 1 && curvature > largest)
      {
        largest = curvature;
        direction = d;
      }
    }
    if (direction < 0)
    {
      ++tooShort;
      continue;
    }
    cuts.Add(b, direction, blocks[b].cells[Index(direction)] / 2);
    isNew = true;
  }
  return tooShort;
}

/// Cuts edges in the middle whose ends are those of another edge or one node. Returns the number of
/// edges that are too short for it, and sets `isNew` if there are cuts.
int CutAmbiguousEdges(const std::vector<MeshBlock>& blocks, BlockCuts& cuts, bool& isNew)
{
  std::map<std::pair<int, int>, std::vector<int>> edges;
  int tooShort = 0;
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
          if (nodes.front() != nodes.back() && (isFirst || edge->second == nodes))
          {
            return;
          }
          const int cells = blocks[b].cells[Index(d)];
          if (cells < 2)
          {
            ++tooShort;
            return;
          }
          cuts.Add(b, d, cells / 2);
          isNew = true;
        });
    }
  }
  return tooShort;
}
}

std::vector<MeshBlock> CutBlocks(const SolverMesh& mesh, const MeshFaces& faces)
{
  if (mesh.blocks.empty())
  {
    return {};
  }
  BlockCuts first(mesh.blocks, mesh.points.size());
  // The ends of a sweep are sides as a whole.
  CutAtSides(mesh.blocks, faces, mesh.sweep.layers > 0 ? 2 : Directions, first);
  first.Spread();
  std::vector<MeshBlock> blocks = first.Pieces();
  constexpr int MostHalvings = 6; // a spiral of 32 turns; more are needed if cells are inverted
  bool isNew = true;
  for (int halving = 0; isNew; ++halving)
  {
    BlockCuts cuts(blocks, mesh.points.size());
    isNew = false;
    const int tooShort =
      CutAmbiguousEdges(blocks, cuts, isNew) + CutFoldedBlocks(mesh, blocks, cuts, isNew);
    if (tooShort > 0 || (isNew && halving == MostHalvings))
    {
      return {};
    }
    cuts.Spread();
    blocks = cuts.Pieces();
  }
  return blocks;
}
}
