#ifndef PlaneFrame_h
#define PlaneFrame_h

#include "DomainPlane.h"

#include <Eigen/Core>

#include <optional>

class vtkDoubleArray;
class vtkFieldData;

/**
 * Frame of a domain's plane (DomainPlane.h) that does not need the domain: the origin of its
 * coordinates and its two axes, p = origin + x axis1 + y axis2. The default is the frame of z = 0.
 */
struct PlaneFrame
{
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis1 = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitY();

  PlaneFrame() = default;
  explicit PlaneFrame(const crossfield::DomainPlane& plane);

  /** Returns whether the plane is z = const. Other inputs of a domain in such a plane ignore z. */
  bool IsHorizontal() const;

  /** Returns the point in space with coordinates x and y. */
  Eigen::Vector3d ToSpace(double x, double y) const;
  /** Returns the coordinates of the orthogonal projection of a point in space. */
  crossfield::Point ToPlane(const Eigen::Vector3d& place) const;

  /** Writes three tuples of three numbers: origin, axis1 and axis2. */
  void Write(vtkDoubleArray* numbers) const;
  /** Adds the frame as field data `Plane`, unless the plane is z = const, which the points show. */
  void Record(vtkFieldData* data) const;
  /** Returns the frame in field data, if there is one. */
  static std::optional<PlaneFrame> Read(vtkFieldData* data);
};

#endif
