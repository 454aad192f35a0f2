/**
 * Plane in space in which handles are placed, with its coordinates: p = Origin + x Axis1 + y Axis2.
 * The default is z = 0.
 */

#ifndef HandlePlane_h
#define HandlePlane_h

#include <array>
#include <optional>
#include <vector>

struct HandlePlane
{
  using Vector = std::array<double, 3>;

  Vector Origin = { 0, 0, 0 };
  Vector Axis1 = { 1, 0, 0 }; ///< Unit vector, as Axis2, and orthogonal to it.
  Vector Axis2 = { 0, 1, 0 };

  /**
   * Returns the plane of nine numbers, the value of the filters' information property `Plane`; z =
   * 0 for any other count.
   */
  static HandlePlane FromNumbers(const std::vector<double>& numbers);

  bool operator==(const HandlePlane& other) const;

  Vector Normal() const;
  Vector ToSpace(const std::array<double, 2>& point) const;
  /**
   * Returns the plane coordinates at which the ray from `eye` through `beyond` meets the plane, if
   * it does.
   */
  std::optional<std::array<double, 2>> IntersectRay(const Vector& eye, const Vector& beyond) const;
};

#endif
