#pragma once

#include "Plane.h"

#include <array>

namespace crossfield
{
/// Triangles in space.
struct SurfaceMesh
{
  std::vector<SpacePoint> points;
  std::vector<std::array<int, 3>> triangles; ///< Counter-clockwise seen from outside.
};
}
