#pragma once

#include "Plane.h"

#include <Eigen/Geometry>

#include <cmath>

namespace crossfield
{
/// The two rays between which a sector is, in coordinates in which the first one is the positive x
/// axis.
class MirrorRays
{
public:
  MirrorRays(const Point& centre, double start, int order, double reach)
    : Centre(centre)
    , Turn(start)
    , Second(order == 1 ? Point(-1.0, 0.0) : Point(std::cos(Pi / order), std::sin(Pi / order)))
    , Reach(reach)
  {
  }

  Point ToRays(const Point& point) const
  {
    return this->Turn.inverse() * Point(point - this->Centre);
  }

  /// Returns the distance from the line of the first or second ray, positive on the side of the
  /// sector.
  double Distance(const Point& local, int ray) const
  {
    return ray == 0 ? local.y() : Cross(local, this->Second);
  }
  bool IsInside(const Point& local) const
  {
    return this->Distance(local, 0) > this->Reach && this->Distance(local, 1) > this->Reach;
  }
  /// Returns the ray that a point is on, −1 for none. The centre is on the first.
  int RayOf(const Point& local) const
  {
    for (const int ray : { 0, 1 })
    {
      if (std::abs(this->Distance(local, ray)) <= this->Reach &&
        this->Along(local, ray) >= -this->Reach)
      {
        return ray;
      }
    }
    return -1;
  }
  /// Returns the position of a point of a ray along the sector's border, which leads from the far
  /// end of the second ray to the centre, at 0, and along the first ray; the sector is on its left.
  double Position(const Point& local, int ray) const
  {
    return ray == 0 ? this->Along(local, 0) : -this->Along(local, 1);
  }

private:
  double Along(const Point& local, int ray) const
  {
    return ray == 0 ? local.x() : local.dot(this->Second);
  }

  const Point Centre;
  const Eigen::Rotation2Dd Turn;
  const Point Second; ///< Unit vector of the second ray.
  const double Reach;
};
}
