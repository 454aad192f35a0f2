#pragma once

#include "EdgeCounts.h"
#include "QuantisationProblem.h"
#include "SeparationRow.h"

namespace crossfield
{
/// Effort of a search for optimal edge counts. Quick is for counts that are compared with others.
enum class SearchEffort
{
  Quick,
  Thorough
};

/// What searches for other target counts of the same T-mesh and sums found.
struct KnownCounts
{
  std::vector<int> counts; ///< Empty at first.
  std::vector<SeparationRow> rows;
};

/// Solves a quantisation problem with separation constraints (docs/method.md §14.3). Returns the
/// optimal flow if no points coincide in it. Otherwise counts n ≥ 1, which always keep points
/// apart, or the first feasible ones if paired sides or prescribed sums do not permit that, are improved in
/// windows (WindowSearch.h) and by branch and cut of the full problem (BranchAndCut.h), within a number of
/// nodes. `known`, unless it is null, is where the search starts, and receives what it finds; the search then
/// ends within 1 %, if quick 3 %, of the lowest cost, and a thorough one without known counts is preceded by a quick
/// one. Throws Error that names the sums that contradict each other.
EdgeCounts Quantise(const TMesh& mesh, const QuantisationProblem& problem, SearchEffort effort,
  KnownCounts* known = nullptr);

/// Returns the optimal counts of the relaxation with known rows, which are real numbers; the known counts if there are none.
std::vector<double> RelaxCounts(const QuantisationProblem& problem, const KnownCounts& known);
}
