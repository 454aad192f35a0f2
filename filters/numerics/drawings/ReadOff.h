#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Reads the boundary of a mesh in an .off file of ASCII (OFF, COFF, NOFF ...): the edges that belong to one polygon
/// only. The mesh may be in any plane of space.
///
/// Throws Error with the line if the text has another form, if the mesh has no boundary, or if it is not planar.
Drawing ReadOff(std::string_view text, const std::string& file);
}
