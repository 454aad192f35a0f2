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
}
