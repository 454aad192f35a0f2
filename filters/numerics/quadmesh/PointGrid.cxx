#include "PointGrid.h"

#include "Index.h"
#include "Parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

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
      const double reach = ReachPart * (mesh.points[from].place - mesh.points[to].place).norm();
      this->Reach[from] = std::min(this->Reach[from], reach);
      this->Reach[to] = std::min(this->Reach[to], reach);
    }
  }
  for (const double reach : this->Reach)
  {
    longest = std::max(longest, reach);
  }
  // Cells may be larger than the search radius. There are no more columns of them than points, also
  // where all edges in one direction are tiny.
  double left = std::numeric_limits<double>::infinity();
  double right = -left;
  for (const QuadPoint& point : mesh.points)
  {
    left = std::min(left, point.place.x());
    right = std::max(right, point.place.x());
  }
  this->Cell = mesh.points.empty()
    ? 1.0
    : std::max(longest, (right - left) / static_cast<double>(mesh.points.size()));
  std::vector<std::array<long long, 2>> cells(mesh.points.size());
  ForRanges(static_cast<std::ptrdiff_t>(cells.size()),
    [&](int begin, int end)
    {
      for (std::size_t p = Index(begin); p < Index(end); ++p)
      {
        cells[p] = this->CellOf(mesh.points[p].place);
      }
    });
  const auto [first, last] = std::minmax_element(cells.begin(), cells.end());
  this->FirstColumn = cells.empty() ? 0 : (*first)[0];
  const auto columns = cells.empty() ? 0 : static_cast<std::size_t>((*last)[0] - (*first)[0] + 1);
  this->Columns.assign(columns + 1, 0);
  const auto columnOf = [&](std::size_t p)
  { return static_cast<std::size_t>(cells[p][0] - this->FirstColumn); };
  for (std::size_t p = 0; p < cells.size(); ++p)
  {
    ++this->Columns[columnOf(p) + 1];
  }
  std::partial_sum(this->Columns.begin(), this->Columns.end(), this->Columns.begin());
  std::vector<int> next(this->Columns.begin(), this->Columns.end() - 1);
  this->Cells.resize(cells.size());
  for (std::size_t p = 0; p < cells.size(); ++p)
  {
    this->Cells[next[columnOf(p)]++] = { cells[p][1], static_cast<int>(p) };
  }
  const auto perColumn = static_cast<std::ptrdiff_t>(1 + cells.size() / (columns + 1));
  ForRanges(
    static_cast<std::ptrdiff_t>(columns),
    [&](int begin, int end)
    {
      for (int c = begin; c < end; ++c)
      {
        std::sort(
          this->Cells.begin() + this->Columns[c], this->Cells.begin() + this->Columns[c + 1]);
      }
    },
    std::max<std::ptrdiff_t>(1, MinimumPartSize / perColumn));
}

int PointGrid::Find(const Point& place, int p) const
{
  const std::array<long long, 2> cell = this->CellOf(place);
  int best = -1;
  double nearest = this->Reach[p];
  const auto columns = static_cast<long long>(this->Columns.size()) - 1;
  for (long long i = std::max(cell[0] - 1 - this->FirstColumn, 0LL);
       i < std::min(cell[0] + 2 - this->FirstColumn, columns); ++i)
  {
    const Entry first = { cell[1] - 1, -1 };
    const auto column = static_cast<std::size_t>(i);
    const auto end = this->Cells.begin() + this->Columns[column + 1];
    for (auto at = std::lower_bound(this->Cells.begin() + this->Columns[column], end, first);
         at != end && at->first <= cell[1] + 1; ++at)
    {
      const double distance = (this->Mesh.points[at->second].place - place).norm();
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
  return ReachPart * (this->Mesh.points[p].place - place).norm() / this->Reach[p];
}

std::array<long long, 2> PointGrid::CellOf(const Point& place) const
{
  return { std::llround(place.x() / this->Cell), std::llround(place.y() / this->Cell) };
}
}
