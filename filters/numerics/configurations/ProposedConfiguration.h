#pragma once

#include "ConfigurationSpread.h"
#include "PlanarDomain.h"

#include <string>

namespace crossfield
{
struct ProposalOptions : SpreadOptions
{
  /// Core radius at which energies are reported, as in ConfigurationEnergy.h.
  double coreRadius = 0.0;
  /// Also proposes other quarter indices of corners than the smallest rotations or those given, if
  /// the corner classifier finds others of equal energy or the Ginzburg-Landau field has others.
  bool chooseCorners = false;
  /// Also proposes one singularity of ±2 instead of two of ±1, and an additional pair of opposite
  /// signs.
  bool variations = false;
  /// As in OptimizerOptions. It decides whether the search is used (GlobalSearch.h).
  double quadSize = 0.0;
};

/// Starting configuration with its energies after a few steps of the optimiser.
struct ProposedConfiguration
{
  Configuration singularities;
  /// Corners whose quarter index is not the smallest rotation.
  std::vector<CornerChoice> corners;
  std::string origin; ///< Source of the configuration, a few words.
  /// Clearance of its singularities, which all stay inside; 0: they may move to the boundary.
  double clearance = 0.0;
  /// Whether it has other corners or is one of ProposalOptions::variations.
  bool variation = false;
  double renormalized = 0.0; ///< W.
  double logarithmCoefficient = 0.0;
  /// W + coefficient × log(1 / core radius), comparable between configurations with different Σ k².
  double energy = 0.0;
  /// What proposals are ranked by (OptimizerResult::objective).
  double objective = 0.0;
  double holonomyDefect = 0.0; ///< Maximum, radians.
  double sizeSpread = 0.0;     ///< Standard deviation of log size over the area.
};

/// Returns whether there are fewer coordinates than holonomy conditions: each singularity has two
/// coordinates, and each inner loop imposes one condition. Such configurations can satisfy the
/// conditions only by symmetry.
inline bool TooFewForHolonomy(const PlanarDomain& domain, const Configuration& configuration)
{
  return 2 * configuration.size() < domain.loops.size() - 1;
}
}
