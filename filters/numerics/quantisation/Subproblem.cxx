#include "Subproblem.h"

#include "Separation.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
EdgeCounts SolveSubproblem(const TMesh& mesh, const QuantisationProblem& problem,
  const std::vector<int>& free, const BranchLimits& limits, const EdgeCounts& best,
  std::vector<SeparationRow>& rows, std::vector<double>* rootRelaxation)
{
  std::vector<char> isFree(problem.Count(), 0);
  for (const int arc : free)
  {
    isFree[arc] = 1;
  }
  BranchAndCut search(problem, free, best.counts);
  for (const SeparationRow& row : rows)
  {
    if (row.Holds(best.counts) &&
      std::any_of(row.terms.begin(), row.terms.end(),
        [&isFree](const auto& term) { return isFree[term.first] != 0; }))
    {
      search.AddRow(row);
    }
  }
  const auto known = static_cast<std::ptrdiff_t>(search.GetRows().size());
  EdgeCounts found = search.Solve(limits,
    [&](const std::vector<int>& counts)
    {
      std::vector<SeparationRow> violated;
      for (const Violation& violation : FindViolations(mesh, counts))
      {
        violated.push_back(
          MakeSeparationRowFor(best.counts, violation, mesh, counts, problem.target));
      }
      return violated;
    });
  rows.insert(rows.end(), search.GetRows().begin() + known, search.GetRows().end());
  if (rootRelaxation != nullptr)
  {
    *rootRelaxation = search.GetRootRelaxation();
  }
  return found;
}

bool ReplaceIfCheaper(EdgeCounts& best, EdgeCounts found)
{
  const bool isCheaper = best.IsImprovedBy(found);
  if (isCheaper)
  {
    best.counts = std::move(found.counts);
    best.cost = found.cost;
  }
  return isCheaper;
}
}
