#pragma once

#include "BoundaryCorners.h"
#include "QuadQuality.h"
#include "QuadSmoothing.h"
#include "SurfaceMesh.h"

namespace crossfield
{
/// A quad mesh from any program, in the plane z = 0 or on a surface. Points that no quad has are allowed.
struct PlainQuads
{
  std::vector<SpacePoint> points;
  std::vector<std::array<int, 4>> quads; ///< In either orientation.
};

struct MeshSmoothingOptions
{
  /// Points of the boundary slide along the polyline of its edges, corners stay; otherwise all points
  /// of the boundary stay.
  bool slides = true;
  double cornerAngle = DefaultCornerAngle; ///< In radians; turns by more are corners.
  /// Quads should have the same size; otherwise the size that they have.
  bool uniform = false;
};

struct SmoothedMesh
{
  std::vector<SpacePoint> points; ///< In the order of the input.
  QuadQuality before;             ///< With quads that are counter-clockwise.
  QuadQuality after;
};

/// Smooths a quad mesh with SmoothQuads (docs/method.md §14.5). Irregular points inside move, too.
/// Neighbours are oriented alike, and the total area of each connected part is positive.
///
/// On a surface, points are moved to it first. Points on the boundary slide along the polyline of its edges and then move
/// to the surface, to its boundary if all of them were near it.
///
/// The number of inverted quads never increases. Without `uniform`, the minimum scaled Jacobian does not
/// decrease if no quad of the input is inverted. Throws Error if there is no quad, a quad has a point twice, an edge has more than two quads, a part cannot be
/// oriented or has no area, the boundary touches itself in a point, and as QuadsOnSurface does.
SmoothedMesh SmoothMesh(const PlainQuads& mesh, const MeshSmoothingOptions& options,
  const Progress& progress = {}, const SurfaceMesh* surface = nullptr);
}
