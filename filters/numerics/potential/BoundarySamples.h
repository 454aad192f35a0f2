#pragma once

#include "PointPotential.h"

#include <cstddef>
#include <vector>

namespace crossfield
{
/// The points of the boundary at which logarithms are evaluated: the ends of its half edges.
struct BoundarySamples
{
  /// Minimum number of logarithms or of their derivatives in a part of a loop.
  static constexpr std::ptrdiff_t LogsOfPart = 10000;

  /// Coordinates of the starts of the entries of mesh.boundary, then of their midpoints.
  Eigen::ArrayX2d points;
  std::vector<Eigen::Index> starts; ///< The point at which each half starts.
  std::vector<Eigen::Index> ends;   ///< The point at which each half ends.

  explicit BoundarySamples(const PointPotential& potential);

  /// Computes y / |y|² for the offsets y of the points from a position.
  void InvertOffsets(const Point& position, Eigen::ArrayXd& x, Eigen::ArrayXd& y) const;
  /// Returns the minimum number of singularities in a part of a loop over all points for each of them.
  std::ptrdiff_t SingularitiesOfPart() const;
};
}
