#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Reads the boundary of a mesh of Gmsh, in format 2.2 or 4.1, ASCII or binary: its lines, or, if it
/// has triangles or quadrilaterals, the edges that belong to one of them only. The name of a side is
/// that of the physical group of its lines, or the number of the group if it has no name. Edges of
/// higher order are polylines through their nodes. The mesh may be in any plane of space. If its faces
/// have several physical groups, these are their materials (Drawing::faces).
///
/// Throws Error if the text is not a complete .msh file of these formats, if the mesh has volumes or
/// neither lines nor faces, or if it is not planar.
Drawing ReadMsh(std::string_view text, const std::string& file);
}
