#pragma once

#include "PoincareHopf.h"
#include "Progress.h"
#include "QuadRequest.h"
#include "RegionSet.h"

#include <string>
#include <vector>

namespace crossfield
{
/// How configurations are checked.
struct CheckOptions
{
  double cornerAngle = DefaultCornerAngle; ///< Turning angle of corners, in radians.
  bool cap = false;                        ///< Gives corners of index 2 or more index 1.
  bool holonomy = true;                    ///< Computes the holonomy defects, which needs a mesh.
};

/// Whether a configuration can exist.
struct ConfigurationCheck
{
  PoincareHopfCount count; ///< With several regions, sums over these, without loops.
  bool consistent = false;
  std::string reason;                  ///< In words.
  std::vector<double> holonomyDefects; ///< Per inner loop, in radians.
  std::vector<RegionReport> regions;   ///< With several regions, the sums of each.
};

/// Checks a configuration on a domain with chosen indices of corners by the generalised Poincaré-Hopf theorem
/// (docs/method.md §7.1). Throws Error as RequireInside and HolonomyDefects do.
ConfigurationCheck CheckConfiguration(const PlanarDomain& domain,
  const Configuration& configuration, std::vector<CornerChoice> choices,
  const CheckOptions& options, const Progress& progress = {});

/// Returns the sum that all quarter indices of a configuration must have, also those on the boundary. Throws Error as
/// CountQuarters does.
int RequiredSum(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& choices, const CheckOptions& options);

/// Checks a configuration in each region of a set, with the indices of corners at nodes that are chosen together
/// (docs/method.md §21.2). Throws Error as CheckConfiguration does.
ConfigurationCheck CheckRegions(const RegionSet& set, const Configuration& configuration,
  const std::vector<CornerChoice>& choices, const CheckOptions& options,
  const Progress& progress = {});
}
