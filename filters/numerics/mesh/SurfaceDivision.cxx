#include "SurfaceDivision.h"

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield
{
SurfaceMesh Divided(const SurfaceMesh& surface)
{
  SurfaceMesh divided;
  divided.points = surface.points;
  std::map<std::pair<int, int>, int> middles;
  const auto middleOf = [&](int from, int to)
  {
    const auto [found, isNew] =
      middles.emplace(std::minmax({ from, to }), static_cast<int>(divided.points.size()));
    if (isNew)
    {
      divided.points.push_back(0.5 * (surface.points[from] + surface.points[to]));
    }
    return found->second;
  };
  for (const std::array<int, 3>& v : surface.triangles)
  {
    const std::array<int, 3> m = { middleOf(v[0], v[1]), middleOf(v[1], v[2]),
      middleOf(v[2], v[0]) };
    divided.triangles.insert(divided.triangles.end(),
      { { v[0], m[0], m[2] }, { v[1], m[1], m[0] }, { v[2], m[2], m[1] }, m });
  }
  return divided;
}
}
