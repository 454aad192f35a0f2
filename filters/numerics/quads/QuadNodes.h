#pragma once

#include "MeshBoundary.h"
#include "QuadMesh.h"

namespace crossfield
{
/// Sets the valences of a mesh of a domain with a topology. Throws Error if the quads do not cover it,
/// or a node has not the number of quads that its quarter index requests.
void CountValences(const MeshTopology& topology, QuadMesh& mesh);

/// Moves the nearest boundary point to every corner that is not a cone.
void FixCorners(const MeshBoundary& curves, QuadMesh& mesh);
}
