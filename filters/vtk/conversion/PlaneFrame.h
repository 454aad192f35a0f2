#ifndef PlaneFrame_h
#define PlaneFrame_h

#include "DomainPlane.h"

#include <Eigen/Core>

#include <optional>

class vtkDoubleArray;
class vtkFieldData;

/**
 * The frame of a domain's plane (DomainPlane.h) by itself, so that places can be told in it without the domain: the origin of its
 * coordinates and its two axes, p = origin + x axis1 + y axis2. By default that of z = 0.
 */
struct PlaneFrame
{
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis1 = Eigen::Vector3d::UnitX();
  Eigen::Vector3d axis2 = Eigen::Vector3d::UnitY();

  PlaneFrame() = default;
  explicit PlaneFrame(const crossfield::DomainPlane& plane);

  /** Where z is ignored in what has to fit to the domain. */
  bool IsHorizontal() const;

  Eigen::Vector3d ToSpace(double x, double y) const;
  /** The coordinates of the foot of a point of space. */
  crossfield::Point ToPlane(const Eigen::Vector3d& place) const;

  /** As three tuples of three: origin and axes. */
  void Write(vtkDoubleArray* numbers) const;
  /** Adds them as field data `Plane`; not of z = const, whose points tell all. */
  void Record(vtkFieldData* data) const;
  /** The frame in field data, if there is one. */
  static std::optional<PlaneFrame> Read(vtkFieldData* data);
};

#endif
