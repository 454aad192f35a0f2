#pragma once

#include "PointPotential.h"

namespace crossfield
{
/// The renormalised energy W of a configuration: the finite part of the energy ½ ∫ |∇φ|² of the
/// aligned unit-norm field, without the logarithmic divergence at its singularities and corners
/// (docs/method.md §5.3, §6.4; paper, "The unifying renormalized Ginzburg-Landau energy"),
///   E = Σ_j π d_j² log(1/ρ) + Σ_c 16 e(α_c, k_c) log(1/ρ) + W + o(1)
/// on the domain without disks of radius ρ around singularities and corners.
struct RenormalizedEnergyValue
{
  double energy = 0.0;             ///< W, with the harmonic field of the holonomy defects.
  double singleValuedEnergy = 0.0; ///< W without it.
  double logarithmCoefficient = 0.0;
  Eigen::Matrix2Xd gradient;             ///< dW / db_j, one column per singularity.
  Eigen::Matrix2Xd singleValuedGradient; ///< The same for W without the harmonic field.
  std::vector<double> holonomyDefect;
  std::vector<Eigen::Matrix2Xd> defectGradient; ///< Gradient of each holonomy defect.
};

/// Evaluates W of a configuration from its solution. With Λ the sum of the logarithms a_m log|x −
/// x_m| and ω_m the angle of the domain around x_m, Green's identity turns the formula of the paper
/// into
///   W = −½ Σ_{m≠n} ω_m a_m a_n log|x_m − x_n| + ½ ∮ R ∂R/∂ν + ∮ Λ ∂R/∂ν + ½ ∮ Λ ∂Λ/∂ν,
/// plus ½ offsetᵀ S⁻¹ offset for the phase offsets of inner loops. The integrals are sums over
/// halves of boundary edges; logarithms at the boundary enter by their means.
///
/// R is the mean of two solutions, one with values at vertices and one with values on edges, whose
/// energies bound the exact one from below and above; the same holds for the last term. Both are
/// quadratic in the sources, so the discrete W is a smooth function of the positions wherever they
/// are in the mesh, and its gradient is exact and needs no further solve.
RenormalizedEnergyValue EvaluateRenormalizedEnergy(
  const PointPotential& potential, const PointPotential::Solution& solution);

/// Returns the energy of cores that would overlap at a radius ρ,
///   Σ_j π k_j² log(ρ / ρ_j),   ρ_j = min(ρ, half the distance to the nearest other singularity).
/// W + coefficient × log(1/ρ) + this sum is the energy outside of cores of radius ρ_j, without the
/// o(1). It compares configurations whose coefficients of the logarithm differ; W does not. Without
/// the sum, a pair of opposite signs would have less energy the closer it is, below that of the
/// same configuration without the pair (docs/method.md §5.6). `interior` has no singularities on the
/// boundary.
double CoreOverlapEnergy(const Configuration& interior, double radius);
}
