#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// A rotation about a centre, after a reflection in the x axis through it or not.
struct Isometry
{
  Point centre = Point::Zero();
  double angle = 0.0;
  bool reflects = false;

  Point operator()(const Point& point) const;
  Isometry Inverse() const;
};

/// A group of symmetries about one centre: the rotations by multiples of 2π / order, and for each of them
/// its product with one reflection, if there is any.
struct SymmetryGroup
{
  Point centre = Point::Zero();
  int order = 1; ///< Number of rotations.
  bool reflects = false;
  double axis = 0.0; ///< Angle of one axis of reflection, in [0, π / order).

  /// All elements, the identity first.
  std::vector<Isometry> Elements() const;
  bool IsTrivial() const { return this->order == 1 && !this->reflects; }
};

/// The symmetries of a domain: every one maps the vertices of all loops to vertices, within a part of
/// the diagonal, 1e-9 by default. Vertices on straight sides do not matter.
///
/// The centre is that of the outer loop's area. The smallest rotation that maps the boundary to itself
/// generates all, and one reflection gives the others, so the time is linear in the number of vertices,
/// but for domains whose outer loop has symmetries that inner loops have not.
SymmetryGroup FindSymmetries(const PlanarDomain& domain, double tolerance = 1e-9);
}
