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
  int cone = -1;      ///< In SeamlessMap::cones.
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

  /// Side s of quad q, number 4 q + s, leads from corner s to corner s + 1 with the quad on its left. Of every side the
  /// number of that which runs against it; −1 on the boundary. Throws Error when an edge has more than two quads, or a
  /// quad a point twice. Cost: linear in quads.
  std::vector<int> Twins() const;
  /// Points − edges + quads. Throws Error as Twins.
  int EulerCharacteristic() const;
};
}
