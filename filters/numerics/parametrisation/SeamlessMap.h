#pragma once

#include "MeshTopology.h"

#include <array>
#include <vector>

namespace crossfield
{
/// i^quarters times a vector; exact.
inline Point TurnByQuarters(const Point& vector, int quarters)
{
  switch (((quarters % 4) + 4) % 4)
  {
  case 1:
    return { -vector.y(), vector.x() };
  case 2:
    return { -vector.x(), -vector.y() };
  case 3:
    return { vector.y(), -vector.x() };
  default:
    return vector;
  }
}

/// From the chart on one side of a seam to that on the other: w' = i^rotation w + translation.
struct SeamTransition
{
  int rotation = 0; ///< 0 to 3.
  Point translation = Point::Zero();

  Point operator()(const Point& w) const
  {
    return TurnByQuarters(w, this->rotation) + this->translation;
  }
  SeamTransition Inverse() const
  {
    return { (4 - this->rotation) % 4, -TurnByQuarters(this->translation, -this->rotation) };
  }
};

/// A point of the flat surface where the angles do not add up to 2π, or π on the boundary.
struct Cone
{
  int vertex = 0; ///< Of the mesh.
  int quarterIndex = 1;
  bool onBoundary = false;
  int row = -1; ///< Of the configuration; −1 for corners.

  /// The angle around it in quarter turns: 4 − k inside, 2 − k at a corner.
  int Quarters() const { return (this->onBoundary ? 2 : 4) - this->quarterIndex; }
};

/// w = u + iv with dw = e^{−(H + iθ)} dz on a mesh that is cut open (docs/method.md §12): crosses are along
/// the axes, the boundary's sides are axis-parallel segments, and across a seam w changes by quarter
/// turns and a translation. Every singularity is a cone of angle (4 − k) π/2, every corner one of (2 − k) π/2.
struct SeamlessMap
{
  SharedTopology topology;
  std::vector<std::array<int, 3>> corners; ///< Per triangle corner the vertex of the cut mesh.
  std::vector<int> original;               ///< Per vertex of the cut mesh that of the mesh.
  std::vector<Point> points;               ///< w, per vertex of the cut mesh. Area as the domain's.

  /// Per side of a triangle: 0 where it is no seam; ±(i + 1) where transition i, or its inverse,
  /// leads from its chart to that of its neighbour.
  std::vector<std::array<int, 3>> seams;
  std::vector<SeamTransition> transitions;
  /// Per entry of mesh.boundary its direction in the chart of its triangle: i^direction, 0 to 3.
  std::vector<int> directions;
  std::vector<Cone> cones; ///< Singularities in the order of the configuration, then corners.

  std::vector<double> holonomyDefect; ///< As in HField.
  /// √(∫ e^{2H} |∇w − e^{−(H + iθ)}|² / area), scaled: how far the map is from conformal.
  double residual = 0.0;

  const Point& At(int triangle, int corner) const
  {
    return this->points[static_cast<std::size_t>(
      this->corners[static_cast<std::size_t>(triangle)][static_cast<std::size_t>(corner)])];
  }
  SeamTransition Across(int triangle, int side) const;
  /// Largest extent of w, which tolerances refer to.
  double Extent() const;
};
}
