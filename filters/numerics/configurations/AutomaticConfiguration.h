#pragma once

#include "ConfigurationProposal.h"
#include "SingularityOptimizer.h"

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

/// Returns the recommended clearance of singularities for quads of a size: 0.7 of it
/// (docs/method.md §5.6).
double ClearanceForQuads(double quadSize);

/// Number of quads between the boundary of a hole and singularities, where the gap to the next loop
/// permits (docs/method.md §5.10).
constexpr double UsualQuadsAtHoles = 1.5;

/// Returns the factors, at least 1, of ClearanceForQuads at the sides of inner loops, for a distance of
/// a number of quads, but at most one quad less than half of the gap to the nearest other loop.
ClearanceFactors ClearanceAtHoles(
  const PlanarDomain& domain, double quadSize, double quads = UsualQuadsAtHoles);

/// Gives quarter index 1 to sharp corners of index 2 (PoincareHopf.h). If there are any, sets
/// keepAll: a singularity that moved into such a corner would undo the change.
void CapCorners(const PlanarDomain& domain, AutomaticOptions& options);

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

/// Chooses the singularities of a domain: proposes starts (ConfigurationProposal.h) and moves their
/// interior singularities to a minimum of the renormalised energy (SingularityOptimizer.h), from
/// one start after the other until a run converges without a holonomy defect. After that, only starts
/// are tried whose objective is below that of the result.
/// If no run converges, the one with the smallest defect is used, and among those without a defect
/// the one with the lowest energy; this is no error: optimum.converged is false, and the last event
/// gives the reason.
///
/// For quads a second run follows, with the clearance for quads. It also moves to the target sizes
/// if their sizing is Uniform or Field, and to uniform sizes if the sizes at the minimum are far
/// from uniform (docs/method.md §5.7).
///
/// Throws Error as ProposeConfigurations and OptimizeSingularities do.
AutomaticConfiguration ChooseConfiguration(
  const PlanarDomain& domain, const AutomaticOptions& options = {}, const Progress& progress = {});
}
