#pragma once

#include "Drawing.h"

#include <string>
#include <string_view>

namespace crossfield
{
/// Returns whether a text is an aerofoil in Selig's or Lednicer's format: a line with a name, then x
/// and y in each line, from the trailing edge around the leading edge, where x has its only
/// minimum, back to the trailing edge; or the numbers of points of both sides, then each side from
/// the leading edge. Other lists of points, such as a polygon, are not aerofoils.
bool IsAerofoil(std::string_view text);

/// Reads an aerofoil as a cubic spline through its points. Ends further apart than 1e-5 of the chord
/// are joined by a straight trailing edge. If the ends agree and the profile turns there by less
/// than 30°, the spline is periodic. Throws Error if IsAerofoil is false.
Drawing ReadAerofoil(std::string_view text, const std::string& file);
}
