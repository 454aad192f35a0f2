#pragma once

#include "Plane.h"

#include <Eigen/Core>

#include <string>

namespace crossfield
{
/// Plane of a domain in space, with the right-handed frame used for computations: p = x axis1 + y
/// axis2 + offset normal.
///
/// The frame is that of the nearest coordinate plane, mapped by the shortest rotation to the plane
/// of the domain: the axes (x, y) with the normal z, (y, z) with x, or (x, z) with −y. It depends
/// only on the direction of the plane, so a domain, its singularities and its mesh have the same
/// frame. In coordinate planes, coordinates are copied bit for bit. In other planes they are
/// rounded to 2^-44 of their magnitude; otherwise rounding errors would decide the many ties in the
/// mesh of a symmetric domain.
class DomainPlane
{
public:
  /// Constructs the plane z = 0.
  DomainPlane() = default;

  /// Finds the plane of points, given as columns: z = const if z varies by no more than single
  /// precision explains, otherwise the least-squares plane.
  ///
  /// Throws Error, with the deviation, if the points are farther from the plane than 1e-4 of their
  /// size and than rounding explains. Points that are not finite yield z = 0; a mesh or loops of
  /// such points are refused elsewhere.
  static DomainPlane Find(const Eigen::Matrix3Xd& points);

  /// Works as Find, but does not throw.
  static DomainPlane Nearest(const Eigen::Matrix3Xd& points);

  /// Returns whether the points are as near to the plane as Find requires.
  bool IsNear() const;

  /// Returns whether the plane is z = const. The z coordinates of input that belongs to the domain
  /// are then ignored.
  bool IsHorizontal() const { return this->Normal == Eigen::Vector3d::UnitZ(); }

  /// Returns a warning if points are farther from the plane than rounding explains, otherwise an
  /// empty text.
  std::string FlatteningWarning() const;

  /// Returns the plane coordinates of the orthogonal projection of a point in space.
  Point ToPlane(const Eigen::Vector3d& place) const;

  /// Works as ToPlane and throws Error if the point is not in the plane, unless the plane is z =
  /// const. `what` begins the message. A distance of up to 1/1000 of the domain's size is accepted,
  /// because coordinates are typed with few digits.
  Point RequireInPlane(const Eigen::Vector3d& place, const std::string& what) const;

  /// Returns the point in space with the given plane coordinates.
  Eigen::Vector3d ToSpace(const Point& point) const;

  /// Returns the point in space of a point with plane coordinates x and y and the height z above the plane.
  Eigen::Vector3d PlaceToSpace(const SpacePoint& place) const;

  /// Returns the direction in space of a direction in the plane.
  Eigen::Vector3d DirectionToSpace(const Point& direction) const;

private:
  Eigen::Vector3d Axis1 = Eigen::Vector3d::UnitX();
  Eigen::Vector3d Axis2 = Eigen::Vector3d::UnitY();
  Eigen::Vector3d Normal = Eigen::Vector3d::UnitZ();
  double Offset = 0.0; ///< Signed distance of the plane from the origin along the normal.
  double Size = 0.0;   ///< Diagonal of the bounding box of its points.
  double Deviation =
    0.0; ///< Largest distance of its points from it, if rounding does not explain it.
  double Quantum = 0.0; ///< Unit to which coordinates are rounded; 0 means no rounding.
};
}
