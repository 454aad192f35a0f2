#pragma once

#include "Plane.h"

#include <vector>

namespace crossfield
{
/// The order of points along Hilbert's curve through 2²⁰ × 2²⁰ cells of a square around them: neighbours in the order are near to each
/// other. Those of one cell keep their order.
std::vector<int> HilbertOrder(const std::vector<Point>& points);
}
