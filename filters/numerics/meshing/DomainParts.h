#pragma once

#include "PlanarDomain.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Divides boundary loops, given in any order and orientation, into the connected parts of what they enclose, the
/// largest area first, and those of the same area, up to a thousandth, from left to right: each
/// outer loop with the inner loops directly inside it. A loop inside an inner loop is the outer
/// loop of another part. Throws Error as MakePlanarDomain does.
std::vector<PlanarDomain> SplitParts(const std::vector<Loop>& loops);

/// Returns the index of the part that a text stands for, "largest" or a number from 1; −1 if it is another text.
/// Throws Error if there are fewer parts.
int PartOf(const std::string& text, std::size_t parts);
}
