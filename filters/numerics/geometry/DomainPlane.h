#pragma once

#include "Plane.h"

#include <Eigen/Core>

#include <string>

namespace crossfield
{
/// The plane of a domain in space, with the right-handed frame in which its computations are done:
/// p = x axis1 + y axis2 + offset normal.
///
/// The frame is that of the nearest coordinate plane, turned with it by the shortest rotation: the
/// axes (x, y) with the normal z, (y, z) with x, or (x, z) with −y. It depends on the direction of
/// the plane only, so that a domain, its singularities and its mesh have the same. In coordinate
/// planes coordinates are copied, bit for bit. In others they are rounded to 2^-44 of their size:
/// rounding errors would else decide the many ties in the mesh of a symmetrical domain.
class DomainPlane
{
public:
  /// The plane z = 0.
  DomainPlane() = default;

  /// The plane z = const if z varies by no more than single precision makes it, else the plane of
  /// least squares. One point a column. Throws Error, with the deviation, when the points are not
  /// in one plane. Points that are not finite give z = 0: the mesh or loops of them are refused.
  static DomainPlane Find(const Eigen::Matrix3Xd& points);

  /// z = const: z is ignored in input that has to fit to the domain.
  bool IsHorizontal() const { return this->Normal == Eigen::Vector3d::UnitZ(); }

  /// The coordinates of the foot of a point of space.
  Point ToPlane(const Eigen::Vector3d& place) const;

  /// As ToPlane; throws Error for a point that is not in the plane, unless that is z = const.
  /// `what` begins the sentence. Off by 1/1000 of the domain is allowed: coordinates are typed with
  /// few digits.
  Point RequireInPlane(const Eigen::Vector3d& place, const std::string& what) const;

  /// The point of space with given coordinates.
  Eigen::Vector3d ToSpace(const Point& point) const;

  /// A direction in the plane as one of space.
  Eigen::Vector3d DirectionToSpace(const Point& direction) const;

private:
  Eigen::Vector3d Axis1 = Eigen::Vector3d::UnitX();
  Eigen::Vector3d Axis2 = Eigen::Vector3d::UnitY();
  Eigen::Vector3d Normal = Eigen::Vector3d::UnitZ();
  double Offset = 0.0;  ///< Of the plane along the normal.
  double Size = 0.0;    ///< Diagonal of the bounding box of its points.
  double Quantum = 0.0; ///< Coordinates are rounded to multiples of it; 0: not at all.
};
}
