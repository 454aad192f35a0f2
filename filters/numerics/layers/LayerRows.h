#pragma once

#include <vector>

namespace crossfield
{
/// Returns the number of rows whose heights grow by `growth` ≥ 1 from `first` until they fill a
/// length: ⌈ln(1 + S (g − 1)/a) / ln g⌉, and ⌈S/a⌉ for g = 1 (docs/method.md §16.2).
int RowsToFill(double length, double first, double growth);

/// Returns the growth r with which `rows` rows from `first` fill a length: a (r^N − 1)/(r − 1) = S.
/// It is below 1 if N a > S. Requires positive lengths and S > a.
double GrowthToFill(double length, double first, int rows);

/// Returns the ends of the rows, as lengths from the wall: N numbers; the last one is `length`.
std::vector<double> RowEnds(double length, double first, int rows);

/// Returns the number of rows of equal height that rows growing by `growth` may replace, so that
/// the last of them is about as high as the next row outside: ⌈1/(g − 1)⌉, and 1 for g = 1, where
/// no number is better than another.
int RowsToReplace(double growth);
}
