#include "MakePlanarDomain.h"

#include "DomainExtent.h"
#include "Error.h"
#include "PlanarMesher.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace crossfield
{
namespace
{
bool Before(const Point& a, const Point& b)
{
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}
}

PlanarDomain MakePlanarDomain(std::vector<Loop> loops)
{
  if (loops.empty())
  {
    throw Error("The domain has no boundary; give closed curves or a triangle mesh.");
  }
  for (const Loop& loop : loops)
  {
    if (loop.size() < 3)
    {
      throw Error("A boundary loop has fewer than three points; it encloses nothing.");
    }
    if (!std::all_of(loop.begin(), loop.end(), [](const Point& p) { return p.allFinite(); }))
    {
      throw Error("The boundary has a point whose coordinates are not finite numbers; remove it.");
    }
  }
  Eigen::AlignedBox2d box;
  for (const Loop& loop : loops)
  {
    for (const Point& point : loop)
    {
      box.extend(point);
    }
  }
  // the square of an extent beyond the bounds may be zero or infinite
  RequireExtent(box.sizes().maxCoeff());
  const std::vector<int> depths = NestingDepths(loops);
  if (std::count(depths.begin(), depths.end(), 0) > 1)
  {
    throw Error("The domain has several outer loops; give each connected part on its own.");
  }
  if (*std::max_element(depths.begin(), depths.end()) > 1)
  {
    throw Error("An inner loop lies inside another one, so the domain is not connected; give each "
                "connected part on its own.");
  }
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    Loop& loop = loops[i];
    if ((SignedArea(loop) > 0.0) != (depths[i] == 0))
    {
      std::reverse(loop.begin(), loop.end());
    }
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), Before), loop.end());
  }
  const auto outer = std::find(depths.begin(), depths.end(), 0) - depths.begin();
  std::rotate(loops.begin(), loops.begin() + outer, loops.begin() + outer + 1);
  std::sort(loops.begin() + 1, loops.end(),
    [](const Loop& a, const Loop& b) { return Before(a.front(), b.front()); });
  return PlanarDomain{ std::move(loops) };
}
}
