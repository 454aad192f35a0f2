#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Reads an .svg file: paths, rectangles, circles, ellipses, lines, polylines and polygons, with the
/// transforms of their groups. Coordinates are the user units of the outermost element with y
/// negated, so that the domain looks as the picture does. The name of a side is the id of the
/// shape, or of the nearest group that has one. Definitions, masks and symbols and what is not
/// displayed are not drawn and not read. Open curves of filled shapes are closed by a straight line, as in
/// the picture, with a warning. Other elements, such as texts, images and the references
/// `use`, are left out and counted in a warning. If the outermost element has an absolute size and
/// a `viewBox`, the unit is that of its user units.
///
/// Throws Error if the text is no well-formed XML document of SVG or an attribute is not valid.
Drawing ReadSvg(std::string_view text, const std::string& file);
}
