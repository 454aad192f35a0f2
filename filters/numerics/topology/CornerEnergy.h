#pragma once

#include "Plane.h"

namespace crossfield
{
/// Returns the singular energy of a corner of interior angle α, in radians, with quarter index k:
///   e(α, k) = (π − α − k π/2)² / (2α),
/// the coefficient of log(1/ρ) in ½ ∫ |∇θ|² around it: the cross turns by the remainder π − α − k
/// π/2 across the angle α (docs/method.md §6.1; paper, "Ginzburg-Landau energy for piecewise-smooth
/// closed boundaries").
inline double CornerEnergy(double angle, int quarterIndex)
{
  const double remainder = Pi - angle - quarterIndex * 0.5 * Pi;
  return remainder * remainder / (2.0 * angle);
}

/// Returns e(α, k + 1) − e(α, k) = π (π/4 − (π − α − k π/2)) / (2α), which increases with k.
inline double NextQuarterCost(double angle, int quarterIndex)
{
  return Pi * (0.25 * Pi - (Pi - angle - quarterIndex * 0.5 * Pi)) / (2.0 * angle);
}

/// Energy of one interior singularity of quarter index ±1.
enum class InteriorCoefficient
{
  Logarithm, ///< π (1/4)² = π/16, consistent with corners; used by the paper's theorems.
  Printed    ///< (1/2π) (2π/4)² = π/8, as printed in the paper.
};

inline double InteriorQuarterEnergy(InteriorCoefficient coefficient)
{
  return coefficient == InteriorCoefficient::Printed ? Pi / 8.0 : Pi / 16.0;
}
}
