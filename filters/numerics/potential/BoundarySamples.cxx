#include "BoundarySamples.h"

#include <algorithm>

namespace crossfield
{
BoundarySamples::BoundarySamples(const PointPotential& potential)
{
  const std::vector<BoundaryHalf>& halves = potential.GetHalves();
  const std::vector<std::size_t>& next = potential.GetNext();
  const auto count = static_cast<Eigen::Index>(next.size());
  this->points.resize(2 * count, 2);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    const BoundaryHalf& first = halves[2 * static_cast<std::size_t>(i)];
    this->points.row(i) = first.from.transpose();
    this->points.row(count + i) = first.to.transpose();
    const auto following = static_cast<Eigen::Index>(next[i]);
    this->starts.insert(this->starts.end(), { i, count + i });
    this->ends.insert(this->ends.end(), { count + i, following });
  }
}

void BoundarySamples::InvertOffsets(
  const Point& position, Eigen::ArrayXd& x, Eigen::ArrayXd& y) const
{
  x = this->points.col(0) - position.x();
  y = this->points.col(1) - position.y();
  const Eigen::ArrayXd inverse = 1.0 / (x * x + y * y);
  x *= inverse;
  y *= inverse;
}

std::ptrdiff_t BoundarySamples::SingularitiesOfPart() const
{
  return std::max<std::ptrdiff_t>(1, LogsOfPart / std::max<std::ptrdiff_t>(1, this->points.rows()));
}
}
