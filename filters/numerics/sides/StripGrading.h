#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Multiplies the target lengths in the strips of boundary edges so that they become the lengths of
/// these edges: along a strip by one factor or, if both of its ends are given, by a geometric mean
/// of two.
void GradeStrips(const std::vector<const QuadBoundaryEdge*>& edges, QuadMesh& mesh);
}
