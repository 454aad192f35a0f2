#pragma once

#include "Plane.h"

#include <functional>

namespace crossfield
{
/// Wanted size of quads at a point of the plane. As a rule only its proportions count.
using SizeFunction = std::function<double(const Point&)>;

/// Throws Error where it is not a positive number.
double TargetSize(const SizeFunction& sizes, const Point& place);
}
