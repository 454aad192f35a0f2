#pragma once

#include "Drawing.h"

#include <string_view>
#include <vector>

namespace crossfield
{
/// Reads the numbers of an SVG attribute, separated by blanks or commas. Throws Error for anything
/// else.
std::vector<double> SvgNumbers(std::string_view text);

/// Returns the pieces of the path data of SVG, with the commands M L H V C S Q T A Z, absolute and
/// relative, in the coordinates of the path. Throws Error, with the position in the data, if they are
/// not valid.
std::vector<DrawingPiece> SvgPath(std::string_view data);

/// Returns an elliptic arc of SVG: from a point to another on an ellipse with the radii rx and ry,
/// whose x axis is turned by an angle in degrees. Radii that are too small are scaled up.
DrawingPiece SvgArc(const Point& first, const Point& last, const Point& radii, double degrees,
  bool isLarge, bool isPositive);
}
