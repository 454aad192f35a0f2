#pragma once

#include "ConfigurationProposal.h"
#include "SingularityOptimizer.h"

#include <optional>

namespace crossfield
{
struct AutomaticOptions
{
  ProposalOptions proposal; ///< Given singularities and corners.
  /// Options of the runs that follow; their corners are those of the proposal. Target sizes and
  /// pairs take effect after the minimum of the energy has decided which singularities there are.
  OptimizerOptions optimizer;
  /// Side length of the quads for which singularities are chosen; if it is 0, it follows from
  /// quadCount. Both are 0 if no quads will be made. Determines the optimiser's clearance if that
  /// is 0 (ClearanceForQuads).
  double quadSize = 0.0;
  int quadCount = 0;
  /// Standard deviation of H, the logarithm of size, beyond which singularities also move towards
  /// uniform sizes. At 1/4 the largest and smallest 5 % of the sizes differ by a factor of more than
  /// e. Below it, more uniform sizes of the map may cost more in shape than they gain
  /// (docs/method.md §5.7).
  double acceptedSpread = 0.25;
  /// Maximum number of solves (SolveBudget.h) of the runs from all starts together, 0 for any
  /// number. The run that follows for quads may take half as many.
  std::size_t maximumSolves = 2000;
  /// Maximum number of configurations for quads that are returned, the best and others.
  std::size_t configurations = 1;
};

/// Singularities chosen for a domain, and how they were found.
struct AutomaticConfiguration
{
  Configuration singularities;       ///< Given ones first; without radii unless they were given.
  std::vector<CornerChoice> corners; ///< Quarter indices that the field must have at the boundary.
  OptimizerResult optimum;           ///< The last run.
  /// Decisions and events, one sentence each.
  std::vector<std::string> events;
  int rank = 0; ///< Of its objective: 0 for the best, wherever its singularities are.
  /// Others for the same quads, if AutomaticOptions::configurations permits: the same singularities where
  /// they have not moved for uniform sizes, nearer to holes and farther away, and other minima.
  std::vector<AutomaticConfiguration> others;
};

/// Returns the size of the quads for which singularities are chosen, 0 if no quads will be made.
double ResolveQuadSize(const PlanarDomain& domain, const AutomaticOptions& options);

/// Returns a sentence such as "6 singularities were chosen: 5 of quarter index 1, 1 of quarter
/// index -1."
std::string DescribeChoice(const Configuration& configuration);

/// Adds the events of the last run.
void AddEvents(AutomaticConfiguration& result);

/// Returns the largest absolute holonomy defect, radians.
double LargestDefect(const OptimizerResult& optimum);

/// Returns whether a run converged with a single-valued H.
bool HasConvergedWithoutDefect(const OptimizerResult& optimum);

/// Returns a limit of solves less those that were made, 0 for any number; none if it is reached.
std::optional<std::size_t> SolvesLeft(std::size_t limit, std::size_t made);
}
