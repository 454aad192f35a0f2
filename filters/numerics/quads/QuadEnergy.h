#pragma once

#include "QuadMesh.h"

#include <Eigen/Core>

#include <array>

namespace crossfield
{
/// Where the two unknowns of a point begin.
inline Eigen::Index FirstUnknown(int point)
{
  return 2 * static_cast<Eigen::Index>(point);
}

/// The shape energy of a quad mesh (docs/method.md §14.5; Garanzha et al. 2021): at each corner of each quad, with
/// J the map from the wanted rectangle and D = det J,
///   f = (1 − a) |J|² / χ + a (D² + 1) / χ,  χ = (D + √(D² + ε²)) / 2.
/// Least where J is a rotation: 2.
///
/// Unknowns are two per point: its place inside; on the boundary the length along its polyline, and 0. Those of points
/// that are fixed are among them, with no gradient.
class QuadEnergy
{
public:
  /// `moves`: which points do. `sizePart`: a. `weights`: as how many every quad counts.
  QuadEnergy(const QuadMesh& mesh, const BoundaryCurves& curves, const std::vector<bool>& moves,
    double sizePart, std::vector<double> weights);

  /// Of the mesh.
  Eigen::VectorXd Unknowns() const;
  /// Takes tilt · (unknowns − origin) away from the value, so that the origin has the gradient that is wanted there.
  void Tilt(const Eigen::VectorXd& tilt, const Eigen::VectorXd& origin);
  /// Moves without those of points that do not move.
  Eigen::VectorXd Masked(Eigen::VectorXd moves) const;
  /// Puts the points of the mesh where unknowns say.
  void Store(const Eigen::VectorXd& unknowns, QuadMesh& mesh) const;
  /// That of quads as wanted, the least possible.
  double IdealValue() const { return this->Ideal; }
  /// Infinite with ε = 0 where a corner is not positive; the gradient is then not set. The same to the last bit however
  /// many threads there are.
  double Value(const Eigen::VectorXd& unknowns, double epsilon, Eigen::VectorXd* gradient);
  /// Least D.
  double LeastDeterminant(const Eigen::VectorXd& unknowns);
  /// Per unknown the inverse square of the lengths that it acts on, the size of the Hessian's diagonal; 1 where nothing
  /// moves.
  const Eigen::VectorXd& Curvature() const { return this->Diagonal; }

private:
  void Place(const Eigen::VectorXd& unknowns);
  double HalfValue(std::size_t half, double epsilon, bool forces);

  const QuadMesh& Mesh;
  const BoundaryCurves& Curves;
  const double SizePart;
  const std::vector<double> Weights;
  double Ideal = 0.0;
  std::vector<int> Fixed;      ///< Points that do not move.
  std::vector<int> OnBoundary; ///< Those that move along the boundary.
  Eigen::VectorXd Diagonal;
  Eigen::VectorXd Slope;                 ///< Of the tilt, if any,
  Eigen::VectorXd Origin;                ///< and from where.
  Eigen::VectorXd Places;                ///< Of all points.
  std::array<Eigen::VectorXd, 2> Forces; ///< By the quads of either half.
};
}
