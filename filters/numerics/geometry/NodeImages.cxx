#include "NodeImages.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
constexpr double Tolerance = 1e-9;

/// Returns the coordinate along a unit vector that is not parallel to the lines of usual meshes.
double KeyOf(const Eigen::Vector3d& place)
{
  return place.dot(Eigen::Vector3d(0.6113, 0.5527, 0.5666).normalized());
}
}

std::vector<int> FindImages(const std::vector<Eigen::Vector3d>& points,
  const Eigen::Matrix4d& motion, const std::vector<int>& from, const std::vector<int>& to)
{
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points)
  {
    box.extend(point);
  }
  const double reach = Tolerance * box.diagonal().norm();
  std::vector<std::pair<double, int>> sorted; // along a direction, so that few are compared
  for (const int point : to)
  {
    sorted.emplace_back(KeyOf(points[point]), point);
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<int> images;
  for (const int point : from)
  {
    const Eigen::Vector3d place = Eigen::Affine3d(motion) * points[point];
    const double key = KeyOf(place);
    double distance = reach;
    int nearest = -1;
    for (auto at = std::lower_bound(sorted.begin(), sorted.end(), std::pair(key - reach, -1));
         at != sorted.end() && at->first <= key + reach; ++at)
    {
      const double next = (points[at->second] - place).norm();
      if (next <= distance)
      {
        distance = next;
        nearest = at->second;
      }
    }
    images.push_back(nearest);
  }
  return images;
}
}
