#include "QuadMesh.h"

#include "Error.h"
#include "Parts.h"

#include <algorithm>
#include <numeric>

namespace crossfield
{
std::vector<int> QuadMesh::Twins() const
{
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  // 1. Sort sides by their smaller point: few sides share it.
  std::vector<int> starts(this->points.size() + 1, 0);
  for (const std::array<int, 4>& quad : this->quads)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const int from = quad[i];
      const int to = quad[(i + 1) % 4];
      if (from == to || from == quad[(i + 2) % 4])
      {
        throw Error("A quad near " + DescribePlace(this->points[index(from)].place) +
          " has a point twice; use a smaller size.");
      }
      ++starts[index(std::min(from, to)) + 1];
    }
  }
  std::partial_sum(starts.begin(), starts.end(), starts.begin());
  struct Side
  {
    int larger;
    int number;
  };
  std::vector<Side> sides(4 * this->quads.size());
  std::vector<int> ends(starts.begin(), starts.end() - 1);
  const auto pointAt = [&](int side) { return this->quads[index(side / 4)][index(side % 4)]; };
  const auto startOf = [&](int side) { return pointAt(side); };
  const auto endOf = [&](int side) { return pointAt(side / 4 * 4 + (side + 1) % 4); };
  for (int side = 0; side < static_cast<int>(sides.size()); ++side)
  {
    const auto [smaller, larger] = std::minmax({ startOf(side), endOf(side) });
    sides[index(ends[index(smaller)]++)] = { larger, side };
  }
  // 2. Match sides of the same edge, which have opposite directions.
  std::vector<int> twins(sides.size(), -1);
  const auto match = [&](std::size_t p)
  {
    for (int i = starts[p]; i < starts[p + 1]; ++i)
    {
      const Side& mine = sides[index(i)];
      for (int j = starts[p]; j < i; ++j)
      {
        const Side& other = sides[index(j)];
        if (other.larger != mine.larger)
        {
          continue;
        }
        if (twins[index(other.number)] >= 0 || twins[index(mine.number)] >= 0 ||
          startOf(mine.number) == startOf(other.number))
        {
          throw Error("An edge near " + DescribePlace(this->points[p].place) +
            " has more than two quads; use a smaller size.");
        }
        twins[index(mine.number)] = other.number;
        twins[index(other.number)] = mine.number;
      }
    }
  };
  ForRanges(static_cast<std::ptrdiff_t>(this->points.size()),
    [&](int begin, int end)
    {
      for (int p = begin; p < end; ++p)
      {
        match(index(p));
      }
    });
  return twins;
}

int QuadMesh::EulerCharacteristic() const
{
  const std::vector<int> twins = this->Twins();
  const auto onBoundary = std::count(twins.begin(), twins.end(), -1);
  const auto edges = (static_cast<std::ptrdiff_t>(twins.size()) + onBoundary) / 2;
  return static_cast<int>(static_cast<std::ptrdiff_t>(this->points.size()) - edges +
    static_cast<std::ptrdiff_t>(this->quads.size()));
}
}
