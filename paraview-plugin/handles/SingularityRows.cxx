#include "SingularityRows.h"

#include <algorithm>
#include <cmath>

std::vector<SingularityRow> RowsOf(const std::vector<double>& numbers)
{
  std::vector<SingularityRow> rows(numbers.size() / 4);
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    std::copy_n(numbers.data() + 4 * i, 4, rows[i].begin());
  }
  return rows;
}

std::vector<double> NumbersOf(const std::vector<SingularityRow>& rows)
{
  std::vector<double> numbers;
  numbers.reserve(4 * rows.size());
  for (const SingularityRow& row : rows)
  {
    numbers.insert(numbers.end(), row.begin(), row.end());
  }
  return numbers;
}

int QuarterIndexOf(const SingularityRow& row)
{
  return static_cast<int>(std::lround(row[2]));
}

bool HaveSamePositions(const std::vector<SingularityRow>& rows,
  const std::vector<SingularityRow>& others, bool areOnSurface)
{
  const auto heightOf = [areOnSurface](const SingularityRow& row)
  { return areOnSurface ? row[3] : 0.0; };
  double largest = 0;
  for (const SingularityRow& row : rows)
  {
    largest =
      std::max({ largest, std::abs(row[0]), std::abs(row[1]), std::abs(heightOf(row)) });
  }
  const auto areSame = [&](const SingularityRow& row, const SingularityRow& other)
  {
    return QuarterIndexOf(row) == QuarterIndexOf(other) &&
      std::hypot(row[0] - other[0], row[1] - other[1], heightOf(row) - heightOf(other)) <=
      1e-9 * largest;
  };
  return std::equal(rows.begin(), rows.end(), others.begin(), others.end(), areSame);
}

std::array<double, 2> FindFreePosition(
  const std::vector<SingularityRow>& rows, const std::array<double, 2>& preferred, double distance)
{
  const double goldenAngle = 2.399963229728653; // 180° (3 - √5)
  std::array<double, 2> position = preferred;
  const auto isTaken = [&](const SingularityRow& row)
  { return std::hypot(row[0] - position[0], row[1] - position[1]) < distance; };
  // A row excludes π distance² of the plane; the first n positions fill a disc of n π distance² /
  // 4.
  const std::size_t maximum = 16 * (rows.size() + 1);
  for (std::size_t n = 1; n <= maximum && std::any_of(rows.begin(), rows.end(), isTaken); ++n)
  {
    const double radius = distance * std::sqrt(static_cast<double>(n)) / 2;
    const double angle = goldenAngle * static_cast<double>(n);
    position = { preferred[0] + radius * std::cos(angle), preferred[1] + radius * std::sin(angle) };
  }
  return position;
}
