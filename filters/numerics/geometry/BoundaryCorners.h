#pragma once

#include "PlanarDomain.h"

#include <cmath>

namespace crossfield
{
/// Distance, relative to the diagonal, within which a point counts as being on a vertex or side of
/// the boundary; coordinates may have been stored in single precision.
constexpr double BoundaryReach = 1e-6;

/// Tolerance in radians within which a turning angle counts as π/4 or 3π/4, where two quarter indices are equally good.
/// Coordinates in single precision, as ParaView's sources write them, are off by 2⁻²⁴ of the largest one, so the angle
/// between two edges of length L is off by up to 2√2 · 2⁻²⁴ of the largest coordinate over L: by this for L of 1/600.
constexpr double TieRounding = 1e-4;

/// Returns whether a turning angle is within a tolerance of π/4 or 3π/4 to either side.
inline bool IsTie(double turning, double tolerance = TieRounding)
{
  return std::abs(std::abs(std::remainder(turning, 0.5 * Pi)) - 0.25 * Pi) <= tolerance;
}

/// Tolerance in radians, 1°, within which a tie is reported as ambiguous: coordinates that were rounded to three digits
/// move angles by about as much.
constexpr double AmbiguousAngle = Pi / 180.0;

/// Returns whether a boundary vertex with this turning angle is a corner; otherwise it is part of a
/// curve.
inline bool IsCorner(double turning, double cornerAngle = DefaultCornerAngle)
{
  return std::abs(turning) > cornerAngle + AngleRounding;
}

/// Corner of a boundary: a vertex that is not part of a curve.
struct Corner
{
  Point position = Point::Zero();
  int loop = 0;
  int vertex = 0;    ///< Index in its loop.
  double angle = Pi; ///< Interior angle in radians, in (0, 2π); below π the corner is convex.
  Point inward = Point::Zero(); ///< Unit bisector of the angle, pointing into the domain.

  /// Returns the turning angle of the boundary, π − angle.
  double Turning() const { return Pi - this->angle; }
  /// Returns whether the angle is in [3π/4, π). By the smallest rotation such a corner has no
  /// quarter index of its own, but singularities in the domain can make it a regular point of the
  /// boundary (paper, "Generalized Poincaré-Hopf theorem").
  bool Cancellable() const
  {
    return this->angle >= 0.75 * Pi - TieRounding && this->angle < Pi - AngleRounding;
  }
};

/// Describes a vertex as a corner, whatever its angle. The domain is on the left of the loops.
Corner MakeCorner(const std::vector<Loop>& loops, std::size_t loop, std::size_t vertex);

/// Returns the corners of loops that have the domain on their left, ordered by loop and vertex.
std::vector<Corner> FindCorners(
  const std::vector<Loop>& loops, double cornerAngle = DefaultCornerAngle);

/// Quarter index prescribed at a vertex of the boundary.
struct CornerChoice
{
  Point position = Point::Zero();
  int quarterIndex = 0;
};

/// Returns for each choice the index of the vertex at its position, within BoundaryReach times the
/// diagonal of the vertices' bounding box. Throws Error if there is no such vertex, or if two
/// choices match the same one.
std::vector<std::size_t> MatchChoices(
  const std::vector<Point>& vertices, const std::vector<CornerChoice>& choices);
}
