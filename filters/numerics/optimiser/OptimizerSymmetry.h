#pragma once

#include "ConfigurationSymmetry.h"
#include "PointPotential.h"

namespace crossfield
{
/// Returns by how much the energy of positions with a group of symmetries may be higher: 8 ln n for
/// n elements. In a comparison of meshes of 34 domains, with a factor below 5 a disk with five
/// holes loses its symmetry, and above 20 other domains get many more blocks.
double WorthOfSymmetries(std::size_t elements);

/// Returns the worth of the symmetries of a domain that positions keep. Rotations alone count half where
/// the domain has reflections: such positions lean to one side.
double WorthOfSymmetries(const std::vector<Isometry>& kept, const SymmetryGroup& ofDomain);

/// Symmetries that the optimiser keeps (docs/method.md §5.5): those of the domain that the interior
/// singularities and the quarter indices chosen on the boundary have to 1e-9 of the diagonal.
struct OptimizerSymmetry
{
  /// Symmetry of the positions; images are rows of the interior singularities.
  ConfigurationSymmetry positions;
  /// Projects the holonomy defects, one per island, onto those that symmetric configurations have:
  /// a rotation maps the defect of an island to that of its image, a reflection to its negative.
  /// Meshes are not symmetric; without the projection their error would prescribe values that no
  /// symmetric configuration has.
  Eigen::MatrixXd defects;

  bool IsTrivial() const { return this->positions.IsTrivial(); }
};

/// Finds the symmetries to keep. Reflections are left out if a defect is near π: π is its own
/// negative, so the defect of an island on the axis would remain.
/// `keeps`: as for MatchSymmetry.
OptimizerSymmetry FindKeptSymmetry(const PointPotential& potential, const PlanarDomain& domain,
  const Configuration& interior, const IsometryTest& keeps = {});

/// Returns a symmetry group that consists of the identity only.
OptimizerSymmetry TrivialSymmetry(const PointPotential& potential, const Configuration& interior);

/// Returns the largest group of symmetries of a domain that a configuration has within a distance.
/// Singularities on the boundary are compared at their positions. Vertices whose quarter index was
/// given by other means than the configuration count as part of it. `keeps`: as for MatchSymmetry.
ConfigurationSymmetry MatchWithBoundary(const PointPotential& potential, const SymmetryGroup& group,
  const Configuration& interior, double distance, const IsometryTest& keeps = {});
}
