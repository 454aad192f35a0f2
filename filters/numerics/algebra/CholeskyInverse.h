#pragma once

#include <Eigen/Core>

namespace crossfield
{
/// (L Lᵀ)⁻¹ from a lower triangular L by LAPACK (dpotri), in place: both halves.
Eigen::MatrixXd CholeskyInverse(Eigen::MatrixXd lower);
}
