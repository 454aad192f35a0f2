#include "LayerRows.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Part of a row below which a remainder is a rounding error.
constexpr double RowRounding = 1e-6;

/// Returns (r^N − 1)/(r − 1) with r = e^logarithm.
double SumOfRows(double logarithm, int rows)
{
  return std::abs(logarithm) < 1e-12 ? rows : std::expm1(rows * logarithm) / std::expm1(logarithm);
}
}

int RowsToFill(double length, double first, double growth)
{
  const double rows =
    growth == 1.0 ? length / first : std::log1p(length * (growth - 1.0) / first) / std::log(growth);
  return std::max(1, static_cast<int>(std::ceil(rows - RowRounding)));
}

double GrowthToFill(double length, double first, int rows)
{
  if (rows == 1)
  {
    return 1.0;
  }
  // The sum increases with r. It is above N r^((N − 1)/2) and, for r > 1, above r^(N − 1), which
  // bounds ln r from above; for r < 1 it is below 1/(1 − r), which bounds r from below.
  const double wanted = length / first;
  double high = wanted > rows ? std::log(wanted) / (rows - 1) : 0.0;
  double low = wanted > rows ? 0.0 : std::log1p(-1.0 / std::max(wanted, 1.0 + 1e-9)) - 1e-9;
  for (int i = 0; i < 200 && high - low > 1e-15; ++i)
  {
    const double middle = 0.5 * (low + high);
    (SumOfRows(middle, rows) > wanted ? high : low) = middle;
  }
  return std::exp(0.5 * (low + high));
}

std::vector<double> RowEnds(double length, double first, int rows)
{
  const double logarithm = std::log(GrowthToFill(length, first, rows));
  const double total = SumOfRows(logarithm, rows);
  std::vector<double> ends;
  for (int row = 1; row < rows; ++row)
  {
    ends.push_back(length * SumOfRows(logarithm, row) / total);
  }
  ends.push_back(length);
  return ends;
}

int RowsToReplace(double growth)
{
  return growth == 1.0
    ? 1
    : std::max(1, static_cast<int>(std::ceil(1.0 / (growth - 1.0) - RowRounding)));
}
}
