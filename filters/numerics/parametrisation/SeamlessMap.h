#pragma once

#include "FlatteningReport.h"
#include "MeshTopology.h"

#include <array>
#include <optional>
#include <vector>

namespace crossfield
{
/// Returns i^quarters times a vector, without rounding.
inline Point TurnByQuarters(const Point& vector, int quarters)
{
  switch (((quarters % 4) + 4) % 4)
  {
  case 1:
    return TurnedLeft(vector);
  case 2:
    return { -vector.x(), -vector.y() };
  case 3:
    return { vector.y(), -vector.x() };
  default:
    return vector;
  }
}

/// Transition from the chart on one side of a seam to that on the other:
/// w' = i^rotation w + translation.
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

/// A vertex at which the angles of the map do not add up to 2π, or to π on the boundary.
struct Cone
{
  int vertex = 0; ///< Vertex of the mesh.
  int quarterIndex = 1;
  bool onBoundary = false;
  int row = -1; ///< Row of the configuration; −1 for corners.

  /// Returns the angle around it in quarter turns: 4 − k inside, 2 − k at a corner.
  int Quarters() const { return (this->onBoundary ? 2 : 4) - this->quarterIndex; }
};

/// Throws Error, with a place, if a cone has no angle in the map of a quad mesh: for quarter indices above 2
/// inside and above 1 on the boundary.
void RequireAngle(const Cone& cone, const std::string& where);

/// Returns the sum of the quarter indices of the cones at each vertex.
std::vector<int> QuartersOfVertices(const MeshTopology& topology, const std::vector<Cone>& cones);

/// The seamless map of a cross field: w = u + iv with dw = e^{−(H + iθ)} dz on the mesh cut open
/// (docs/method.md §12), or the nearest map if inner loops have a holonomy defect. In the map
/// crosses are parallel to the axes and sides of the boundary are axis-parallel segments; across a
/// seam w changes by quarter turns and a translation. Every singularity is a cone of angle
/// (4 − k) π/2, every corner one of (2 − k) π/2.
struct SeamlessMap
{
  SharedTopology topology;
  std::vector<std::array<int, 3>> corners; ///< Vertex of the cut mesh at every triangle corner.
  std::vector<int> original;               ///< Vertex of the mesh for every vertex of the cut mesh.
  std::vector<Point> points; ///< w at the vertices of the cut mesh. The area is that of the domain.

  /// Per side of a triangle: 0 where it is no seam; ±(i + 1) where transition i, or its inverse,
  /// maps the chart of the triangle to that of its neighbour.
  std::vector<std::array<int, 3>> seams;
  std::vector<SeamTransition> transitions;
  /// Per entry of mesh.boundary its direction i^direction in the chart of its triangle, 0 to 3.
  std::vector<int> directions;
  std::vector<Cone> cones; ///< Singularities in the order of the configuration, then corners.

  std::vector<double> holonomyDefect; ///< As in HField.
  /// √(∫ e^{2H} |∇w − e^{−(H + iθ)}|² / area): the deviation of the map from a conformal one,
  /// relative to its gradient.
  double residual = 0.0;
  /// How the map was found if the nearest map to the crosses is not injective: then it is the layout
  /// of a flat metric, on another triangulation (docs/method.md §12.4).
  std::optional<FlatteningReport> flattening;

  const Point& At(int triangle, int corner) const
  {
    return this->points[this->corners[triangle][corner]];
  }
  /// Returns the transition across a side of a triangle; the identity where it is no seam.
  SeamTransition Across(int triangle, int side) const;
  /// Returns the point of the domain at which a triangle has coordinates w, or, for coordinates outside
  /// it, a point of its outline.
  SpacePoint PlaceOf(int triangle, const Point& w) const;
  /// Returns the diagonal of the bounding box of w, to which tolerances are relative.
  double Extent() const;
};
}
