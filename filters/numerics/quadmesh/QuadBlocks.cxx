#include "QuadBlocks.h"

#include "Index.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// Divides a mesh by walls: sides of quads that separate blocks. Sides are numbered as in
/// QuadMesh::Twins.
class Cutter
{
public:
  explicit Cutter(const QuadMesh& mesh)
    : Mesh(mesh)
    , Twins(mesh.Twins())
    , Walls(4 * mesh.quads.size(), false)
    , Regular(mesh.points.size(), false)
    , Inside(mesh.points.size(), false)
  {
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      this->Inside[p] = mesh.points[p].curve.loop < 0;
      this->Regular[p] = mesh.points[p].valence == (this->Inside[p] ? 4 : 2);
    }
  }

  /// Marks the sides between quads of different regions and on interfaces, after a first Cut. Lines across
  /// annuli, which Cut adds, then lead through them.
  void AddWalls(const std::vector<int>& regions)
  {
    std::set<std::pair<int, int>> interfaces;
    for (const QuadBoundaryEdge& edge : this->Mesh.boundary)
    {
      if (edge.kind == BoundaryKind::Interface)
      {
        interfaces.insert(std::minmax(edge.points[0], edge.points[1]));
      }
    }
    std::vector<bool> isBetween(this->Twins.size(), false);
    for (std::size_t side = 0; side < this->Twins.size(); ++side)
    {
      const int twin = this->Twins[side];
      const int start = this->StartOf(static_cast<int>(side));
      const int end = this->EndOf(static_cast<int>(side));
      isBetween[side] = twin >= 0 &&
        (regions[side / 4] != regions[twin / 4] || interfaces.count(std::minmax(start, end)) > 0);
      this->Walls[side] = this->Walls[side] || isBetween[side];
    }
    for (std::size_t side = 0; side < this->Twins.size(); ++side)
    {
      const auto end = Index(this->EndOf(static_cast<int>(side)));
      if (isBetween[side] && this->Inside[end] && this->Regular[end] &&
        !this->Walls[this->Straight(static_cast<int>(side))])
      {
        this->Turning.push_back(end);
      }
    }
    for (const std::size_t point : this->Turning)
    {
      this->Regular[point] = false;
    }
  }

  QuadBlocks Cut()
  {
    for (int side = 0; side < static_cast<int>(this->Twins.size()); ++side)
    {
      if (this->Twins[side] < 0)
      {
        this->Walls[side] = true;
      }
      if (!this->Regular[this->StartOf(side)])
      {
        this->MarkLine(side);
      }
    }
    QuadBlocks result;
    const std::size_t count = this->Mesh.quads.size();
    result.block.assign(count, -1);
    result.i.assign(count, 0);
    result.j.assign(count, 0);
    this->Turns.assign(count, 0);
    for (int quad = 0; quad < static_cast<int>(count); ++quad)
    {
      while (result.block[quad] < 0 && !this->Fill(quad, result))
      {
      }
    }
    return result;
  }

