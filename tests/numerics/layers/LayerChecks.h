#pragma once

#include "QuadMesher.h"

namespace crossfield::test
{
/// Checks that every quad is in one block at its column and row, and that every side of a block is
/// on the boundary or a complete side of another block.
void ExpectSoundBlocks(const QuadResult& result);
}
