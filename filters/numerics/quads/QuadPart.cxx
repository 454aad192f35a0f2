#include "QuadPart.h"

#include "Index.h"
#include "NodePairs.h"
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
  for (const PeriodicPoints& points : mesh.periodic)
  {
    for (const auto& [first, second] : points.pairs)
    {
      ringOf[Index(first)] = ringOf[Index(second)] = 0;
    }
  }
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    for (std::size_t c = 0; c < 4 && !(ScaledJacobian(mesh, q) > 0.0); ++c)
    {
      ringOf[Index(mesh.quads[q][c])] = 0;
    }
  }
  for (int ring = 1; ring < rings; ++ring)
  {
    for (const std::array<int, 4>& quad : mesh.quads)
    {
      const bool reached =
        std::any_of(quad.begin(), quad.end(), [&](int p) { return ringOf[Index(p)] == ring - 1; });
      for (std::size_t c = 0; reached && c < 4; ++c)
      {
        ringOf[Index(quad[c])] = std::min(ringOf[Index(quad[c])], ring);
      }
    }
  }
  return ringOf;
}
}

QuadPart::QuadPart(const QuadMesh& full, const std::vector<bool>& fullMoves, int rings)
{
  const std::vector<int> ringOf = RingsOf(full, rings);
  const auto isFree = [&](int p) { return ringOf[Index(p)] < rings && fullMoves[Index(p)]; };
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
      int& mine = number[Index(p)];
      if (mine < 0)
      {
        mine = static_cast<int>(this->points.size());
        this->points.push_back(Index(p));
        this->mesh.points.push_back(full.points[Index(p)]);
        this->moves.push_back(isFree(p));
      }
      p = mine;
    }
    this->mesh.quads.push_back(quad);
    this->mesh.targetLengths.push_back(full.targetLengths[q]);
  }
  for (const int single : CopyPairs(full, number, this->mesh))
  {
    this->moves[Index(single)] = false;
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
