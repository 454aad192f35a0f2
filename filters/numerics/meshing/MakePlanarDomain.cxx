#include "MakePlanarDomain.h"

#include "CanonicalFrame.h"
#include "DomainExtent.h"
#include "Error.h"
#include "PlanarMesher.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield
{
namespace
{
/// Order of points by the coordinates of a domain's frame, first x, then y. It does not depend on
/// the placement of the domain.
class PointOrder
{
public:
  explicit PointOrder(const std::vector<Loop>& loops)
    : Frame(loops)
    , Unit(Rounding * BoundingDiagonal(this->Frame.ToFrame(loops)))
  {
  }

  bool operator()(const Point& a, const Point& b) const { return this->KeyOf(a) < this->KeyOf(b); }

private:
  /// Coordinates relative to the diagonal are equal if they differ by rounding errors.
  static constexpr double Rounding = 1e-9;

  std::array<double, 2> KeyOf(const Point& point) const
  {
    const Point coordinates = this->Frame.ToFrame(point);
    // The shift keeps coordinates with few digits away from the bounds of the intervals.
    const auto round = [this](double x) { return std::floor(x / this->Unit + 0.3); };
    return { round(coordinates.x()), round(coordinates.y()) };
  }

  CanonicalFrame Frame;
  double Unit;
};
}

void RequireLoops(const std::vector<Loop>& loops)
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
}

PlanarDomain MakePlanarDomain(std::vector<Loop> loops)
{
  RequireLoops(loops);
  const std::vector<int> depths = NestingDepths(loops);
  const auto parts =
    std::count_if(depths.begin(), depths.end(), [](int depth) { return depth % 2 == 0; });
  if (parts > 1)
  {
    const bool hasNested = *std::max_element(depths.begin(), depths.end()) > 1;
    throw Error(std::string(hasNested ? "An inner loop lies inside another one, so the domain has "
                                      : "The domain has several outer loops, so it has ") +
      std::to_string(parts) +
      " parts; choose one (Part of Boundary Simplifier, --part: largest, or a number from 1 for the "
      "largest).");
  }
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    Loop& loop = loops[i];
    if ((SignedArea(loop) > 0.0) != (depths[i] == 0))
    {
      std::reverse(loop.begin(), loop.end());
    }
  }
  const auto outer = std::find(depths.begin(), depths.end(), 0) - depths.begin();
  std::rotate(loops.begin(), loops.begin() + outer, loops.begin() + outer + 1);
  const PointOrder isBefore(loops);
  for (Loop& loop : loops)
  {
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end(), isBefore), loop.end());
  }
  std::sort(loops.begin() + 1, loops.end(),
    [&](const Loop& a, const Loop& b) { return isBefore(a.front(), b.front()); });
  return PlanarDomain{ std::move(loops) };
}
}
