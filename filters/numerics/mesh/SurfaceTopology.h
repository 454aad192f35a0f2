#pragma once

#include "MeshTopology.h"
#include "SurfaceMesh.h"

namespace crossfield
{
/// The topology of a surface in space, with a chart for each triangle (docs/method.md §22.1). The longest
/// of its boundary loops is the outer one.
struct SurfaceTopology : MeshTopology
{
  /// Computes the derived data. Throws Error, with a place, unless the surface is connected, consistently
  /// oriented, without degenerate triangles and a manifold: at most two triangles at an edge, and one fan
  /// of triangles at a point.
  explicit SurfaceTopology(SurfaceMesh surface);
};
}
