/// \file
/// Decompositions of small dense matrices of any rank, compiled once: the compiler takes up to half a minute for one.
#pragma once

#include <Eigen/SVD>

extern template class Eigen::BDCSVD<Eigen::MatrixXd>;
extern template class Eigen::JacobiSVD<Eigen::MatrixXd>;

namespace crossfield
{
/// Returns the shortest of the vectors x that minimise |A x − b|.
Eigen::VectorXd LeastSquares(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rightHandSide);
}
