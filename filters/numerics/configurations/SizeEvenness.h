#pragma once

#include "PointPotential.h"

namespace crossfield
{
/// How even the sizes of quads are that follow a field (docs/method.md §5.7):
///   J = ½ ∫ (H − mean of H)² / area,
/// H = Φ/4 with single-valued periods, the logarithm of the size. √(2J) is the standard deviation of log
/// size over the area.
class SizeEvenness
{
public:
  struct Value
  {
    double energy = 0.0;      ///< J.
    Eigen::VectorXd gradient; ///< dJ / db_j, two per singularity inside.
    double Spread() const;    ///< √(2J).
  };

  explicit SizeEvenness(const PointPotential& potential);

  /// H at vertices, less its mean over the area.
  Eigen::VectorXd SizesOf(
    const PointPotential& potential, const PointPotential::Solution& solution) const;
  const Eigen::VectorXd& GetMasses() const { return this->Masses; }

  /// Exact derivatives of the discrete J: one more back-substitution.
  Value Evaluate(const PointPotential& potential, const PointPotential::Solution& solution) const;

private:
  Eigen::VectorXd Masses; ///< Part of the area that every vertex stands for.
  double SquaredCore;     ///< ε².
};
}
