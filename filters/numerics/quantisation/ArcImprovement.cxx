#include "ArcImprovement.h"

#include "ArcProgram.h"
#include "Separation.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
Improvement ImproveCounts(const TMesh& mesh, const ArcProblem& problem,
  const std::vector<int>& free, int mostNodes, IntegerCounts& best, std::vector<ArcRow>& rows)
{
  std::vector<char> isFree(problem.Count(), 0);
  for (const int arc : free)
  {
    isFree[static_cast<std::size_t>(arc)] = 1;
  }
  ArcProgram program(problem, free, best.counts);
  for (const ArcRow& row : rows)
  {
    if (row.Holds(best.counts) &&
      std::any_of(row.terms.begin(), row.terms.end(),
        [&isFree](const auto& term) { return isFree[static_cast<std::size_t>(term.first)] != 0; }))
    {
      program.Add(row);
    }
  }
  const auto known = static_cast<std::ptrdiff_t>(program.GetRows().size());
  ProgramCounts found = program.Solve(mostNodes,
    [&](const std::vector<int>& counts)
    {
      std::vector<ArcRow> broken;
      for (const Violation& violation : FindViolations(mesh, counts))
      {
        broken.push_back(RowAllowing(best.counts, violation, mesh, counts, problem.wanted));
      }
      return broken;
    });
  rows.insert(rows.end(), program.GetRows().begin() + known, program.GetRows().end());
  Improvement result;
  result.bound = found.bound;
  result.nodes = found.nodes;
  result.relaxed = std::move(found.relaxed);
  result.isBetter = found.cost < best.cost - CostRounding(best.cost);
  if (result.isBetter)
  {
    best.counts = std::move(found.counts);
    best.cost = found.cost;
  }
  return result;
}
}
