#pragma once

#include "SeamlessMap.h"

#include <complex>

namespace crossfield
{
/// Returns e^{4iθ} of the crosses of a triangle in its chart, whose directions are those of the axes of the map.
std::complex<double> CrossOf(const SeamlessMap& map, int triangle);

/// Returns the angle in (−π/4, π/4] by which the axes of a map of a closed surface are to turn, where no
/// boundary fixes them (docs/method.md §22.4). Lines from a singularity should meet others: ways
/// from one to the next (ConeWays.h) vote for their directions, those within 0.05 of each other together, with the inverse of
/// their lengths; votes count more where they fit the principal directions. Without singularities the axes
/// are along the principal directions.
double BestAngle(const SeamlessMap& map);
}
