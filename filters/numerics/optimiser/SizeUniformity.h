#pragma once

#include "BoundarySymmetry.h"
#include "PointPotential.h"
#include "TargetSize.h"

namespace crossfield
{
/// Measure of how closely the sizes of quads that follow a field are proportional to target sizes s
/// (docs/method.md §5.7):
///   J = ½ ∫ (D − mean of D)² / area,   D = H − log s,
/// where a size field counts half by area and half by quads, with the weight 1/s²,
/// where H = Φ/4 with single-valued periods is the logarithm of the size. √(2J) is the standard
/// deviation of the logarithm of size over target size. Without target sizes s = 1, and J measures
/// how uniform sizes are.
class SizeUniformity
{
public:
  struct Value
  {
    double energy = 0.0;      ///< J.
    Eigen::VectorXd gradient; ///< Derivatives dJ/db_j, two per interior singularity.
    double Spread() const;    ///< √(2J).
  };

  /// Constructs J for target sizes; all modes except Sizing::Field have s = 1. Throws Error if
  /// target sizes are not positive.
  explicit SizeUniformity(const PointPotential& potential, TargetSizes target = {});

  /// Returns D at the vertices, minus its mean over the area.
  Eigen::VectorXd LogSizeDeviations(
    const PointPotential& potential, const PointPotential::Solution& solution) const;
  const Eigen::VectorXd& GetMasses() const { return this->Masses; }
  /// Returns whether an isometry preserves the target sizes: log s at the images of the vertices
  /// differs from log s at the vertices by at most 0.01 in the root mean square. Symmetric
  /// positions then increase the spread by no more than that.
  bool IsInvariantUnder(const PointPotential& potential, const Isometry& map) const;

  /// Returns √(2J).
  double SpreadOf(const PointPotential& potential, const PointPotential::Solution& solution) const;

  /// Evaluates J and the exact derivatives of the discrete J, by one additional back-substitution.
  Value Evaluate(const PointPotential& potential, const PointPotential::Solution& solution) const;

  /// Returns the second derivatives of J by the coordinates of the singularities. `regular`: the
  /// derivatives of R (PositionCurvature).
  Eigen::MatrixXd Differentiate(const PointPotential& potential,
    const PointPotential::Solution& solution, const Eigen::MatrixXd& regular) const;

private:
  /// Returns the solution for D times masses as sources, whose operator is symmetric.
  Eigen::VectorXd Adjoint(const PointPotential& potential, const Eigen::VectorXd& weighted) const;

  Eigen::VectorXd
    Masses;           ///< Fraction of the area, or of area and quads, that each vertex represents.
  double SquaredCore; ///< ε², squared smoothing radius of logarithms.
  TargetSizes Target; ///< s.
  Eigen::VectorXd LogTarget; ///< log s at vertices.
};
}
