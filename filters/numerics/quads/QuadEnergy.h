#pragma once

#include "QuadMesh.h"

#include <Eigen/Core>

namespace crossfield
{
/// The shape energy of a quad mesh (docs/method.md §14.5; Garanzha et al. 2021): at each corner of each quad, with
/// J the map from the wanted rectangle and D = det J,
///   f = (1 − a) |J|² / χ + a (D² + 1) / χ,  χ = (D + √(D² + ε²)) / 2.
/// Unknowns are the places of the points that are free: two coordinates inside, the length along its polyline
/// for one on the boundary.
class QuadEnergy
{
public:
  /// `releaseCones`: the singularities inside move, too. `sizePart`: a.
  QuadEnergy(QuadMesh& mesh, const BoundaryCurves& curves, bool releaseCones, double sizePart);

  Eigen::Index UnknownCount() const { return this->Count; }
  Eigen::VectorXd Unknowns() const;
  /// Puts the points of the mesh where the unknowns say.
  void Move(const Eigen::VectorXd& unknowns);
  /// At the mesh as it is. Infinite with ε = 0 where a corner is not positive.
  double Value(double epsilon, Eigen::VectorXd* gradient = nullptr) const;
  /// Least D.
  double LeastDeterminant() const;
  /// Per unknown the inverse square of the lengths that it acts on: the size of the Hessian's diagonal.
  const Eigen::VectorXd& Curvature() const { return this->Diagonal; }

private:
  QuadMesh& Mesh;
  const BoundaryCurves& Curves;
  const double SizePart;
  std::vector<Eigen::Index> First; ///< Unknown of every point; −1: fixed.
  Eigen::Index Count = 0;
  Eigen::VectorXd Diagonal;
};
}
