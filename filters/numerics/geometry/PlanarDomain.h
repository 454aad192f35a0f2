#pragma once

#include "Plane.h"

namespace crossfield
{
/// A vertex of a boundary that turns by more than this is a corner; below it stands for a curve.
constexpr double DefaultCornerAngle = Pi / 6.0;

/// A connected planar domain: one outer loop, counter-clockwise, and inner loops, clockwise, so
/// that the domain lies on the left of every boundary segment.
struct PlanarDomain
{
  std::vector<Loop> loops; ///< [0] is the outer loop.

  /// χ(G) = 1 − number of inner loops.
  int EulerCharacteristic() const { return 2 - static_cast<int>(this->loops.size()); }
  double Area() const;
  double Diagonal() const { return BoundingDiagonal(this->loops); }
};
}
