#include "DomainPlane.h"

#include "Error.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
using Eigen::Vector3d;

/// Axes and normal of a coordinate plane.
struct Frame
{
  Vector3d axis1;
  Vector3d axis2;
  Vector3d normal;
};

/// Returns the frame of the coordinate plane nearest to the plane with the given normal.
Frame NearestCoordinatePlane(const Vector3d& normal)
{
  // If two planes are equally near, as at a slope of 45°, rounding must not decide between them.
  constexpr double Tie = 1e-6;
  const Vector3d size = normal.cwiseAbs();
  const double largest = size.maxCoeff() - Tie;
  if (size.z() >= largest)
  {
    return { Vector3d::UnitX(), Vector3d::UnitY(), Vector3d::UnitZ() };
  }
  if (size.y() >= largest)
  {
    return { Vector3d::UnitX(), Vector3d::UnitZ(), -Vector3d::UnitY() };
  }
  return { Vector3d::UnitY(), Vector3d::UnitZ(), Vector3d::UnitX() };
}

Vector3d LeastSquaresNormal(const Eigen::Matrix3Xd& points)
{
  const Eigen::MatrixX3d centred = (points.colwise() - points.rowwise().mean()).transpose();
  const Eigen::JacobiSVD<Eigen::MatrixX3d> decomposition(centred, Eigen::ComputeFullV);
  return decomposition.matrixV().rightCols<1>();
}
}

DomainPlane DomainPlane::Find(const Eigen::Matrix3Xd& points)
{
  DomainPlane plane = Nearest(points);
  if (!plane.IsNear())
  {
    throw Error("The domain is not planar: its points are up to " + FormatNumber(plane.Deviation) +
      " off the nearest plane and its size is " + FormatNumber(plane.Size) +
      "; give a domain that lies in one plane.");
  }
  return plane;
}

bool DomainPlane::IsNear() const
{
  // 1/250 of the default edge length of triangles, a fortieth of the size.
  constexpr double MostDeviation = 1e-4;
  return this->Deviation <= MostDeviation * this->Size;
}

DomainPlane DomainPlane::Nearest(const Eigen::Matrix3Xd& points)
{
  DomainPlane plane;
  if (points.cols() == 0 || !points.allFinite())
  {
    return plane;
  }
  const Vector3d lower = points.rowwise().minCoeff();
  const Vector3d extent = points.rowwise().maxCoeff() - lower;
  plane.Size = extent.norm();
  // Coordinates stored in single precision have a relative error of 6e-8.
  constexpr double Flatness = 1e-6;
  if (extent.z() <= Flatness * (std::hypot(extent.x(), extent.y()) + std::abs(lower.z())))
  {
    plane.Offset = lower.z();
    return plane;
  }

  const bool isCoordinatePlane = extent.x() == 0.0 || extent.y() == 0.0;
  Vector3d normal = extent.x() == 0.0 ? Vector3d::UnitX() : Vector3d::UnitY();
  if (!isCoordinatePlane && points.cols() > 2) // fewer points do not form a loop
  {
    normal = LeastSquaresNormal(points);
  }
  const Frame base = NearestCoordinatePlane(normal);
  if (normal.dot(base.normal) < 0.0)
  {
    normal = -normal;
  }
  // The shortest rotation that maps the base's normal to this one.
  const Vector3d middle = (base.normal + normal) / (1.0 + base.normal.dot(normal));
  plane.Axis1 = base.axis1 - base.axis1.dot(normal) * middle;
  plane.Axis2 = base.axis2 - base.axis2.dot(normal) * middle;
  plane.Normal = normal;

  const double reach = points.cwiseAbs().maxCoeff();
  const Eigen::RowVectorXd heights = normal.transpose() * points;
  plane.Offset = 0.5 * (heights.minCoeff() + heights.maxCoeff());
  const double deviation = 0.5 * (heights.maxCoeff() - heights.minCoeff());
  constexpr auto SinglePrecision = static_cast<double>(std::numeric_limits<float>::epsilon());
  const double rounding = Flatness * plane.Size + SinglePrecision * reach;
  if (deviation > rounding)
  {
    plane.Deviation = deviation;
  }
  if (!isCoordinatePlane)
  {
    plane.Quantum = std::exp2(std::ceil(std::log2(reach)) - 44.0);
  }
  return plane;
}

std::string DomainPlane::FlatteningWarning() const
{
  return this->Deviation == 0.0
    ? std::string()
    : "The domain was flattened: its points were up to " + FormatNumber(this->Deviation) +
      " off its plane, and its size is " + FormatNumber(this->Size) + ".";
}

Point DomainPlane::ToPlane(const Vector3d& place) const
{
  if (this->IsHorizontal())
  {
    return { place.x(), place.y() };
  }
  const Point point(this->Axis1.dot(place), this->Axis2.dot(place));
  return this->Quantum > 0.0 ? Point((point / this->Quantum).array().round() * this->Quantum)
                             : point;
}

Point DomainPlane::RequireInPlane(const Vector3d& place, const std::string& what) const
{
  const double distance = std::abs(this->Normal.dot(place) - this->Offset);
  if (!this->IsHorizontal() && distance > 1e-3 * this->Size)
  {
    throw Error(what + " at (" + FormatNumber(place.x()) + ", " + FormatNumber(place.y()) + ", " +
      FormatNumber(place.z()) + ") is " + FormatNumber(distance) +
      " off the plane of the domain; give it in that plane, in a .csv file with a column z.");
  }
  return this->ToPlane(place);
}

Vector3d DomainPlane::ToSpace(const Point& point) const
{
  if (this->IsHorizontal())
  {
    return { point.x(), point.y(), this->Offset };
  }
  return point.x() * this->Axis1 + point.y() * this->Axis2 + this->Offset * this->Normal;
}

Vector3d DomainPlane::PlaceToSpace(const SpacePoint& place) const
{
  const Vector3d below = this->ToSpace(Point(place.head<2>()));
  return place.z() == 0.0 ? below : Vector3d(below + place.z() * this->Normal);
}

Vector3d DomainPlane::DirectionToSpace(const Point& direction) const
{
  if (this->IsHorizontal())
  {
    return { direction.x(), direction.y(), 0.0 };
  }
  return direction.x() * this->Axis1 + direction.y() * this->Axis2;
}
}
