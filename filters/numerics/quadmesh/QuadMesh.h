#pragma once

#include "BoundaryCurves.h"
#include "BoundaryKind.h"
#include "PairedSides.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// A point of a quad mesh.
struct QuadPoint
{
  SpacePoint place = SpacePoint::Zero(); ///< Position; in the plane, z is 0.
  CurvePlace curve;                      ///< Position on the boundary, if the point is there.
  /// Set for corners of the boundary, ends of sides, singularities, and points that PlaceOnSides moved.
  bool fixed = false;
  /// Set for points that divide a closed side as prescribed and may turn along it together.
  bool turns = false;
  bool held =
    false;       ///< Set for fixed points that stay where they are even if singularities may move.
  int cone = -1; ///< Index in SeamlessMap::cones, −1 if it is none.
  int quarterIndex = 0; ///< Requested quarter index: that of the cone, else 0.
  int valence = 0;      ///< Number of quads.
  /// Target size over that of the mesh: e^H unless SetTargetLengths changes it.
  double scale = 1.0;
  int triangle = -1; ///< Triangle that a draft point is in; −1 if it is not known.

  /// Returns the position in the plane.
  Point InPlane() const { return this->place.head<2>(); }
  /// Moves the point in the plane.
  void MoveTo(const Point& target) { this->place << target, 0.0; }
  /// Moves the point to its position on the boundary.
  void MoveToCurve(const BoundaryCurves& curves)
  {
    this->place = curves.PlaceAt(this->curve);
    this->triangle = curves.TriangleAt(this->curve, this->triangle);
  }
};

/// A boundary edge, with the domain on its left.
struct QuadBoundaryEdge
{
  std::array<int, 2> points{};
  BoundaryKind kind = BoundaryKind::Outer;
  int id = 0;
  int side = -1;  ///< Index in QuadMesh::sideNames, −1 if the boundary has no names.
  int curve = -1; ///< Index in CurvedBoundary::curves, −1 if the edge is on a polyline.
};

/// An all-quad mesh. Quads are counter-clockwise.
struct QuadMesh
{
  std::vector<QuadPoint> points;
  std::vector<std::array<int, 4>> quads;
  /// Per quad, the target lengths of its sides 01 (and 23) and 12 (and 30).
  std::vector<std::array<double, 2>> targetLengths;
  std::vector<int> patch;                 ///< Patch of the T-mesh, per quad.
  std::vector<SpacePoint> normals;        ///< Per quad that of the surface; empty in the plane.
  std::vector<QuadBoundaryEdge> boundary; ///< Edge after edge along every loop.
  std::vector<std::string> sideNames;     ///< Names of the sides of the boundary.
  std::vector<PairedSides> periodic;      ///< Sides whose paired points move together.

  /// Returns for every side the opposite side of the same edge, −1 on the boundary. Side s of quad
  /// q has number 4 q + s and leads from corner s to corner s + 1 with the quad on its left. Throws
  /// Error if an edge has more than two quads, or a quad has a point twice. Cost: linear in quads.
  std::vector<int> Twins() const;
  /// Returns points − edges + quads. Throws Error as Twins does.
  int EulerCharacteristic() const;
};
}
