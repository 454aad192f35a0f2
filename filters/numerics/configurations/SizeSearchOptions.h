#pragma once

#include "BoundaryCorners.h"
#include "Singularity.h"
#include "TargetSize.h"

#include <functional>

namespace crossfield
{
/// What singularities are searched for (SizedConfigurations.h).
struct SizeSearchOptions
{
  /// Target side length of quads. Its logarithm varies slowly from quad to quad.
  SizeFunction size;
  std::vector<CornerChoice> corners;
  double cornerAngle = DefaultCornerAngle;
  /// Whether singularities may be at a position; absent: anywhere 1.3 sizes from the boundary.
  std::function<bool(const Point&)> isFree;
  Configuration given; ///< Singularities that stay; the others are added to them.
};
}
