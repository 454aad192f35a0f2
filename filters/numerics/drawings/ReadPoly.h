#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Reads the segments of a .poly file of Triangle: points, segments and holes, with comments after #. A segment with a
/// boundary marker other than 0 has it as name. Closed curves inside others
/// are holes, whatever the file says; a warning says so if the numbers of holes and curves do not fit. Regions are left out.
///
/// Throws Error with the line if the text has another form, or if the points are in a .node file of their own.
Drawing ReadPoly(std::string_view text, const std::string& file);
}
