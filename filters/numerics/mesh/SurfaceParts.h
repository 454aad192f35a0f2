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

/// Returns the area of a triangle.
double AreaOf(const SurfaceMesh& surface, std::size_t triangle);
/// Returns that of all.
double AreaOf(const SurfaceMesh& surface);

/// Returns the triangle across each side (p_i to p_i+1) of the triangles, −1 on the boundary. Throws Error, with a
/// place, if an edge has more than two triangles.
std::vector<std::array<int, 3>> FindNeighbours(const SurfaceMesh& surface);

/// Divides triangles, whose equal points are merged, into connected parts that are manifold, consistently oriented
/// and without degenerate triangles (docs/method.md §22.6). Triangles with a point twice, or given twice, are
/// removed. A flat triangle is removed, and the triangle beyond its longest side is divided instead. Closed parts are
/// oriented outwards, others as most of their triangles. A point where several fans of triangles touch becomes one
/// point for each fan. Triangles keep their regions and lines.
///
/// Throws Error, with a place, if an edge has more than two triangles, if a part is not orientable, or if its
/// boundary touches itself in a point.
SurfaceParts FindSurfaceParts(SurfaceMesh surface);
}
