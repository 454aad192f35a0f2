/**
 * Triangles in space on which handles are placed.
 */

#ifndef HandleSurface_h
#define HandleSurface_h

#include "HandlePlane.h"

#include <array>
#include <optional>
#include <vector>

class HandleSurface
{
public:
  using Vector = HandlePlane::Vector;

  HandleSurface() = default;

  /** Makes triangles of nine numbers each, their points: the filters' information property `Triangles`. */
  explicit HandleSurface(const std::vector<double>& numbers);

  /** Returns whether there are no triangles: handles are then in a plane. */
  bool IsEmpty() const { return this->Triangles.empty(); }

  bool operator==(const HandleSurface& other) const { return this->Triangles == other.Triangles; }

  /** Returns the first point where the ray from `eye` through `beyond` meets a triangle. */
  std::optional<Vector> IntersectRay(const Vector& eye, const Vector& beyond) const;

  /** Returns whether the surface is between the eye and a point on it, or near it. */
  bool Hides(const Vector& eye, const Vector& point) const;

private:
  std::vector<std::array<Vector, 3>> Triangles;
  double Size = 0; ///< Of the bounding box.
};

#endif
