#pragma once

#include "SurfaceMesh.h"

#include <string>

namespace crossfield
{
/// The connected parts of a surface, and what was repaired.
struct SurfaceParts
{
  std::vector<SurfaceMesh> parts;  ///< The largest area first.
  std::vector<std::string> events; ///< One sentence for each kind of repair.
};

/// Returns whether a triangle has no area beyond rounding: a height below 1e-12 of its longest side.
bool IsFlat(const SurfaceMesh& surface, const std::array<int, 3>& triangle);

/// Returns the triangle across each side (p_i to p_i+1) of the triangles, −1 on the boundary. Throws Error, with a place, if
/// an edge has more than two triangles.
std::vector<std::array<int, 3>> FindNeighbours(const SurfaceMesh& surface);

/// Makes manifold, consistently oriented parts without degenerate triangles of triangles whose equal points are
/// merged (docs/method.md §22.6). Triangles with a point twice, or given twice, are removed; a flat one is removed and
/// the triangle beyond its longest side divided instead; closed parts turn their outside outwards, others keep the
/// orientation of most triangles; a point in which fans of triangles touch becomes one for each.
///
/// Throws Error, with a place, if an edge has more than two triangles, if a part has no two sides, as a Möbius strip, or
/// if its boundary touches itself in a point.
SurfaceParts FindSurfaceParts(SurfaceMesh surface);
}
