/**
 * The plane in space that handles lie in, with its coordinates: p = Origin + x Axis1 + y Axis2. By default z = 0.
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
  Vector Axis1 = { 1, 0, 0 }; ///< Of length 1, as Axis2, and at right angles to it.
  Vector Axis2 = { 0, 1, 0 };

  /** Of nine numbers, as the filters' information property `Plane` has them; of none or others, z = 0. */
  static HandlePlane Of(const std::vector<double>& numbers);

  bool operator==(const HandlePlane& other) const;

  Vector Normal() const;
  Vector ToSpace(const std::array<double, 2>& point) const;
  /** The coordinates of where the ray from `eye` through `beyond` meets the plane; nothing where it does not. */
  std::optional<std::array<double, 2>> Meet(const Vector& eye, const Vector& beyond) const;
};

#endif
