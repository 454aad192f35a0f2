#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Makes the meshes of regions one conforming mesh: the nodes of pairs that are both sides of interfaces
/// become one point each, and of their edges that of the first side is kept, of kind Interface and without
/// a number. The sides of open interfaces, and other pairs, are kept. Sides of equal names become one, and
/// boundary edges have the loops of the whole; positions of points along loops are no longer valid. Points
/// keep their order. The quarter index of a point follows from its number of quads: 4 − valence inside,
/// 2 − valence on the boundary.
void WeldRegions(QuadMesh& mesh);
}
