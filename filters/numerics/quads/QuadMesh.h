#pragma once

#include "BoundaryCurves.h"

#include <array>
#include <vector>

namespace crossfield
{
/// A point of a quad mesh.
struct QuadPoint
{
  Point place = Point::Zero();
  CurvePlace curve;   ///< On the boundary, where.
  bool fixed = false; ///< A corner of the boundary, or a singularity.
  int cone = -1;      ///< In FlatMap::cones.
  int asked = 0;      ///< Quarter index of the cone, else 0.
  double scale = 1.0; ///< Wanted size there, over the mesh's: e^H but for WantSizes.
  int valence = 0;    ///< Number of quads.
};

/// An edge of the boundary, with the domain on its left.
struct QuadBoundaryEdge
{
  std::array<int, 2> points{};
  BoundaryKind kind = BoundaryKind::Outer;
  int id = 0;
};

/// An all-quad mesh, quads counter-clockwise.
struct QuadMesh
{
  std::vector<QuadPoint> points;
  std::vector<std::array<int, 4>> quads;
  /// Per quad the lengths wanted of its sides 01 (and 23) and 12 (and 30).
  std::vector<std::array<double, 2>> wanted;
  std::vector<int> face; ///< Of the T-mesh, per quad.
  std::vector<QuadBoundaryEdge> boundary;

  /// Points − edges + quads. Throws Error when an edge has more than two quads, or a quad a point twice.
  int EulerCharacteristic() const;
};
}
