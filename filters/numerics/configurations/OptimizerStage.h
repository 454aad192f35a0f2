#pragma once

#include "ConfigurationPlacement.h"
#include "OptimizerObjective.h"
#include "Progress.h"

namespace crossfield
{
/// Singularities that remember which row of the start they were.
struct TrackedConfiguration
{
  Configuration singularities;
  std::vector<int> origins; ///< Row of the start, counted from 0; −1: from the boundary.

  /// "singularity 3", counted from 1 in the order of the start.
  std::string Name(std::size_t row) const;
  void Erase(std::size_t row);
};

/// A configuration with a mesh that resolves it: refined where an interior singularity is near the
/// boundary, so that an edge there is at most half as long as the distance.
struct OptimizerStage
{
  TrackedConfiguration tracked;
  PlacedConfiguration placed; ///< Of tracked.singularities.
  std::shared_ptr<const PointPotential> potential;
  std::shared_ptr<const OptimizerObjective> objective; ///< Of placed.interior.

  /// The singularities with the interior ones at a place of the objective.
  TrackedConfiguration At(const Eigen::VectorXd& place) const;
  /// Energy E_ρ of a place, but for what vanishes with ρ = clearance: comparable whatever the
  /// number of singularities.
  double CoreEnergy(const OptimizerPlace& place) const;
};

struct StageOptions
{
  double meshSize = 0.0;
  std::vector<CornerChoice> corners;
  double clearance = 0.0; ///< A length, positive.
};

/// Meshes and factors. Throws Error when the quarter indices violate Poincaré-Hopf.
OptimizerStage MakeStage(const PlanarDomain& domain, const TrackedConfiguration& tracked,
  const StageOptions& options, const Progress& progress = {});
}
