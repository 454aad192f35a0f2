#pragma once

#include "BoundarySymmetry.h"
#include "PointPotential.h"
#include "TargetSize.h"

namespace crossfield
{
/// How near the sizes of quads that follow a field are to wanted ones s in proportion
/// (docs/method.md §5.7):
///   J = ½ ∫ (D − mean of D)² / area,   D = H − log s,
/// H = Φ/4 with single-valued periods, the logarithm of the size. √(2J) is the standard deviation
/// of the logarithm of size over wanted size. Where none is wanted s = 1, and J says how even sizes
/// are.
class SizeUniformity
{
public:
  struct Value
  {
    double energy = 0.0;      ///< J.
    Eigen::VectorXd gradient; ///< dJ / db_j, two per singularity inside.
    double Spread() const;    ///< √(2J).
  };

  /// Compares with target sizes; all but those of Sizing::Field are the same everywhere. Throws
  /// Error where they are not positive.
  explicit SizeUniformity(const PointPotential& potential, TargetSizes target = {});

  /// D at vertices, less its mean over the area.
  Eigen::VectorXd SizesOf(
    const PointPotential& potential, const PointPotential::Solution& solution) const;
  const Eigen::VectorXd& GetMasses() const { return this->Masses; }
  /// Whether the wanted sizes at the places that an isometry takes vertices to are the same as at
  /// these, but for a root mean square of 0.01 of the logarithm: symmetry costs no more than that.
  bool IsKeptBy(const PointPotential& potential, const Isometry& map) const;

  /// √(2J).
  double SpreadOf(const PointPotential& potential, const PointPotential::Solution& solution) const;

  /// Exact derivatives of the discrete J: one more back-substitution.
  Value Evaluate(const PointPotential& potential, const PointPotential::Solution& solution) const;

private:
  Eigen::VectorXd Masses;    ///< Part of the area that every vertex stands for.
  double SquaredCore;        ///< ε².
  TargetSizes Target;        ///< s.
  Eigen::VectorXd LogTarget; ///< log s at vertices.
};
}
