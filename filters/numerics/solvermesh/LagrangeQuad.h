#pragma once

#include "Plane.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Derivatives of the Lagrange polynomials of quads of one order at the Gauss points, for det J.
class LagrangeQuad
{
public:
  explicit LagrangeQuad(int order);

  /// Minimum and maximum of det J of the map from the unit square over the (order + 1)² Gauss points.
  struct Range
  {
    double min = 0.0;
    double max = 0.0;
  };
  /// `nodes` are the columns of a matrix, in the order of SolverMesh::cells.
  Range MeasureJacobian(const Eigen::Matrix2Xd& nodes) const;

private:
  Eigen::MatrixXd AlongFirst;  ///< Per node and Gauss point.
  Eigen::MatrixXd AlongSecond; ///< Per node and Gauss point.
};
}
