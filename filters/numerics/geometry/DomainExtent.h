#pragma once

namespace crossfield
{
/// Lengths whose fourth powers, and those of a billionth of them, are floating-point numbers.
constexpr double SmallestExtent = 1e-60;
constexpr double LargestExtent = 1e60;

/// Throws Error when the larger side of a domain's bounding box is beyond these; 0 is left to others.
void RequireExtent(double extent);
}
