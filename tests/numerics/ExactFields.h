#pragma once

// Exact cross fields of points on the unit disk and on its images, inside and on the boundary
// (docs/method.md §5.3, §11.2).

#include "PlanarDomain.h"
#include "Singularity.h"

#include <complex>

namespace crossfield::test
{
/// Five singularities of mixed sign and sum 4 in the unit disk, away from the centre.
inline const Configuration FiveInDisk = { { { 0.31, 0.42 }, 2, 0.0 }, { { -0.52, 0.18 }, 1, 0.0 },
  { { -0.11, -0.61 }, 1, 0.0 }, { { 0.47, -0.33 }, 1, 0.0 }, { { 0.08, 0.05 }, -1, 0.0 } };

/// Returns whether a singularity is on the unit circle.
///
/// φ and Φ (docs/method.md §11.2) are the imaginary and the real part of Σ k_j (log(z − b_j) +
/// log(1 − b̄_j z)). As b approaches the circle, the two logarithms coincide: Φ = 2k log|z − b|
/// still has the flux k through the circle, and a flux of 2πk leaves b into the half plane, which
/// is the jump of the phase. The Poincaré-Hopf theorem is therefore Σ k = 4 over the singularities
/// inside and on the circle.
bool IsOnCircle(const Singularity& singularity);

/// Returns W. If a half disk of radius ρ around a point b of the circle is removed, −½ ∫ Φ ∂Φ/∂r
/// over its arc, of length πρ, is −½ π 2k (2k log ρ + Φ_others(b)) = 2πk² log(1/ρ) − πk
/// Φ_others(b), the same as over the arc 2πρ of a hole inside, where Φ_others is the contribution
/// of the other singularities. As for points inside, ∮ Φ ∂Φ/∂ν = 4 ∮ Φ = 0 over the circle. The
/// formula for points inside therefore holds for all points, except that the logarithm of a point
/// on the circle replaces the point's own image.
double ExactEnergyOnDisk(const Configuration& configuration);

/// Image of the unit disk under f(z) = z + a zⁿ, n ≥ 2, which is injective for n |a| < 1.
///
/// An injective f maps a field to a field: crosses turn by arg f′, by the same angle as the
/// boundary and without full turns, so φ increases by 4 arg f′ and Φ by G = 4 log|f′|, and quarter
/// indices are preserved.
struct DiskImage
{
  std::complex<double> a = 0.0;
  int n = 2;

  Point operator()(std::complex<double> z) const;
  Configuration operator()(const Configuration& preimages) const;
  std::complex<double> Slope(std::complex<double> z) const;
  std::complex<double> Preimage(const Point& point) const;

  /// Returns the image of a circle as an inscribed counter-clockwise polygon.
  Loop Polygon(int count, double radius = 1.0) const;

  /// Returns Φ up to a constant.
  double PhiAt(const Configuration& preimages, const Point& point) const;
  /// Returns u. On the circle (z − b)(1 − b̄z) = z |z − b|², so with Σ k = 4 it is (iz)⁴ f′⁴/|f′|⁴,
  /// aligned.
  std::complex<double> CrossAt(const Configuration& preimages, const Point& point) const;

  /// Returns W of the image. Holes of radius ρ in the image correspond to holes of radius
  /// ρ/|f′(b_j)| in the disk, and ½∫|∇(Φ + G)|² is the same on both. The square of ∇Φ contributes
  /// an additional π k_j² log|f′(b_j)| (2π k_j² on the circle). The cross term is ∮ G ∂Φ/∂ν: 4 ∮ G
  /// = 8π G(0) = 0 along the circle, and −2πk_j G(b_j) at each hole and at each half hole on the
  /// circle. With log f′ = Σ_m c_m z^{m(n−1)} and |c_m| = |na|^m/m, the square of ∇G contributes ½
  /// · 16 π Σ m (n−1) |c_m|². The result is W + Σ (π k² − 8πk) log|f′(b)| − 8π (n−1) log(1 −
  /// |na|²).
  double Energy(const Configuration& preimages) const;
};

/// Ring inner ≤ |z| ≤ 1 with singularities of sum 0 inside.
///
/// Let q = inner² and P(x) = (1 − x) Π_{n ≥ 1} (1 − qⁿx)(1 − qⁿ/x), a theta function with P(1/x) =
/// P(qx) = −P(x)/x. Then F_b = log|P(z/b)| + log|P(z b̄)| is log|z − b| plus its images in both
/// circles: F_b(1/z̄) = F_b(z) − 2 log|z| and F_b(q/z̄) = F_b(z), so ∂F_b/∂r is 1 on the outer
/// circle and 0 on the inner one. The tangents require 4/r on both circles, hence Φ = 4 log|z| + Σ
/// k_j F_{b_j}.
struct ExactRing
{
  double inner = 0.4;

  double PhiAt(const Configuration& configuration, const Point& point) const;
  /// Returns u for a configuration without a holonomy defect. On the outer circle P(z/b) P(z b̄) is
  /// −|P(z/b)|² z/b up to a positive factor, so u = z⁴ there, aligned.
  std::complex<double> CrossAt(const Configuration& configuration, const Point& point) const;

  /// Returns the holonomy defect Σ k_j arg b_j, modulo 2π (TestHolonomyCheck.cxx).
  double Defect(const Configuration& configuration) const;

  /// Returns W without the contribution of the defect. ½ ∮ Φ ∂Φ/∂ν is 4π (mean of Φ on the outer
  /// circle − mean on the inner one); the means of F_b are −log|b| and 0. A hole contributes −πk_j
  /// (Φ − k_j log|z − b_j|) at b_j, where P(z/b) is (1 − z/b) Π (1 − qⁿ)²: 16π log(1/inner) − 4π Σ
  /// k_j log|b_j| − π Σ_j k_j [4 log|b_j| + Σ_i k_i log|P(b_j b̄_i)| + Σ_{i≠j} k_i log|P(b_j/b_i)|
  /// − k_j log|b_j| + 2k_j Σ_n log(1 − qⁿ)].
  double SingleValuedEnergy(const Configuration& configuration) const;

  /// Returns W with the defect: a phase that grows by the defect δ from circle to circle has the
  /// energy π δ²/log(1/inner).
  double Energy(const Configuration& configuration) const;
};
}
