#pragma once

#include "Plane.h"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace crossfield
{
/// Numbers of points in square cells, to find those near a place.
class EndGrid
{
public:
  /// `reach` is the size of the cells.
  explicit EndGrid(double reach)
    : Reach(reach)
  {
  }

  void Add(const Point& place, std::size_t number)
  {
    this->Cells[this->CellOf(place)].push_back(number);
  }

  /// Returns the numbers of all points within `reach` of a place, and of others nearby.
  std::vector<std::size_t> Near(const Point& place) const
  {
    std::vector<std::size_t> found;
    const Cell cell = this->CellOf(place);
    for (double x = -1.0; x <= 1.0; x += 1.0)
    {
      for (double y = -1.0; y <= 1.0; y += 1.0)
      {
        const auto at = this->Cells.find({ cell.first + x, cell.second + y });
        if (at != this->Cells.end())
        {
          found.insert(found.end(), at->second.begin(), at->second.end());
        }
      }
    }
    return found;
  }

private:
  using Cell = std::pair<double, double>; // whole numbers that may exceed those of integers

  Cell CellOf(const Point& place) const
  {
    return { std::floor(place.x() / this->Reach), std::floor(place.y() / this->Reach) };
  }

  double Reach;
  std::map<Cell, std::vector<std::size_t>> Cells;
};
}
