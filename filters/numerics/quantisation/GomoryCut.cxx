#include "GomoryCut.h"

#include "Index.h"

#include <glpk.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// A row of coefficients as GLPK writes it, from 1 on.
struct Entries
{
  explicit Entries(int most)
    : indices(Index(most) + 1)
    , values(indices.size())
  {
  }

  std::vector<int> indices;
  std::vector<double> values;
};

class Generator
{
public:
  Generator(glp_prob& problem, const std::vector<char>& isCut)
    : Problem(problem)
    , IsCut(isCut)
    , Rows(glp_get_num_rows(&problem))
    , Columns(glp_get_num_cols(&problem))
    , Sums(Index(this->Columns) + 1, 0.0)
    , Tableau(this->Rows + this->Columns)
    , Row(this->Columns)
  {
  }

  /// Of one basic column. Nothing where rounding could spoil it.
  std::optional<CutRow> Make(int column)
  {
    std::fill(this->Sums.begin(), this->Sums.end(), 0.0);
    const double value = glp_get_col_prim(&this->Problem, column);
    const double fraction = value - std::floor(value);
    this->Least = fraction;
    const int length = glp_eval_tab_row(&this->Problem, this->Rows + column,
      this->Tableau.indices.data(), this->Tableau.values.data());
    for (int i = 1; i <= length; ++i)
    {
      this->AddTerm(this->Tableau.indices[Index(i)], this->Tableau.values[Index(i)], fraction);
    }
    return this->Collect();
  }

private:
  /// The column is value + Σ factor · (row or column k).
  void AddTerm(int k, double factor, double fraction)
  {
    const bool isRow = k <= this->Rows;
    const int index = isRow ? k : k - this->Rows;
    const int state =
      isRow ? glp_get_row_stat(&this->Problem, index) : glp_get_col_stat(&this->Problem, index);
    if (state == GLP_NS)
    {
      return; // has one value
    }
    const bool isLow = state == GLP_NL;
    const bool isIntegral = !isRow || this->IsCut[Index(index) - 1] == 0;
    // In t ≥ 0, how far k is from its bound.
    double share = Share(isLow ? -factor : factor, fraction, isIntegral);
    if (!isLow)
    {
      share = -share;
    }
    // What rounding makes of whole factors.
    constexpr double Rounding = 1e-9;
    if (std::abs(share) < Rounding)
    {
      return;
    }
    if (!isRow)
    {
      this->Least += share *
        (isLow ? glp_get_col_lb(&this->Problem, index) : glp_get_col_ub(&this->Problem, index));
      this->Sums[Index(index)] += share;
      return;
    }
    this->Least += share *
      (isLow ? glp_get_row_lb(&this->Problem, index) : glp_get_row_ub(&this->Problem, index));
    const int length =
      glp_get_mat_row(&this->Problem, index, this->Row.indices.data(), this->Row.values.data());
    for (int i = 1; i <= length; ++i)
    {
      this->Sums[Index(this->Row.indices[Index(i)])] += share * this->Row.values[Index(i)];
    }
  }

  /// Of t in Σ share t ≥ fraction, where column + Σ factor t = value.
  static double Share(double factor, double fraction, bool isIntegral)
  {
    const double others = fraction / (1.0 - fraction);
    if (!isIntegral)
    {
      return factor >= 0.0 ? factor : -factor * others;
    }
    const double rest = factor - std::floor(factor);
    return rest <= fraction ? rest : (1.0 - rest) * others;
  }

  std::optional<CutRow> Collect() const
  {
    double largest = 0.0;
    for (const double sum : this->Sums)
    {
      largest = std::max(largest, std::abs(sum));
    }
    CutRow cut;
    cut.least = this->Least;
    for (int column = 1; column <= this->Columns; ++column)
    {
      // Coefficients of very different sizes make the simplex method inexact.
      constexpr double LeastRatio = 1e-4;
      const double sum = this->Sums[Index(column)];
      const int kind = glp_get_col_type(&this->Problem, column);
      if (sum == 0.0)
      {
        continue;
      }
      if (kind != GLP_FX && std::abs(sum) > LeastRatio * largest)
      {
        cut.columns.push_back(column);
        cut.values.push_back(sum);
        continue;
      }
      if (sum > 0.0 && kind == GLP_LO)
      {
        return std::nullopt; // nothing bounds what would be left out
      }
      cut.least -= sum *
        (sum > 0.0 ? glp_get_col_ub(&this->Problem, column)
                   : glp_get_col_lb(&this->Problem, column));
    }
    return cut.columns.empty() ? std::nullopt : std::optional<CutRow>(std::move(cut));
  }

  glp_prob& Problem;
  const std::vector<char>& IsCut;
  const int Rows;
  const int Columns;
  double Least = 0.0;
  std::vector<double> Sums; ///< Per column, from 1 on.
  Entries Tableau;
  Entries Row;
};

/// How far a cut moves the solution at least.
double DepthOf(const CutRow& cut, glp_prob& problem)
{
  double sum = 0.0;
  double square = 0.0;
  for (std::size_t i = 0; i < cut.columns.size(); ++i)
  {
    sum += cut.values[i] * glp_get_col_prim(&problem, cut.columns[i]);
    square += cut.values[i] * cut.values[i];
  }
  return (cut.least - sum) / std::sqrt(square);
}
}

std::vector<CutRow> GomoryCuts(glp_prob& problem, const std::vector<char>& isCut)
{
  // What is nearly whole makes cuts that are nearly nothing, with factors that are nearly infinite.
  constexpr double NearlyIntegral = 5e-3;
  constexpr double LeastDepth = 1e-3;
  // Each node of the search solves all of them: with any length nodes took five times as long, and the bound was no better.
  constexpr std::size_t LongestCut = 400;
  // More of one round say the same.
  constexpr std::size_t MostCuts = 150;
  Generator generator(problem, isCut);
  std::vector<std::pair<double, CutRow>> cuts;
  for (int column = 1; column <= glp_get_num_cols(&problem); ++column)
  {
    const double value = glp_get_col_prim(&problem, column);
    if (glp_get_col_stat(&problem, column) != GLP_BS ||
      std::abs(value - std::round(value)) < NearlyIntegral)
    {
      continue;
    }
    std::optional<CutRow> cut = generator.Make(column);
    if (cut && cut->columns.size() <= LongestCut)
    {
      const double depth = DepthOf(*cut, problem);
      if (depth > LeastDepth)
      {
        cuts.emplace_back(depth, std::move(*cut));
      }
    }
  }
  std::stable_sort(
    cuts.begin(), cuts.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<CutRow> deepest;
  for (auto& cut : cuts)
  {
    if (deepest.size() < MostCuts)
    {
      deepest.push_back(std::move(cut.second));
    }
  }
  return deepest;
}
}
