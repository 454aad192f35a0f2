#pragma once

#include "ConfigurationSpread.h"
#include "PlanarDomain.h"

#include <string>

namespace crossfield
{
struct ProposalOptions : SpreadOptions
{
  /// Core radius at which energies are compared, as in ConfigurationEnergy.h.
  double coreRadius = 0.0;
  /// Also other quarter indices of corners than the smallest rotations or those given, where the corner
  /// classifier finds others as cheap or the Ginzburg-Landau field takes others.
  bool chooseCorners = false;
  /// Also one of ±2 instead of two of ±1, and a pair of opposite signs more.
  bool variations = false;
};

/// A configuration to start from, and what it costs after a few steps of the optimiser.
struct ProposedConfiguration
{
  Configuration singularities;
  /// The corners that count otherwise than by the smallest rotation.
  std::vector<CornerChoice> corners;
  std::string origin;        ///< Where it comes from, a few words.
  bool variation = false;    ///< Of the corners, or one of ProposalOptions::variations.
  double renormalized = 0.0; ///< W.
  double logarithmCoefficient = 0.0;
  /// W + coefficient × log(1 / core radius): comparable between configurations of different Σ k².
  double energy = 0.0;
  double holonomyDefect = 0.0; ///< Largest, radians.
  double sizeSpread = 0.0;     ///< Standard deviation of log size over the area: how flat H is.
};

/// Each singularity has two coordinates to make one holonomy defect vanish with each: fewer than half as
/// many as inner loops cannot do it, but by symmetry.
inline bool TooFewForHolonomy(const PlanarDomain& domain, const Configuration& configuration)
{
  return 2 * configuration.size() < domain.loops.size() - 1;
}
}
