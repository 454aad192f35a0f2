#include "PointGrid.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Search radius over the shortest edge of a point.
constexpr double ReachPart = 0.4;
}

PointGrid::PointGrid(const QuadMesh& mesh)
  : Mesh(mesh)
  , Reach(mesh.points.size(), std::numeric_limits<double>::infinity())
{
  double longest = 0.0;
  for (const std::array<int, 4>& quad : mesh.quads)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      const int from = quad[c];
      const int to = quad[(c + 1) % 4];
      const double reach =
        ReachPart * (mesh.points[Index(from)].place - mesh.points[Index(to)].place).norm();
      this->Reach[Index(from)] = std::min(this->Reach[Index(from)], reach);
      this->Reach[Index(to)] = std::min(this->Reach[Index(to)], reach);
    }
  }
  for (const double reach : this->Reach)
  {
    longest = std::max(longest, reach);
  }
  this->Cell = longest;
  this->Cells.reserve(mesh.points.size());
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    this->Cells.push_back({ this->CellOf(mesh.points[p].place), static_cast<int>(p) });
  }
  std::sort(this->Cells.begin(), this->Cells.end());
}

int PointGrid::Find(const Point& place, int p) const
{
  const std::array<long long, 2> cell = this->CellOf(place);
  int best = -1;
  double nearest = this->Reach[Index(p)];
  for (long long i = cell[0] - 1; i <= cell[0] + 1; ++i)
  {
    const Entry first = { { i, cell[1] - 1 }, -1 };
    for (auto at = std::lower_bound(this->Cells.begin(), this->Cells.end(), first);
         at != this->Cells.end() && at->first[0] == i && at->first[1] <= cell[1] + 1; ++at)
    {
      const double distance = (this->Mesh.points[Index(at->second)].place - place).norm();
      if (distance < nearest)
      {
        nearest = distance;
        best = at->second;
      }
    }
  }
  return best;
}

double PointGrid::EdgesBetween(const Point& place, int p) const
{
  return ReachPart * (this->Mesh.points[Index(p)].place - place).norm() / this->Reach[Index(p)];
}

std::array<long long, 2> PointGrid::CellOf(const Point& place) const
{
  return { std::llround(place.x() / this->Cell), std::llround(place.y() / this->Cell) };
}
}
