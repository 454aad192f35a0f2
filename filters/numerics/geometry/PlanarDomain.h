#pragma once

#include "Plane.h"

namespace crossfield
{
/// Turning angle above which a boundary vertex is a corner; below it the vertex is part of a curve.
constexpr double DefaultCornerAngle = Pi / 6.0;

/// Connected planar domain with one outer loop, counter-clockwise, and inner loops, clockwise, so
/// that the domain is on the left of every boundary segment.
struct PlanarDomain
{
  std::vector<Loop> loops; ///< The outer loop comes first.

  /// Returns χ(G) = 1 − number of inner loops.
  int EulerCharacteristic() const { return 2 - static_cast<int>(this->loops.size()); }
  double Area() const;
  /// Returns the diagonal of the bounding box in the domain's frame (CanonicalFrame.h), to which
  /// lengths and tolerances are relative.
  double Diagonal() const;
};
}
