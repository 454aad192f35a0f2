#include "QuadPart.h"

#include "Index.h"
#include "QuadQuality.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Rings of quads between every point and the nearest cone or inverted quad; `rings` where there are as many.
std::vector<int> RingsOf(const QuadMesh& mesh, int rings)
{
  std::vector<int> ringOf(mesh.points.size(), rings);
  for (std::size_t p = 0; p < ringOf.size(); ++p)
  {
    ringOf[p] = mesh.points[p].asked != 0 ? 0 : rings;
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

QuadPart::QuadPart(const QuadMesh& whole, const std::vector<bool>& wholeMoves, int rings)
{
  const std::vector<int> ringOf = RingsOf(whole, rings);
  const auto isFree = [&](int p) { return ringOf[Index(p)] < rings && wholeMoves[Index(p)]; };
  std::vector<int> number(whole.points.size(), -1);
  for (std::size_t q = 0; q < whole.quads.size(); ++q)
  {
    std::array<int, 4> quad = whole.quads[q];
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
        this->mesh.points.push_back(whole.points[Index(p)]);
        this->moves.push_back(isFree(p));
      }
      p = mine;
    }
    this->mesh.quads.push_back(quad);
    this->mesh.wanted.push_back(whole.wanted[q]);
  }
}

void QuadPart::PutBack(QuadMesh& whole) const
{
  for (std::size_t p = 0; p < this->points.size(); ++p)
  {
    whole.points[this->points[p]] = this->mesh.points[p];
  }
}
}
