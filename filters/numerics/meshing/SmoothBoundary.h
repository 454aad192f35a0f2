#pragma once

#include "ThinBoundary.h"

namespace crossfield
{
/// Takes the waves out of a boundary that are shorter than a length (docs/method.md §10.6): of those of this length
/// along it 8 % stay, of twice the length 70 %, of four times 97 %. Corners farther than the length from all others stay,
/// and so do the vertices at the places of `keep` that lie on the boundary; between them the boundary is smoothed where
/// that moves it by more than a thousandth of the length, and gets sides of a quarter of it. Loops shorter
/// than four lengths stay.
///
/// Throws Error where the new loops touch.
SimplifiedBoundary SmoothBoundary(const PlanarDomain& domain, double length,
  const std::vector<Point>& keep = {}, double cornerAngle = DefaultCornerAngle);
}
