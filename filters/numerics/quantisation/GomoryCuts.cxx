#include "GomoryCuts.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
class CutGenerator
{
public:
  CutGenerator(const LinearSolver& program, const std::vector<char>& isCut)
    : Program(program)
    , IsCut(isCut)
    , Sums(Index(program.CountColumns()), 0.0)
  {
  }

  /// Returns the cut of one basic column, or nothing if rounding errors could invalidate it.
  std::optional<LinearRow> MakeCut(int column)
  {
    std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
    const double value = this->Program.GetValue(column);
    const double fraction = value - std::floor(value);
    this->Rhs = fraction;
    this->Program.GetTableauRow(column, this->Tableau);
    for (const TableauEntry& entry : this->Tableau)
    {
      this->AddEntry(entry, fraction);
    }
    return this->MakeRow();
  }

private:
  /// Adds the term of a nonbasic variable, with slack t ≥ 0 the distance of the variable from its
  /// bound.
  void AddEntry(const TableauEntry& entry, double fraction)
  {
    const BasisStatus status = entry.isRow ? this->Program.GetRowStatus(entry.index)
                                           : this->Program.GetColumnStatus(entry.index);
    if (status == BasisStatus::Fixed)
    {
      return;
    }
    const bool isLow = status == BasisStatus::AtLower;
    const bool isIntegral = !entry.isRow || this->IsCut[entry.index] == 0;
    double coefficient = CutCoefficient(isLow ? -entry.factor : entry.factor, fraction, isIntegral);
    if (!isLow)
    {
      coefficient = -coefficient;
    }
    // Integral factors leave rounding errors.
    constexpr double Rounding = 1e-9;
    if (std::abs(coefficient) < Rounding)
    {
      return;
    }
    if (!entry.isRow)
    {
      const VariableBounds bounds = this->Program.GetBounds(entry.index);
      this->Rhs += coefficient * (isLow ? bounds.lower : bounds.upper);
      this->Sums[entry.index] += coefficient;
      return;
    }
    this->Program.GetRow(entry.index, this->Row);
    this->Rhs += coefficient * this->Row.rhs;
    for (std::size_t i = 0; i < this->Row.columns.size(); ++i)
    {
      this->Sums[this->Row.columns[i]] += coefficient * this->Row.values[i];
    }
  }

  /// Returns the coefficient of slack t in the cut Σ coefficient · t ≥ fraction of the row column +
  /// Σ factor · t = value.
  static double CutCoefficient(double factor, double fraction, bool isIntegral)
  {
    const double ratio = fraction / (1.0 - fraction);
    if (!isIntegral)
    {
      return factor >= 0.0 ? factor : -factor * ratio;
    }
    const double part = factor - std::floor(factor);
    return part <= fraction ? part : (1.0 - part) * ratio;
  }

  /// Returns the cut in the columns. Small coefficients are relaxed to a bound of their column.
  std::optional<LinearRow> MakeRow() const
  {
    double largest = 0.0;
    for (const double sum : this->Sums)
    {
      largest = std::max(largest, std::abs(sum));
    }
    LinearRow cut;
    cut.rhs = this->Rhs;
    for (int column = 0; column < this->Program.CountColumns(); ++column)
    {
      // A large range of coefficients makes the simplex method inaccurate.
      constexpr double SmallestRatio = 1e-4;
      const double sum = this->Sums[column];
      if (sum == 0.0)
      {
        continue;
      }
      const VariableBounds bounds = this->Program.GetBounds(column);
      if (bounds.lower < bounds.upper && std::abs(sum) > SmallestRatio * largest)
      {
        cut.columns.push_back(column);
        cut.values.push_back(sum);
        continue;
      }
      if (sum > 0.0 && bounds.upper == Unbounded)
      {
        return std::nullopt; // the term cannot be relaxed
      }
      cut.rhs -= sum * (sum > 0.0 ? bounds.upper : bounds.lower);
    }
    return cut.columns.empty() ? std::nullopt : std::optional<LinearRow>(std::move(cut));
  }

  const LinearSolver& Program;
  const std::vector<char>& IsCut;
  double Rhs = 0.0;
  std::vector<double> Sums; ///< Coefficients of the cut, per column.
  std::vector<TableauEntry> Tableau;
  LinearRow Row;
};

/// Returns the distance of the present optimum from the hyperplane of a cut.
double DepthOf(const LinearRow& cut, const LinearSolver& program)
{
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < cut.columns.size(); ++i)
  {
    sum += cut.values[i] * program.GetValue(cut.columns[i]);
    square += cut.values[i] * cut.values[i];
  }
  return (cut.rhs - sum) / std::sqrt(square);
}
}

std::vector<LinearRow> GomoryCuts(const LinearSolver& program, const std::vector<char>& isCut)
{
  // Nearly integral values give shallow cuts with very large coefficients.
  constexpr double NearlyIntegral = 5e-3;
  constexpr double MinimumDepth = 1e-3;
  // Every node of the search carries all cuts: without this limit nodes took five times as long,
  // and the bound was no better.
  constexpr std::size_t MaximumLength = 400;
  // Further cuts of a round are nearly redundant.
  constexpr std::size_t MaximumCuts = 150;
  CutGenerator generator(program, isCut);
  std::vector<std::pair<double, LinearRow>> cuts;
  for (int column = 0; column < program.CountColumns(); ++column)
  {
    const double value = program.GetValue(column);
    if (program.GetColumnStatus(column) != BasisStatus::Basic ||
      std::abs(value - std::round(value)) < NearlyIntegral)
    {
      continue;
    }
    std::optional<LinearRow> cut = generator.MakeCut(column);
    if (cut && cut->columns.size() <= MaximumLength)
    {
      const double depth = DepthOf(*cut, program);
      if (depth > MinimumDepth)
      {
        cuts.emplace_back(depth, std::move(*cut));
      }
    }
  }
  std::stable_sort(
    cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<LinearRow> deepest;
  for (auto& cut : cuts)
  {
    if (deepest.size() < MaximumCuts)
    {
      deepest.push_back(std::move(cut.second));
    }
  }
  return deepest;
}
}
