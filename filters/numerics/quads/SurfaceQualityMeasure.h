#pragma once

#include "QuadMesh.h"
#include "SurfaceQuality.h"
#include "SurfaceWalk.h"

namespace crossfield
{
/// Measures quads with normals and triangles of their points.
SurfaceQuality MeasureOnSurface(const SurfaceWalk& surface, const QuadMesh& mesh);
}
