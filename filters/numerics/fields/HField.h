#pragma once

#include "PotentialSolver.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// The scalar H of a configuration and the cross field that it carries (docs/method.md §11.1; paper, "Further
/// thoughts"): ΔH = 2π Σ_j (k_j / 4) δ_{b_j} inside, ∂H/∂ν = curvature − Σ_c (k_c π/2) δ_{p_c} on the
/// boundary. H + iθ is analytic, θ the angle of the cross: e^H is the local length of the edges of
/// quads along the crosses, up to a factor; it is larger where the crosses' lines spread.
struct HField
{
  /// u = e^{4iθ} with |u| = 1, and the report. Its energy ½ ∫ |∇φ|² is that of the mesh where the
  /// singularities are holes. Points have infinite energy: it is then the leading part of the energy
  /// with a hole of radius ρ_j at every singularity, Σ_j π k_j² log(1/ρ_j) + W, with 1/40 of the
  /// diagonal for radii not given and at corners that have a logarithm.
  SolvedField field;
  /// H at the vertices, area mean 0. At a vertex on a singularity, where H is infinite, the mean over
  /// the disk (sector) whose radius is half of the shortest edge there.
  Eigen::VectorXd h;
  /// W; NaN where the singularities are holes.
  double renormalizedEnergy = 0.0;
  /// By which H, a branch of it, grows around each inner loop, walked with the domain on the left; zero
  /// without holonomy defects.
  std::vector<double> periods;
};

/// Solves for H on a mesh. On a mesh without holes `configuration` has the singularities, inside or
/// at vertices of outer and inner loops, whose quarter index it then chooses as `corners` do; the
/// logarithms are subtracted (PointPotential.h). On a mesh with holes these are the singularities,
/// the field is exactly the unit-norm field, and those of `configuration` must lie in holes of their
/// quarter index or at vertices of loops.
///
/// Corners without a given index make the smallest rotation; if the sum then is wrong, they take the
/// indices of the cheapest assignment (CornerClassification.h), and if it is still wrong that is an
/// Error, as is a singularity outside.
HField SolveHField(const SharedTopology& topology, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, const Progress& progress = {});

/// The same on a mesh that is factored already: one back-substitution.
HField SolveHField(const std::shared_ptr<const PotentialSolver>& potential,
  const Configuration& configuration, const std::vector<CornerChoice>& corners = {},
  const Progress& progress = {});
}
