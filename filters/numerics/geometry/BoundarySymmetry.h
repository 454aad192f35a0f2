#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// Tolerance of symmetries, relative to the diagonal of the domain.
constexpr double SymmetryReach = 1e-9;

/// Rotation about a centre, optionally preceded by a reflection in the line through the centre
/// parallel to the x axis.
struct Isometry
{
  Point centre = Point::Zero();
  double angle = 0.0;
  bool reflects = false;

  Point operator()(const Point& point) const;
  Isometry Inverse() const;
};

/// Symmetry group about one centre: the rotations by multiples of 2π / order and, if there is a
/// reflection, its product with each of them.
struct SymmetryGroup
{
  Point centre = Point::Zero();
  int order = 1; ///< Number of rotations.
  bool reflects = false;
  double axis = 0.0; ///< Angle of one reflection axis, in [0, π / order).

  /// Returns all elements, the identity first.
  std::vector<Isometry> Elements() const;
  bool IsTrivial() const { return this->order == 1 && !this->reflects; }
};

/// Returns the symmetries of a domain. Each of them maps the vertices of all loops to vertices,
/// within `tolerance` times the diagonal. Vertices on straight sides are ignored. A domain with a loop
/// that is a line at the tolerance has none.
///
/// The centre is the centroid of the outer loop's area. The smallest rotation that maps the
/// boundary to itself generates all rotations, and one reflection yields all others. The running
/// time is therefore linear in the number of vertices, except for domains whose outer loop has
/// symmetries that the inner loops do not share.
SymmetryGroup FindSymmetries(const PlanarDomain& domain, double tolerance = SymmetryReach);

/// Returns the inner loop, from 1, that a symmetry of a domain maps an inner loop to.
std::size_t ImageOfInnerLoop(
  const PlanarDomain& domain, const Isometry& symmetry, std::size_t loop);
}
