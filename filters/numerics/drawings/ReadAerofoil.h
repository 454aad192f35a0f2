#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Returns whether a text is an aerofoil in Selig's or Lednicer's format: a line with a name, then x
/// and y in each line, separated by blanks or commas, from the trailing edge around the leading edge, where x has its only
/// minimum, back to the trailing edge; or the numbers of points of both sides, then each side from
/// the leading edge. Texts before and after the points, rows with another number of columns, such as the bounds
/// in files of MSES, and columns after the second are left out. Other lists of points, such as a polygon,
/// are not aerofoils.
bool IsAerofoil(std::string_view text);

/// Reads an aerofoil as a cubic spline through its points. Ends further apart than 1e-5 of the chord
/// are joined by a straight trailing edge. If the ends agree and the profile turns there by less
/// than 30°, the spline is periodic. A warning counts what is left out. Throws Error if IsAerofoil is
/// false.
Drawing ReadAerofoil(std::string_view text, const std::string& file);
}