private:
  int StartOf(int side) const { return this->Mesh.quads[side / 4][side % 4]; }
  int EndOf(int side) const { return this->Mesh.quads[side / 4][(side + 1) % 4]; }
  static int Next(int side) { return side / 4 * 4 + (side + 1) % 4; }
  /// Returns the side that leads on straight from the end of one, which is a regular point inside.
  int Straight(int side) const { return Next(this->Twins[Next(side)]); }

  /// Marks walls from a side on, straight through regular points, up to another wall along the
  /// line.
  void MarkLine(int side)
  {
    while (!this->Walls[side])
    {
      this->Walls[side] = true;
      this->Walls[this->Twins[side]] = true;
      const auto end = Index(this->EndOf(side));
      if (!this->Regular[end] || !this->Inside[end])
      {
        return;
      }
      side = this->Straight(side);
    }
  }

  /// Numbers the quads that no wall separates from one, as a new block. If they form an annulus,
  /// adds a wall across it and returns false.
  bool Fill(int first, QuadBlocks& result)
  {
    const auto block = static_cast<int>(result.blocks.size());
    std::vector<int> members = { first };
    result.block[first] = block;
    result.i[first] = 0;
    result.j[first] = 0;
    this->Turns[first] = 0;
    constexpr std::array<std::array<int, 2>, 4> Steps = { { { 0, -1 }, { 1, 0 }, { 0, 1 },
      { -1, 0 } } };
    bool closes = false;
    for (std::size_t next = 0; next < members.size(); ++next)
    {
      const int quad = members[next];
      for (int s = 0; s < 4; ++s)
      {
        const int side = 4 * quad + s;
        if (this->Walls[side])
        {
          continue;
        }
        const int twin = this->Twins[side];
        const int other = twin / 4;
        // Direction of the side in the block, 0 to 3: below, right, above, left.
        const int direction = (s + this->Turns[quad]) % 4;
        const int i = result.i[quad] + Steps[direction][0];
        const int j = result.j[quad] + Steps[direction][1];
        if (result.block[other] < 0)
        {
          result.block[other] = block;
          result.i[other] = i;
          result.j[other] = j;
          this->Turns[other] = (direction + 2 - twin % 4 + 4) % 4;
          members.push_back(other);
        }
        else
        {
          closes = closes || result.i[other] != i || result.j[other] != j;
        }
      }
    }
    if (closes)
    {
      this->CutAnnulus(members);
      for (const int quad : members)
      {
        result.block[quad] = -1;
      }
      return false;
    }
    this->AddBlock(members, result);
    return true;
  }

  /// Adds a wall across an annulus, starting at one of the walls along its sides, or one around a torus without
  /// walls.
  void CutAnnulus(const std::vector<int>& members)
  {
    for (const int quad : members)
    {
      for (int s = 0; s < 4; ++s)
      {
        const int across = 4 * quad + (s + 1) % 4;
        if (this->Walls[4 * quad + s] && !this->Walls[across])
        {
          this->MarkAcross(across);
          return;
        }
      }
    }
    this->MarkLine(4 * members.front());
  }

  /// Marks walls as MarkLine does, but stops at a crossing wall.
  void MarkAcross(int side)
  {
    while (!this->Walls[side])
    {
      this->Walls[side] = true;
      this->Walls[this->Twins[side]] = true;
      const int left = Next(side);
      if (this->Walls[left])
      {
        return;
      }
      side = Next(this->Twins[left]);
    }
  }

  void AddBlock(const std::vector<int>& members, QuadBlocks& result) const
  {
    constexpr int Far = std::numeric_limits<int>::max();
    std::array<int, 2> low = { Far, Far };
    std::array<int, 2> high = { -Far, -Far };
    for (const int quad : members)
    {
      low = { std::min(low[0], result.i[quad]), std::min(low[1], result.j[quad]) };
      high = { std::max(high[0], result.i[quad]), std::max(high[1], result.j[quad]) };
    }
    QuadBlock block;
    block.width = high[0] - low[0] + 1;
    block.height = high[1] - low[1] + 1;
    block.points.assign(Index(block.width + 1) * Index(block.height + 1), -1);
    for (const int quad : members)
    {
      const int i = result.i[quad] -= low[0];
      const int j = result.j[quad] -= low[1];
      // Corners of the block's cell, counter-clockwise from its lower left one.
      const std::array<std::array<int, 2>, 4> corners = { { { i, j }, { i + 1, j },
        { i + 1, j + 1 }, { i, j + 1 } } };
      for (int c = 0; c < 4; ++c)
      {
        const auto& at = corners[(c + this->Turns[quad]) % 4];
        block.points[Index(at[1]) * Index(block.width + 1) + Index(at[0])] =
          this->Mesh.quads[quad][c];
      }
    }
    result.blocks.push_back(std::move(block));
  }

  const QuadMesh& Mesh;
  std::vector<int> Twins;
  std::vector<bool> Walls;
  std::vector<bool> Regular;
  std::vector<bool> Inside;
  std::vector<std::size_t> Turning; ///< Regular points where lines between regions turn or end.
  std::vector<int> Turns; ///< Per quad: its side 0 is side `turn` of its cell in the block.
};
}

QuadBlocks FindBlocks(const QuadMesh& mesh)
{
  QuadBlocks blocks = Cutter(mesh).Cut();
  FindNeighbours(blocks.blocks);
  return blocks;
}

QuadBlocks FindBlocks(const QuadMesh& mesh, const std::vector<int>& regions)
{
  Cutter cutter(mesh);
  cutter.Cut();
  cutter.AddWalls(regions);
  QuadBlocks blocks = cutter.Cut();
  FindNeighbours(blocks.blocks);
  return blocks;
}
}
