/**
 * Rows of singularities as stored in the property of a proxy, and positions for new ones.
 */

#ifndef SingularityRows_h
#define SingularityRows_h

#include <array>
#include <cstddef>
#include <vector>

/** Position x and y, quarter index, and radius of the hole, or z on a surface. */
using SingularityRow = std::array<double, 4>;

/** Splits a flat list of numbers into rows; an incomplete row at the end is dropped. */
std::vector<SingularityRow> RowsOf(const std::vector<double>& numbers);

/** Returns the flat list of numbers of rows: the inverse of RowsOf. */
std::vector<double> NumbersOf(const std::vector<SingularityRow>& rows);

/**
 * Returns the quarter index of a row, which a property stores as a double, rounded to an integer.
 */
int QuarterIndexOf(const SingularityRow& row);

/**
 * Reports whether two lists have the same quarter indices at the same positions, up to the rounding
 * of a filter that transforms them into a plane and back: 1e-9 of the largest coordinate. Radii are
 * ignored, z is not.
 */
bool HaveSamePositions(const std::vector<SingularityRow>& rows,
  const std::vector<SingularityRow>& others, bool areOnSurface);

/**
 * Returns a position at a distance of at least `distance` from every row: `preferred` itself, or
 * the first such position on the sunflower spiral around it, r = distance √n / 2 at the n-th
 * multiple of the golden angle. The spiral does not revisit positions, so the number of steps is
 * proportional to that of the rows.
 */
std::array<double, 2> FindFreePosition(
  const std::vector<SingularityRow>& rows, const std::array<double, 2>& preferred, double distance);

#endif
