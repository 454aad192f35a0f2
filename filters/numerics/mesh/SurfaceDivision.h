#pragma once

#include "SurfaceMesh.h"

namespace crossfield
{
/// Returns the same surface with each triangle divided into four at the midpoints of its sides; the points of the given one come
/// first.
SurfaceMesh Divided(const SurfaceMesh& surface);
}
