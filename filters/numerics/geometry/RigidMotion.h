#pragma once

#include "Plane.h"

namespace crossfield
{
/// A motion of the plane that keeps the orientation: a rotation about the origin, followed by a
/// translation.
struct RigidMotion
{
  double angle = 0.0; ///< In (−π, π]; 0: the motion is a translation.
  Point shift = Point::Zero();

  Eigen::Matrix2d Rotation() const;
  Point operator()(const Point& point) const { return this->Rotation() * point + this->shift; }
  /// Returns the image of a point in space, at the same height.
  SpacePoint ImageOf(const SpacePoint& place) const
  {
    SpacePoint image = place;
    image.head<2>() = (*this)(place.head<2>());
    return image;
  }
  RigidMotion Inverse() const;
  /// Returns the point that does not move; the angle must not be 0.
  Point Centre() const;
};

/// Returns the motion that takes points to other ones with the smallest sum of squared distances.
RigidMotion FitMotion(const std::vector<Point>& from, const std::vector<Point>& to);
}
