#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Makes the meshes of regions one conforming mesh: the nodes of each pair of both sides of an interface
/// become one point, and of their edges that of the first side is kept, of kind Interface and without a
/// number. Sides of equal names become one, and boundary edges have the loops of the whole; positions of
/// points along loops are no longer valid. Points have new numbers, in their order. The index of a point is that of its number of quads: 4 − valence inside,
/// 2 − valence on the boundary. Returns the new number of each point.
std::vector<int> WeldRegions(QuadMesh& mesh);
}
