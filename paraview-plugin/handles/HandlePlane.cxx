#include "HandlePlane.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace
{
using Vector = HandlePlane::Vector;

Vector Difference(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Dot(const Vector& a, const Vector& b)
{
  return vtkMath::Dot(a.data(), b.data());
}
}

//------------------------------------------------------------------------------
HandlePlane HandlePlane::FromNumbers(const std::vector<double>& numbers)
{
  HandlePlane plane;
  if (numbers.size() == 9)
  {
    std::copy_n(numbers.data(), 3, plane.Origin.begin());
    std::copy_n(numbers.data() + 3, 3, plane.Axis1.begin());
    std::copy_n(numbers.data() + 6, 3, plane.Axis2.begin());
  }
  return plane;
}

//------------------------------------------------------------------------------
bool HandlePlane::operator==(const HandlePlane& other) const
{
  return this->Origin == other.Origin && this->Axis1 == other.Axis1 && this->Axis2 == other.Axis2;
}

//------------------------------------------------------------------------------
Vector HandlePlane::Normal() const
{
  Vector normal;
  vtkMath::Cross(this->Axis1.data(), this->Axis2.data(), normal.data());
  return normal;
}

//------------------------------------------------------------------------------
Vector HandlePlane::ToSpace(const std::array<double, 2>& point) const
{
  Vector place = this->Origin;
  for (std::size_t i = 0; i < 3; ++i)
  {
    place[i] += point[0] * this->Axis1[i] + point[1] * this->Axis2[i];
  }
  return place;
}

//------------------------------------------------------------------------------
std::optional<std::array<double, 2>> HandlePlane::IntersectRay(
  const Vector& eye, const Vector& beyond) const
{
  const Vector normal = this->Normal();
  const Vector sight = Difference(beyond, eye);
  const Vector toEye = Difference(eye, this->Origin);
  const double t = -Dot(normal, toEye) / Dot(normal, sight);
  const std::array<double, 2> point = { Dot(this->Axis1, toEye) + t * Dot(this->Axis1, sight),
    Dot(this->Axis2, toEye) + t * Dot(this->Axis2, sight) };
  // In an edge-on view, part of the screen corresponds to points behind the eye.
  if (!(t >= 0) || !std::isfinite(point[0]) || !std::isfinite(point[1]))
  {
    return std::nullopt;
  }
  return point;
}
