#pragma once

#include "MeshBoundary.h"
#include "QuadMesh.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Moves to each place the nearest point of a mesh that may move, and holds it there. For places on the
/// boundary, which are within BoundaryReach of it, or SlitWidth where there are slits, these are points of
/// the boundary, otherwise points inside. Throws Error if that moves a point by more than its longest edge.
void PlaceNodes(const MeshBoundary& curves, const std::vector<Point>& places, QuadMesh& mesh);

/// Returns a warning about places without a node, otherwise an empty text.
std::string DescribeMissedPlaces(const std::vector<Point>& places, const QuadMesh& mesh);
}
