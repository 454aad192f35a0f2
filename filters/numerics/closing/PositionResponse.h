#pragma once

#include "PotentialSolver.h"
#include "SeamlessMap.h"

#include <complex>
#include <memory>

namespace crossfield
{
/// The change of F = H + iθ when singularities move, on a mesh with vertices at them
/// (docs/method.md §14.10): moving b_j by the complex number β changes F by
///   dF = −q_j β / (z − b_j) + R,  q_j = k_j / 4,
/// where R is analytic, its real part U is piecewise linear, and its imaginary part V has values at
/// the midpoints of edges. There is one R for β = 1 and one for β = i per singularity.
///
/// Needs one factorisation, unless the solver of the map is given, and 2N back-substitutions for N
/// singularities.
class PositionResponse
{
public:
  /// Computes the response to moves of the interior singularities of a map on its mesh.
  PositionResponse(const SeamlessMap& map,
    std::shared_ptr<const PotentialSolver> potential = nullptr, const Progress& progress = {});

  /// Returns the cones that may move, rows of SeamlessMap::cones. Coordinates x and y of the m-th
  /// one are columns 2m and 2m + 1 of all derivatives.
  const std::vector<int>& GetMoving() const { return this->Moving; }
  Eigen::Index Columns() const { return static_cast<Eigen::Index>(2 * this->Moving.size()); }
  const Cone& ConeOf(std::size_t m) const { return this->Map.cones[this->Moving[m]]; }
  Point PositionOf(std::size_t m) const
  {
    return this->Map.topology->PositionOf(this->ConeOf(m).vertex).head<2>();
  }

  /// Returns the distance from the m-th moving singularity beyond which the map is accurate: 2.5
  /// edges, but less than half the distance to the next cone.
  double AccurateDistance(std::size_t m) const
  {
    return this->AccurateDistances[static_cast<Eigen::Index>(m)];
  }

  /// Adds R at a point of a triangle times `factor` to the columns of a row.
  void AddRegular(int triangle, const Point& place, const std::complex<double>& factor,
    Eigen::Ref<Eigen::VectorXcd> row) const;

  /// Derivatives of the holonomy defects in radians of θ, a row per inner loop.
  const Eigen::MatrixXd& GetDefectDerivatives() const { return this->Defects; }

private:
  /// Returns the imaginary part of −q_j β / (z − b_j) at the midpoint of an edge.
  Eigen::VectorXd SingularAngles(int edge) const;

  const SeamlessMap& Map;
  std::vector<int> Moving;
  Eigen::VectorXd AccurateDistances; ///< See AccurateDistance.
  Eigen::MatrixXd Real;              ///< U, a row per column of derivatives, a column per vertex.
  Eigen::MatrixXd Imaginary;         ///< V, a row per column of derivatives, a column per edge.
  Eigen::MatrixXd Defects;
};
}
