#pragma once

namespace crossfield
{
/// Bounds of lengths whose fourth powers, and those of a billionth of them, are normal
/// floating-point numbers.
constexpr double SmallestExtent = 1e-60;
constexpr double LargestExtent = 1e60;

/// Throws Error if the larger side of a domain's bounding box is beyond these bounds. An extent of
/// 0 is accepted; other checks refuse it.
void RequireExtent(double extent);
}
