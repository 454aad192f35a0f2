#include "CoarseBoundary.h"

#include "Error.h"
#include "LoopTurning.h"
#include "MakePlanarDomain.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Maximum distance of removed vertices from the new sides, relative to the maximum length of a
/// side.
constexpr double RelativeDeviation = 1e-3;

/// Marks the vertices that must not be removed.
std::vector<bool> FindFixed(
  const Loop& loop, double cornerAngle, const std::vector<CornerChoice>& keep, double reach)
{
  const std::size_t count = loop.size();
  std::vector<bool> fixed(count, false);
  fixed[0] = true;
  for (std::size_t i = 0; i < count; ++i)
  {
    if (IsCorner(TurningAt(loop, i), cornerAngle))
    {
      fixed[i] = fixed[(i + 1) % count] = fixed[(i + count - 1) % count] = true;
    }
    if (std::any_of(keep.begin(), keep.end(),
          [&](const CornerChoice& choice) { return (choice.position - loop[i]).norm() <= reach; }))
    {
      fixed[i] = true;
    }
  }
  return fixed;
}

/// Returns whether the vertices between two vertices of a loop are close to the side that joins
/// these two.
bool IsNear(const Loop& loop, std::size_t from, std::size_t to, double deviation)
{
  const Point side = loop[to % loop.size()] - loop[from];
  const double length = side.norm();
  for (std::size_t i = from + 1; i < to; ++i)
  {
    const Point there = loop[i] - loop[from];
    const double along = there.dot(side);
    if (along < 0.0 || along > length * length || std::abs(Cross(side, there)) > deviation * length)
    {
      return false;
    }
  }
  return true;
}

Loop Coarsen(const Loop& loop, const std::vector<bool>& fixed, double length, double cornerAngle)
{
  Loop coarse;
  for (std::size_t from = 0; from < loop.size();)
  {
    coarse.push_back(loop[from]);
    std::size_t to = from + 1;
    double turn = 0.0;
    while (to < loop.size() && !fixed[to])
    {
      turn += std::abs(TurningAt(loop, to));
      if ((loop[(to + 1) % loop.size()] - loop[from]).norm() > length || turn > 0.5 * cornerAngle ||
        !IsNear(loop, from, to + 1, RelativeDeviation * length))
      {
        break;
      }
      ++to;
    }
    from = to;
  }
  return coarse;
}
}

PlanarDomain CoarsenBoundary(const PlanarDomain& domain, double length, double cornerAngle,
  const std::vector<CornerChoice>& keep)
{
  PlanarDomain coarse;
  for (const Loop& loop : domain.loops)
  {
    const std::vector<bool> fixed =
      FindFixed(loop, cornerAngle, keep, BoundaryReach * domain.Diagonal());
    coarse.loops.push_back(Coarsen(loop, fixed, length, cornerAngle));
  }
  try
  {
    MakePlanarDomain(coarse.loops); // throws if the loops touch
  }
  catch (const Error&)
  {
    return domain;
  }
  return coarse;
}
}
