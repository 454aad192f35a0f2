#pragma once

#include <vector>

struct glp_prob;

namespace crossfield
{
/// Σ value column ≥ least.
struct CutRow
{
  std::vector<int> columns; ///< From 1 on, as GLPK counts.
  std::vector<double> values;
  double least = 0.0;
};

/// Mixed-integer cuts of Gomory (Cornuéjols 2008): at most one per basic column of the optimum that is not whole, the
/// deepest first (docs/method.md §14.3). All columns are whole numbers, and so are all rows but those that `isCut` marks,
/// one entry a row. Cuts hold within the columns' bounds. The basis must be factorised.
std::vector<CutRow> GomoryCuts(glp_prob& problem, const std::vector<char>& isCut);
}
