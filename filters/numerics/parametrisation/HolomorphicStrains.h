#pragma once

#include "LoopAlignment.h"

#include <complex>

namespace crossfield
{
/// Quadratic differentials on some triangles.
struct DifferentialSample
{
  Eigen::MatrixXcd quadratic; ///< Q / A, a row per triangle, a column per loop.
  Eigen::VectorXd areas;      ///< Parts of the area, for integrals.
};

/// Strains that turn inner loops against each other and leave the angle sums to conformal changes
/// (docs/method.md §12.5).
///
/// g_j = J_jᵀ − Gᵀ a_j is the part of the derivative J_j of an alignment that conformal changes
/// cannot reach, a discrete holomorphic quadratic differential. Per triangle, with d_e the direction
/// of side e,
///   Q_j = Σ_e w_e g_je conj(d_e)²,  w_e = 1/2 inside, 1 on the boundary,
/// averaged over neighbours. The strains are those of Beltrami coefficients
///   μ_j = conj(Q_j) / (A max(|q|, cap)),  q = Σ_j c_j Q_j / A,
/// with the area quantile `cap` of |q|: constant where |q| is large, so that they stay bounded at
/// the poles of q at cones and corners.
class HolomorphicStrains
{
public:
  /// `potentials` are the columns a_j, one row per vertex.
  HolomorphicStrains(const MetricDerivatives& derivatives, const LoopAlignment& alignment,
    const Eigen::MatrixXd& potentials);

  /// Combinations of the strains of all loops.
  struct Strains
  {
    Eigen::MatrixXd edges; ///< S: changes of the logarithms of lengths, a column per loop.
    /// K_ij = g_iᵀ S_j, the change of alignment i by strain j, after the conformal correction.
    Eigen::MatrixXd response;
  };

  /// Returns the strains for coefficients c. With c = 0, those of |q| = 1.
  Strains For(const Eigen::VectorXd& coefficients, double quantile) const;

  /// Returns the differentials and areas of evenly spaced triangles, at most about `count`.
  DifferentialSample Sample(int count) const;

private:
  using Complex = std::complex<double>;

  /// Replaces the differentials by their means over triangles and their neighbours.
  void Average();

  const ConeMetric& Metric;
  Eigen::MatrixXd Differentials;               ///< g, a column per loop.
  std::vector<std::array<Complex, 3>> Squares; ///< d_e² per side of a triangle, relative to side 0.
  std::vector<double> Areas;
  Eigen::MatrixXcd Quadratic; ///< Q, a row per triangle, a column per loop.
};
}
