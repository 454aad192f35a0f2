#include "HilbertOrder.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdint>
#include <utility>

namespace crossfield
{
namespace
{
constexpr int Levels = 20;

/// The number of a cell along the curve: of each quarter that it is in, from the largest on, the curve goes through the four in the order
/// (0, 0), (0, 1), (1, 1), (1, 0), mirrored in the first and in the last.
std::uint64_t AlongCurve(std::uint32_t x, std::uint32_t y)
{
  std::uint64_t number = 0;
  for (int level = Levels - 1; level >= 0; --level)
  {
    const std::uint32_t right = (x >> level) & 1u;
    const std::uint32_t upper = (y >> level) & 1u;
    number = 4u * number + ((3u * right) ^ upper);
    if (upper == 0)
    {
      const std::uint32_t flip = right != 0 ? ~std::uint32_t(0) : 0u;
      std::swap(x, y);
      x ^= flip;
      y ^= flip;
    }
  }
  return number;
}
}

std::vector<int> HilbertOrder(const std::vector<Point>& points)
{
  Eigen::AlignedBox2d box;
  for (const Point& point : points)
  {
    box.extend(point);
  }
  constexpr double Cells = 1 << Levels;
  const double perLength = Cells / box.sizes().maxCoeff();
  const auto cell = [perLength](double coordinate)
  { return static_cast<std::uint32_t>(std::clamp(coordinate * perLength, 0.0, Cells - 1.0)); };
  std::vector<std::pair<std::uint64_t, int>> keys(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Point place = points[i] - box.min();
    keys[i] = { AlongCurve(cell(place.x()), cell(place.y())), static_cast<int>(i) };
  }
  std::sort(keys.begin(), keys.end());
  std::vector<int> order(points.size());
  std::transform(
    keys.begin(), keys.end(), order.begin(), [](const auto& key) { return key.second; });
  return order;
}
}
