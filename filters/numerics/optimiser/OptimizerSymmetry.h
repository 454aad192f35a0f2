#pragma once

#include "ConfigurationSymmetry.h"
#include "PointPotential.h"

namespace crossfield
{
/// The symmetries that the optimiser keeps (docs/method.md §5.5): of a domain with singularities inside
/// and the quarter indices chosen on its boundary, within 1e-9 of the diagonal.
struct OptimizerSymmetry
{
  ConfigurationSymmetry places; ///< Images are rows of the interior singularities.
  /// Projects holonomy defects, one per island, to those that symmetric places have: a rotation takes the
  /// defect of an island to that of its image, a reflection to its opposite. Meshes are not symmetric, so
  /// that without it their error would ask for what no symmetric place can give.
  Eigen::MatrixXd defects;

  bool IsTrivial() const { return this->places.IsTrivial(); }
};

/// Reflections are left out where a defect is near half a turn: half a turn is its own opposite, so that of
/// an island on the axis would stay.
/// `keeps`: as for MatchSymmetry.
OptimizerSymmetry FindKeptSymmetry(const PointPotential& potential, const PlanarDomain& domain,
  const Configuration& interior, const IsometryTest& keeps = {});

/// None but the identity.
OptimizerSymmetry NoSymmetry(const PointPotential& potential, const Configuration& interior);

/// The largest group of symmetries of a domain that a configuration keeps within a distance, those on
/// the boundary in the places where they are. The vertices to which a quarter index was given by
/// anything else than the configuration count as part of it. `keeps`: as for MatchSymmetry.
ConfigurationSymmetry MatchWithBoundary(const PointPotential& potential, const SymmetryGroup& group,
  const Configuration& interior, double distance, const IsometryTest& keeps = {});
}
