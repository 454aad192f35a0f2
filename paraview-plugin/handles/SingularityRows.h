/**
 * Rows of singularities as the property of a proxy holds them, and places for new ones.
 */

#ifndef SingularityRows_h
#define SingularityRows_h

#include <array>
#include <cstddef>
#include <vector>

/** x, y, quarter index, radius of the hole. */
using SingularityRow = std::array<double, 4>;

/** The rows of a flat list of numbers; what is left over at its end is no row. */
std::vector<SingularityRow> RowsOf(const std::vector<double>& numbers);

/** The inverse of RowsOf. */
std::vector<double> NumbersOf(const std::vector<SingularityRow>& rows);

/** The quarter index of a row, which a property keeps as a double, rounded to an integer. */
int QuarterIndexOf(const SingularityRow& row);

/**
 * Whether two lists have the same quarter indices at the same places, up to the rounding of a filter that
 * has turned them into a plane and back: 1e-9 of the largest coordinate. Radii do not count.
 */
bool HaveSamePlaces(
  const std::vector<SingularityRow>& rows, const std::vector<SingularityRow>& others);

/**
 * A place that is at least `distance` from every row: `wanted` itself, or the first such place on the
 * sunflower spiral around it, r = distance √n / 2 at the n-th multiple of the golden angle. Each turn of
 * it visits new places, so that one is found after a number of steps proportional to that of the rows.
 */
std::array<double, 2> FreePlace(
  const std::vector<SingularityRow>& rows, const std::array<double, 2>& wanted, double distance);

#endif
