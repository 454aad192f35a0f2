#pragma once

#include "SurfaceMesh.h"

#include <string>

namespace crossfield
{
/// Angle between the normals of two triangles, in radians, above which their common edge is sharp: 35°. Less is a
/// curved surface with large triangles.
constexpr double DefaultFeatureAngle = 35.0 * Pi / 180.0;

/// The sharp edges of a surface, which divide it into faces.
struct FeatureEdges
{
  std::vector<std::array<bool, 3>> isFeature; ///< Per triangle and side.
  std::size_t count = 0;                      ///< Number of edges.
  std::vector<std::string> events;            ///< One sentence for each kind of change.
};

/// Finds the sharp edges of a connected, oriented manifold surface (docs/method.md §22.12): edges inside whose
/// triangles' normals differ by more than an angle, in radians, and, whatever their angle, those between two
/// regions and of named lines. A line of them that ends is continued across a
/// gap of at most four edges that are bent by at least half the angle, if the line is longer than the gap; other
/// lines that end inside of the surface are left out, and all lines if less than half of the length remains, as
/// on a scan; lines between regions and named ones stay. Faces smaller than 1e-4 of the surface are joined to the neighbour with which they share the
/// longest line.
FeatureEdges FindFeatureEdges(const SurfaceMesh& surface, double angle);

/// Joins faces to the neighbour with which they share the longest line. `faceOf` gives the face of each triangle,
/// and `joins` which are joined.
void MergeFaces(const SurfaceMesh& surface, const std::vector<int>& faceOf,
  const std::vector<bool>& joins, FeatureEdges& features);
}
