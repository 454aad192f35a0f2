#pragma once

#include "MeshTopology.h"

namespace crossfield
{
/// The meshes of several surfaces as one, which is not connected: vertices, triangles and boundary edges have
/// numbers that continue from part to part.
struct JoinedSurface : MeshTopology
{
  /// `triangles` are those of all parts, one after the other.
  JoinedSurface(TriangleMesh triangles, const std::vector<SharedTopology>& parts);
};
}
