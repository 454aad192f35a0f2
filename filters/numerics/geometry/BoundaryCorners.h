#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// Angles that differ by less than this come out of the rounding of coordinates on either side.
constexpr double AngleRounding = 1e-9;

/// Nearer to a vertex or side of the boundary than this part of the diagonal is on it: coordinates may
/// have gone through single precision.
constexpr double BoundaryReach = 1e-6;

/// Whether a boundary vertex with this turning angle is a corner; otherwise it stands for a curve.
inline bool IsCorner(double turning, double cornerAngle = DefaultCornerAngle)
{
  return std::abs(turning) > cornerAngle + AngleRounding;
}

/// A vertex of a boundary that is not part of a curve.
struct Corner
{
  Point position = Point::Zero();
  int loop = 0;
  int vertex = 0;    ///< Position in its loop.
  double angle = Pi; ///< Inside the domain, radians in (0, 2π): below π it points outwards.
  Point inward = Point::Zero(); ///< Unit bisector of the angle, into the domain.

  /// Turning angle of the boundary, π − angle.
  double Turning() const { return Pi - this->angle; }
  /// In [3π/4, π): it takes no quarter index of its own by the smallest rotation, but singularities
  /// in the domain can make it a regular point of the boundary (paper, "Generalized Poincaré-Hopf
  /// theorem").
  bool Cancellable() const
  {
    return this->angle >= 0.75 * Pi - AngleRounding && this->angle < Pi - AngleRounding;
  }
};

/// The vertex of a loop with the domain on its left, as a corner whatever its angle.
Corner DescribeVertex(const std::vector<Loop>& loops, std::size_t loop, std::size_t vertex);

/// The corners of loops with the domain on their left, in the order of loops and vertices.
std::vector<Corner> FindCorners(
  const std::vector<Loop>& loops, double cornerAngle = DefaultCornerAngle);

/// A quarter index that was chosen for a vertex of the boundary.
struct CornerChoice
{
  Point position = Point::Zero();
  int quarterIndex = 0;
};

/// For every choice the number of the vertex at its position, within BoundaryReach of the diagonal of the
/// vertices' bounding box. Throws Error when there is no vertex, or two choices for one.
std::vector<std::size_t> MatchChoices(
  const std::vector<Point>& vertices, const std::vector<CornerChoice>& choices);
}
