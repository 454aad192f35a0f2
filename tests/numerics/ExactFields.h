#pragma once

// Exact cross fields of points on the unit disk and on its images, inside and on the boundary
// (docs/method.md §5.3, §11.2).

#include "PlanarDomain.h"
#include "Singularity.h"

#include <complex>

namespace crossfield::test
{
/// φ and Φ (docs/method.md §11.2) are the imaginary and the real part of Σ k_j (log(z − b_j) + log(1 − b̄_j z)). When b comes to
/// the circle, the two logarithms become one: Φ = 2k log|z − b| still has the flux k through the circle,
/// and 2πk leaves b into the half plane, the jump of the phase. So Poincaré-Hopf is Σ k = 4 over those
/// inside and on the circle.
bool IsOnCircle(const Singularity& singularity);

/// W. Cut out the half disk around a point b of the circle: −½ ∫ Φ ∂Φ/∂r over its arc, of length πρ, is −½ π 2k
/// (2k log ρ + the others' Φ at b) = 2πk² log(1/ρ) − πk (the others' Φ), as it is from the arc 2πρ
/// inside. ∮ Φ ∂Φ/∂ν = 4 ∮ Φ = 0 over the circle as before. So the formula for points inside holds for
/// all, but for the own image of one on the circle, whose place the logarithm takes.
double ExactEnergyOnDisk(const Configuration& configuration);

/// The image of the unit disk under f(z) = z + a zⁿ, n ≥ 2. It is injective for n |a| < 1.
///
/// An injective f carries a field over: crosses turn by arg f′, which is the same for the field as for the
/// boundary and has no turns, so φ grows by 4 arg f′ and Φ by G = 4 log|f′|, and quarter indices stay.
struct DiskImage
{
  std::complex<double> a = 0.0;
  int n = 2;

  Point operator()(std::complex<double> z) const;
  Configuration operator()(const Configuration& preimages) const;
  std::complex<double> Slope(std::complex<double> z) const;
  std::complex<double> Preimage(const Point& point) const;

  /// The image of a circle as a polygon, inscribed, counter-clockwise.
  Loop Polygon(int count, double radius = 1.0) const;

  /// Up to a constant.
  double PhiAt(const Configuration& preimages, const Point& point) const;
  /// u. On the circle (z − b)(1 − b̄z) = z |z − b|², so with Σ k = 4 it is (iz)⁴ f′⁴/|f′|⁴, aligned.
  std::complex<double> CrossAt(const Configuration& preimages, const Point& point) const;

  /// W of the image. Its holes of radius ρ are on the disk holes of radius ρ/|f′(b_j)|, and ½∫|∇(Φ + G)|² is
  /// the same there. The first square adds π k_j² log|f′(b_j)| (2π k_j² on the circle). The cross term is ∮ G
  /// ∂Φ/∂ν: 4 ∮ G = 8π G(0) = 0 along the circle, and −2πk_j G(b_j) at each hole, as at each half hole of the circle.
  /// Of log f′ = Σ_m c_m z^{m(n−1)}, |c_m| = |na|^m/m, the energy ½ · 16 π Σ m (n−1) |c_m|² remains:
  /// W + Σ (π k² − 8πk) log|f′(b)| − 8π (n−1) log(1 − |na|²).
  double Energy(const Configuration& preimages) const;
};

/// The ring inner ≤ |z| ≤ 1, with singularities of sum 0 inside.
///
/// Put q = inner² and P(x) = (1 − x) Π_{n ≥ 1} (1 − qⁿx)(1 − qⁿ/x), a theta function: P(1/x) = P(qx) = −P(x)/x. Then
/// F_b = log|P(z/b)| + log|P(z b̄)| is log|z − b| and its images in both circles: F_b(1/z̄) = F_b(z) − 2 log|z| and
/// F_b(q/z̄) = F_b(z), so ∂F_b/∂r is 1 on the outer circle and 0 on the inner one. The tangents ask for 4/r on both, hence
/// Φ = 4 log|z| + Σ k_j F_{b_j}.
struct ExactRing
{
  double inner = 0.4;

  double PhiAt(const Configuration& configuration, const Point& point) const;
  /// u where there is no defect. On the outer circle P(z/b) P(z b̄) is −|P(z/b)|² z/b but for a positive factor, so
  /// it is z⁴ there, aligned.
  std::complex<double> CrossAt(const Configuration& configuration, const Point& point) const;

  /// Σ k_j arg b_j, modulo 2π (TestHolonomyCheck.cxx).
  double Defect(const Configuration& configuration) const;

  /// W without the field of the defect. ½ ∮ Φ ∂Φ/∂ν is 4π (mean of Φ on the outer circle − that on the inner one); the mean of F_b
  /// is −log|b| and 0. A hole has −πk_j (Φ − k_j log|z − b_j|) at b_j, in which P(z/b) is (1 − z/b) Π (1 − qⁿ)² at z = b:
  /// 16π log(1/inner) − 4π Σ k_j log|b_j| − π Σ_j k_j [4 log|b_j| + Σ_i k_i log|P(b_j b̄_i)| + Σ_{i≠j} k_i log|P(b_j/b_i)|
  /// − k_j log|b_j| + 2k_j Σ_n log(1 − qⁿ)].
  double SingleValuedEnergy(const Configuration& configuration) const;

  /// With it: a phase that grows by the defect δ from circle to circle has the energy π δ²/log(1/inner).
  double Energy(const Configuration& configuration) const;
};
}
