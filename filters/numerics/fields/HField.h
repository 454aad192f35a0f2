#pragma once

#include "PotentialSolver.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// Scalar H of a configuration and the cross field that belongs to it (docs/method.md §11.1; paper,
/// "Further thoughts"): ΔH = 2π Σ_j (k_j / 4) δ_{b_j} inside, ∂H/∂ν = curvature − Σ_c (k_c π/2)
/// δ_{p_c} on the boundary. H + iθ is analytic, where θ is the angle of the cross. e^H is, up to a
/// factor, the local length of the edges of quads along the crosses; it is larger where the lines
/// of crosses diverge.
struct HField
{
  /// u = e^{4iθ} with |u| = 1, and the report. Where the singularities are holes, its energy is ½ ∫
  /// |∇φ|² of that mesh. Points have infinite energy. The report then contains the leading part of
  /// the energy with a hole of radius ρ_j at every singularity, Σ_j π k_j² log(1/ρ_j) + W, where
  /// 1/40 of the diagonal replaces radii that are not given and is used at corners with a
  /// logarithm.
  SolvedField field;
  /// H at the vertices, area mean 0. At a vertex on a singularity, where H is infinite, the mean
  /// over the disk (sector) whose radius is half of the shortest edge there.
  Eigen::VectorXd h;
  /// W; NaN where the singularities are holes.
  double renormalizedEnergy = 0.0;
  /// Increase of H, continued along each inner loop with the domain on the left; zero without
  /// holonomy defects.
  std::vector<double> periods;
};

/// Solves for H on a mesh. On a mesh without holes, `configuration` contains the singularities,
/// inside or at vertices of outer and inner loops; at a vertex it chooses the quarter index as
/// `corners` do. The logarithms are subtracted (PointPotential.h). On a mesh with holes, the holes
/// are the singularities, and the field is exactly the unit-norm field; the singularities of
/// `configuration` must then be in holes of the same quarter index or at vertices of loops.
///
/// Corners without a given index have the smallest rotation. If the sum is then wrong, they take
/// the indices of the cheapest assignment (CornerClassification.h). Throws Error if the sum is
/// still wrong, or a singularity is outside the domain.
HField SolveHField(const SharedPlanarTopology& topology, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, const Progress& progress = {});

/// Solves for H on a mesh that has already been factored, with one back-substitution.
HField SolveHField(const std::shared_ptr<const PotentialSolver>& potential,
  const Configuration& configuration, const std::vector<CornerChoice>& corners = {},
  const Progress& progress = {});
}
