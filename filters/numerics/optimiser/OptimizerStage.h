#pragma once

#include "ConfigurationPlacement.h"
#include "OptimizerObjective.h"
#include "Progress.h"

#include <set>
#include <string>

namespace crossfield
{
/// Origins of singularities that were not in the start: moved inside from the boundary, or added in
/// a pair.
constexpr int BoundaryOrigin = -1;
constexpr int AddedOrigin = -2;

/// Configuration with the row of the start that each singularity comes from.
struct TrackedConfiguration
{
  Configuration singularities;
  std::vector<int> origins; ///< Row of the start, counted from 0, or one of the origins above.
  std::set<int> absorbed;   ///< Origins of the singularities that became part of the boundary.

  /// Returns "singularity 3", for example, counted from 1 in the order of the start.
  std::string Name(std::size_t row) const;
  void Erase(std::size_t row);
};

/// Configuration with a mesh that resolves it: the mesh is refined near interior singularities
/// close to the boundary, so that edges there are at most half as long as their distance from the
/// boundary.
struct OptimizerStage
{
  TrackedConfiguration tracked;
  PlacedConfiguration placed;        ///< Placement of tracked.singularities.
  std::vector<CornerChoice> corners; ///< As given.
  double quadSize = 0.0;             ///< As in OptimizerOptions, resolved.
  std::shared_ptr<const PointPotential> potential;
  std::shared_ptr<const OptimizerObjective> objective; ///< Objective for placed.interior.

  /// Returns the singularities with the interior ones at given positions.
  TrackedConfiguration At(const Eigen::VectorXd& positions) const;
  /// Returns the energy E_ρ at the CoreRadius ρ, without terms that vanish with ρ
  /// (CoreOverlapEnergy). It is comparable between configurations with different numbers of
  /// singularities.
  double CoreEnergy(const OptimizerState& state) const;
};

/// Returns the core radius, which is also the default clearance: 1/400 of the diagonal, a tenth of
/// the default mesh size. No mesh for a field would resolve smaller distances between singularities
/// or from the boundary.
double CoreRadius(const PlanarDomain& domain);

/// Returns the size of quads on which a field on a mesh of the default size can be resolved, 1/40 of
/// the diagonal.
double QuadsOfDefaultMesh(const PlanarDomain& domain);

struct StageOptions
{
  double meshSize = 0.0;
  double quadSize = 0.0; ///< As in OptimizerOptions.
  std::vector<CornerChoice> corners;
  ObjectiveOptions objective;
};

/// Meshes the domain and factors the Laplacian. Throws Error if the quarter indices violate
/// Poincaré-Hopf.
OptimizerStage MakeStage(const PlanarDomain& domain, const TrackedConfiguration& tracked,
  const StageOptions& options, const Progress& progress = {});
}
