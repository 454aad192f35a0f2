#pragma once

#include "StraightQuads.h"

namespace crossfield
{
/// Returns for each boundary edge the edge of the first of two periodic sides whose image it is, −1 if it
/// is on no second side. Throws Error if an image has no edge within 1e-9 of the extent.
std::vector<int> MatchEdges(const StraightQuads& quads);
}
