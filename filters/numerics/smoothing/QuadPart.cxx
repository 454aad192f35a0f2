#include "QuadPart.h"

#include "Index.h"
#include "NodePairs.h"
#include "Parts.h"
#include "PointCorners.h"
#include "QuadQuality.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns the number of rings of quads between every point and the nearest cone, periodic side or
/// inverted quad, at most `rings`.
std::vector<int> RingsOf(const QuadMesh& mesh, int rings)
{
  std::vector<int> ringOf(mesh.points.size(), rings);
  for (std::size_t p = 0; p < ringOf.size(); ++p)
  {
    ringOf[p] = mesh.points[p].quarterIndex != 0 ? 0 : rings;
  }
  for (const PairedSides& pair : mesh.periodic)
  {
    for (const auto& [first, second] : pair.nodes)
    {
      ringOf[first] = ringOf[second] = 0;
    }
  }
  std::vector<char> isInverted(mesh.quads.size());
  ForRanges(static_cast<std::ptrdiff_t>(mesh.quads.size()),
    [&](int begin, int end)
    {
      for (std::size_t q = Index(begin); q < Index(end); ++q)
      {
        isInverted[q] = ScaledJacobian(mesh, q) > 0.0 ? 0 : 1;
      }
    });
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4 && isInverted[q] != 0; ++c)
    {
      ringOf[mesh.quads[q][c]] = 0;
    }
  }
  std::vector<int> reached;
  for (std::size_t p = 0; p < ringOf.size(); ++p)
  {
    if (ringOf[p] == 0)
    {
      reached.push_back(static_cast<int>(p));
    }
  }
  const PointCorners corners(mesh);
  for (std::size_t next = 0; next < reached.size(); ++next)
  {
    const int p = reached[next];
    const int ring = ringOf[p] + 1;
    for (int i = corners.Begin(p); i < corners.Begin(p + 1) && ring < rings; ++i)
    {
      for (const int other : mesh.quads[corners.Get(i) / 4])
      {
        if (ring < ringOf[other])
        {
          ringOf[other] = ring;
          reached.push_back(other);
        }
      }
    }
  }
  return ringOf;
}
}

QuadPart::QuadPart(const QuadMesh& full, const std::vector<bool>& fullMoves, int rings)
{
  const std::vector<int> ringOf = RingsOf(full, rings);
  const auto isFree = [&](int p) { return ringOf[p] < rings && fullMoves[p]; };
  std::vector<int> number(full.points.size(), -1);
  for (std::size_t q = 0; q < full.quads.size(); ++q)
  {
    std::array<int, 4> quad = full.quads[q];
    if (std::none_of(quad.begin(), quad.end(), isFree))
    {
      continue;
    }
    for (int& p : quad)
    {
      int& mine = number[p];
      if (mine < 0)
      {
        mine = static_cast<int>(this->points.size());
        this->points.push_back(Index(p));
        this->mesh.points.push_back(full.points[p]);
        this->moves.push_back(isFree(p));
      }
      p = mine;
    }
    this->mesh.quads.push_back(quad);
    this->mesh.targetLengths.push_back(full.targetLengths[q]);
  }
  for (const int single : CopyPairs(full, number, this->mesh))
  {
    this->moves[single] = false;
  }
  MovePairsTogether(this->mesh, this->moves);
}

void QuadPart::CopyPoints(QuadMesh& full) const
{
  for (std::size_t p = 0; p < this->points.size(); ++p)
  {
    full.points[this->points[p]] = this->mesh.points[p];
  }
}
}
