#pragma once

#include "Plane.h"

namespace crossfield
{
/// Returns the angle in (−π, π] by which a loop turns at a vertex, counter-clockwise positive.
double TurningAt(const Loop& loop, std::size_t vertex);
}
