#pragma once

#include "ThinBoundary.h"

namespace crossfield
{
/// Removes waves of a boundary that are shorter than a length (docs/method.md §10.6). Waves of this
/// length along the boundary are reduced to 8 % of their height, waves of twice the length to 70 %,
/// and of four times the length to 97 %.
///
/// Corners farther than the length from all others are retained, and so are the vertices at the
/// points of `keep` on the boundary. Between them the boundary is smoothed if that moves it by more
/// than a thousandth of the length, and gets sides of a quarter of the length. Loops shorter than
/// four lengths are unchanged. Throws Error if the new loops touch.
SimplifiedBoundary SmoothBoundary(const PlanarDomain& domain, double length,
  const std::vector<Point>& keep = {}, double cornerAngle = DefaultCornerAngle);
}
