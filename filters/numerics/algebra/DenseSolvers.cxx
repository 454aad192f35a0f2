#include "DenseSolvers.h"

#include <Eigen/QR>

template class Eigen::BDCSVD<Eigen::MatrixXd>;
template class Eigen::JacobiSVD<Eigen::MatrixXd>;

namespace crossfield
{
Eigen::VectorXd LeastSquares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rightHandSide)
{
  return matrix.completeOrthogonalDecomposition().solve(rightHandSide);
}
}
