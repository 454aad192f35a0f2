#include "SeamlessMap.h"

#include <Eigen/Geometry>

#include <cstdlib>

namespace crossfield
{
SeamTransition SeamlessMap::Across(int triangle, int side) const
{
  const int seam = this->seams[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(side)];
  if (seam == 0)
  {
    return {};
  }
  const SeamTransition& transition =
    this->transitions[static_cast<std::size_t>(std::abs(seam) - 1)];
  return seam > 0 ? transition : transition.Inverse();
}

double SeamlessMap::Extent() const
{
  Eigen::AlignedBox2d box;
  for (const Point& w : this->points)
  {
    box.extend(w);
  }
  return box.diagonal().norm();
}
}
