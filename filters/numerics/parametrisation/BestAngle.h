#pragma once

#include "SeamlessMap.h"

#include <complex>

namespace crossfield
{
/// Returns e^{4iθ} of the crosses of a triangle in its chart, whose directions are those of the axes of the map; 0 if the
/// map has no direction there.
std::complex<double> CrossOf(const SeamlessMap& map, int triangle);

/// Returns the angle in (−π/4, π/4] by which the axes of a map of a closed surface are to turn, where no
/// boundary fixes them (docs/method.md §22.4). Separatrices should end at other singularities: the vectors between
/// neighbouring ones (ConeVectors.h) vote for their directions with the inverse of their lengths. Directions within 0.05
/// support each other, and those that fit the principal directions count more. Without singularities the axes are along
/// the principal directions.
double BestAngle(const SeamlessMap& map);
}
