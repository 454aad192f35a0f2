#pragma once

#include "QuantisationProblem.h"

#include <optional>
#include <string>

namespace crossfield
{
/// Searches for any counts of a problem that satisfy equations, prescribed sums and separation, by
/// branch and cut. Returns nothing if there are none, or none were found within a maximum number of
/// nodes.
std::optional<std::vector<int>> FindFeasibleCounts(
  const TMesh& mesh, const QuantisationProblem& problem);

/// Returns the names of sums that contradict each other, none of which can be left out of the contradiction.
std::vector<std::string> FindConflict(const TMesh& mesh, const QuantisationProblem& problem);

/// Returns a sentence about prescribed sums that contradict each other, none of which can be left
/// out of the contradiction (an irreducible infeasible subset, by deletion; Chinneck 2008), with a
/// remedy that was found to work. `problem` has no feasible counts.
std::string DescribeConflict(const TMesh& mesh, const QuantisationProblem& problem);
}
