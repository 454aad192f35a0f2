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

/// Orients, nests and checks boundary loops given in any order and orientation.
///
/// Every loop of the result starts at its leftmost point (of several the lowest) and inner loops
/// are sorted by it, so that the same curves give the same domain however they were written down.
/// Throws Error when there is no loop, a loop has fewer than three points or no area, loops cross
/// or touch, a loop lies outside the outer one or inside another inner one.
PlanarDomain MakePlanarDomain(std::vector<Loop> loops);
}
