#pragma once

#include "LinearSolver.h"

namespace crossfield
{
/// Generates Gomory mixed-integer cuts (Cornuéjols 2008): at most one per basic column that is
/// fractional at the optimum, deepest first (docs/method.md §14.3). All columns are integer
/// variables, and all rows have integral values but those marked in `isCut`, one entry per row.
/// Cuts are valid within the columns' present bounds. The basis must be factorised.
std::vector<LinearRow> GomoryCuts(const LinearSolver& program, const std::vector<char>& isCut);
}
