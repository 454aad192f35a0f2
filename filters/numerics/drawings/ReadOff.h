#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Reads the boundary of a mesh in an .off file of ASCII (OFF, COFF, NOFF ...): the edges that belong to one polygon
/// only. The mesh may be in any plane of space. If it is in none, reads its polygons as a surface.
///
/// Throws Error with the line if the text has another form, or if a planar mesh has no boundary.
Drawing ReadOff(std::string_view text, const std::string& file);
}
