#pragma once

#include "Plane.h"

namespace crossfield
{
/// Frame that is fixed to a domain: it moves with the domain under rotations and shifts, whatever the
/// order of vertices, so that what is computed in it does not depend on the placement of the domain
/// (docs/method.md §10.7).
///
/// Its x axis has the angle arg(Σ l e^(4iθ)) / 4, the mean direction of boundary segments of length l
/// and angle θ modulo quarter turns, so that it is parallel to a side of a domain with axis-parallel
/// sides only. Moments of the boundary choose the quarter turn, and the angle if that mean vanishes.
class CanonicalFrame
{
public:
  /// Constructs the frame of the axes of the plane.
  CanonicalFrame() = default;
  /// Constructs the frame of the boundary loops of a domain, the outer loop first.
  explicit CanonicalFrame(const std::vector<Loop>& loops);

  /// Returns the coordinates of a point of the plane. If the frame is not turned by quarter turns,
  /// they are rounded to about 1e-14 of the extent: otherwise rounding errors of the rotation would
  /// decide the many ties in the mesh of a symmetric domain.
  Point ToFrame(const Point& point) const;
  std::vector<Loop> ToFrame(const std::vector<Loop>& loops) const;
  /// Returns the point of the plane that has given coordinates.
  Point FromFrame(const Point& coordinates) const;
  /// Returns the angle of the frame's x axis in the plane, radians.
  double GetAngle() const;
  /// Returns whether coordinates are those of the plane.
  bool IsIdentity() const { return this->Axis == Point(1.0, 0.0) && this->Quantum == 0.0; }

private:
  Point Origin = Point::Zero();
  Point Axis = Point(1.0, 0.0); ///< The unit vector of the x axis.
  double Quantum = 0.0;         ///< Unit to which coordinates are rounded; 0 means no rounding.
};
}
