#include "HandleSurface.h"

#include "vtkBoundingBox.h"
#include "vtkMath.h"

#include <cmath>
#include <limits>

namespace
{
using Vector = HandleSurface::Vector;

Vector Difference(const Vector& a, const Vector& b)
{
  return { a[0] - b[0], a[1] - b[1], a[2] - b[2] };
}

double Length(const Vector& a)
{
  return vtkMath::Norm(a.data());
}

/**
 * Returns the parameter t of the point eye + t sight at which a ray meets a triangle, by Cramer's rule; not a number if it
 * does not.
 */
double Meet(const Vector& eye, const Vector& sight, const std::array<Vector, 3>& triangle)
{
  const Vector a = Difference(triangle[1], triangle[0]);
  const Vector b = Difference(triangle[2], triangle[0]);
  const Vector c = Difference(eye, triangle[0]);
  Vector p;
  vtkMath::Cross(sight.data(), b.data(), p.data());
  Vector q;
  vtkMath::Cross(c.data(), a.data(), q.data());
  const double determinant = vtkMath::Dot(a.data(), p.data());
  const double u = vtkMath::Dot(c.data(), p.data()) / determinant;
  const double v = vtkMath::Dot(sight.data(), q.data()) / determinant;
  const double t = vtkMath::Dot(b.data(), q.data()) / determinant;
  const bool meets = u >= 0 && v >= 0 && u + v <= 1 && t >= 0;
  return meets ? t : std::numeric_limits<double>::quiet_NaN();
}
}

//------------------------------------------------------------------------------
HandleSurface::HandleSurface(const std::vector<double>& numbers)
  : Triangles(numbers.size() / 9)
{
  vtkBoundingBox box;
  for (std::size_t i = 0; i < 3 * this->Triangles.size(); ++i)
  {
    Vector point = { numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2] };
    this->Triangles[i / 3][i % 3] = point;
    box.AddPoint(point.data());
  }
  this->Size = box.IsValid() ? box.GetDiagonalLength() : 0;
}

//------------------------------------------------------------------------------
std::optional<Vector> HandleSurface::IntersectRay(const Vector& eye, const Vector& beyond) const
{
  const Vector sight = Difference(beyond, eye);
  double first = std::numeric_limits<double>::infinity();
  for (const std::array<Vector, 3>& triangle : this->Triangles)
  {
    first = std::fmin(first, Meet(eye, sight, triangle));
  }
  if (!std::isfinite(first))
  {
    return std::nullopt;
  }
  return Vector{ eye[0] + first * sight[0], eye[1] + first * sight[1], eye[2] + first * sight[2] };
}

//------------------------------------------------------------------------------
bool HandleSurface::Hides(const Vector& eye, const Vector& point) const
{
  // Points are on a finer surface, off this one by less.
  constexpr double Near = 0.02;
  const auto met = this->IntersectRay(eye, point);
  return met &&
    Length(Difference(*met, eye)) < Length(Difference(point, eye)) - Near * this->Size;
}
