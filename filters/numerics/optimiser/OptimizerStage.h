#pragma once

#include "ConfigurationPlacement.h"
#include "OptimizerObjective.h"
#include "Progress.h"

#include <set>
#include <string>

namespace crossfield
{
/// Origins of singularities that are in no row of the start: from the boundary, and of a pair that was added.
constexpr int BoundaryOrigin = -1;
constexpr int AddedOrigin = -2;

/// Singularities that remember which row of the start they were.
struct TrackedConfiguration
{
  Configuration singularities;
  std::vector<int> origins; ///< Row of the start, counted from 0, or one of the origins above.
  std::set<int> absorbed;   ///< Origins of those that became singularities of the boundary.

  /// "singularity 3", counted from 1 in the order of the start.
  std::string Name(std::size_t row) const;
  void Erase(std::size_t row);
};

/// A configuration with a mesh that resolves it: refined where an interior singularity is near the
/// boundary, so that an edge there is at most half as long as the distance.
struct OptimizerStage
{
  TrackedConfiguration tracked;
  PlacedConfiguration placed;        ///< Of tracked.singularities.
  std::vector<CornerChoice> corners; ///< As they were given.
  std::shared_ptr<const PointPotential> potential;
  std::shared_ptr<const OptimizerObjective> objective; ///< Of placed.interior.

  /// The singularities with the interior ones at a place of the objective.
  TrackedConfiguration At(const Eigen::VectorXd& place) const;
  /// Energy E_ρ of a place, but for what vanishes with ρ = 1/400 of the diagonal: comparable whatever
  /// the number of singularities.
  double CoreEnergy(const OptimizerPlace& place) const;
  /// The same of another configuration on this mesh, of which singularities on the boundary are at
  /// vertices; infinite if it cannot exist. It costs no factorisation.
  double CoreEnergyOf(const Configuration& configuration) const;
};

/// Radius of cores, and least distances where none is asked for: a tenth of the default mesh size;
/// nearer to each other or to the boundary no mesh for a field would tell them apart.
double CoreRadius(const PlanarDomain& domain);

struct StageOptions
{
  double meshSize = 0.0;
  std::vector<CornerChoice> corners;
  ObjectiveOptions objective;
};

/// Meshes and factors. Throws Error when the quarter indices violate Poincaré-Hopf.
OptimizerStage MakeStage(const PlanarDomain& domain, const TrackedConfiguration& tracked,
  const StageOptions& options, const Progress& progress = {});
}
