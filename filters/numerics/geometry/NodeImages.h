#pragma once

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Returns for each of the points `from` of a mesh the point of `to` that is nearest to its image under a
/// motion (of points (x, y, z, 1)), −1 if none is within 1e-9 of the extent of all points. Coordinates of
/// files with 12 digits or more match that well.
std::vector<int> FindImages(const std::vector<Eigen::Vector3d>& points,
  const Eigen::Matrix4d& motion, const std::vector<int>& from, const std::vector<int>& to);
}
