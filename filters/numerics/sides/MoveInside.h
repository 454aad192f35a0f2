#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Moves the points inside along with points of the boundary that were moved: displacements are
/// harmonic on the graph of edges, so that quads stay positive where they can. `hold`: fixed points inside, which
/// are nodes of singularities, stay.
void MoveInside(const std::vector<QuadPoint>& before, bool hold, QuadMesh& mesh);
}
