#include "GrowthLimit.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace crossfield
{
namespace
{
/// Returns min over t in [0, 1] of (1 − t) atFrom + t atTo + growth |place − (from + t (to − from))|.
double LowestAcross(
  const Point& place, const Point& from, const Point& to, double atFrom, double atTo, double growth)
{
  const double throughFrom = atFrom + growth * (place - from).norm();
  const double throughTo = atTo + growth * (place - to).norm();
  const double ends = std::min(throughFrom, throughTo);
  const double length = (to - from).norm();
  const double slope = (atTo - atFrom) / (growth * length); // NaN or infinite if a value is
  if (!(std::abs(slope) < 1.0))
  {
    return ends;
  }
  const Point direction = (to - from) / length;
  const double along = direction.dot(place - from);
  const double height = std::abs(Cross(direction, place - from));
  const double foot = along - height * slope / std::sqrt(1.0 - slope * slope);
  if (!(foot > 0.0 && foot < length))
  {
    return ends;
  }
  return std::min(ends, atFrom + growth * (slope * foot + std::hypot(along - foot, height)));
}
}

Eigen::VectorXd LimitGrowth(
  const MeshTopology& topology, const Eigen::VectorXd& values, double growth)
{
  const std::vector<std::array<int, 3>>& triangles = topology.mesh.triangles;
  std::vector<std::vector<int>> around(static_cast<std::size_t>(values.size()));
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (const int vertex : triangles[t])
    {
      around[static_cast<std::size_t>(vertex)].push_back(static_cast<int>(t));
    }
  }
  Eigen::VectorXd limited = values;
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> next;
  for (Eigen::Index v = 0; v < values.size(); ++v)
  {
    if (std::isfinite(values[v]))
    {
      next.emplace(values[v], static_cast<int>(v));
    }
  }
  // Of the growth along a side: less is rounding, which would pass between two vertices for ever.
  constexpr double Noticeable = 1e-9;
  while (!next.empty())
  {
    const auto [value, vertex] = next.top();
    next.pop();
    if (value > limited[vertex])
    {
      continue;
    }
    for (const int t : around[static_cast<std::size_t>(vertex)])
    {
      const std::array<int, 3>& corners = triangles[static_cast<std::size_t>(t)];
      const int known =
        static_cast<int>(std::find(corners.begin(), corners.end(), vertex) - corners.begin());
      for (const int turn : { 1, 2 })
      {
        const int other = (known + turn) % 3;
        const int opposite = (known + 3 - turn) % 3;
        const Point& place = topology.At(t, opposite);
        const double lowest = LowestAcross(place, topology.At(t, known), topology.At(t, other),
          value, limited[corners[static_cast<std::size_t>(other)]], growth);
        double& present = limited[corners[static_cast<std::size_t>(opposite)]];
        if (lowest < present - Noticeable * growth * (place - topology.At(t, known)).norm())
        {
          present = lowest;
          next.emplace(lowest, corners[static_cast<std::size_t>(opposite)]);
        }
      }
    }
  }
  return limited;
}
}
