#pragma once

#include "Plane.h"

#include <functional>

namespace crossfield
{
/// Target size of quads at a point of the plane. Usually only its proportions matter.
using SizeFunction = std::function<double(const Point&)>;

/// Returns the target size at a point; throws Error if it is not a positive number.
double TargetSize(const SizeFunction& sizes, const Point& place);
}
