#pragma once

#include "BoundarySymmetry.h"
#include "TMesh.h"

namespace crossfield
{
/// Returns the image of each arc of a T-mesh in the plane under an isometry that maps the T-mesh to
/// itself: nodes, arcs and patches to such with the same angles, and nodes to places at most
/// `reach` from their images. Returns none if there is no such map.
std::vector<int> FindArcImages(const TMesh& mesh, const Isometry& isometry, double reach);
}
