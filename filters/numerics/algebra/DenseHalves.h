#pragma once

#include <Eigen/Core>

#include <complex>

namespace crossfield
{
/// Number of rows below which dense matrices are handled by LAPACK in one thread, in a few
/// milliseconds.
constexpr Eigen::Index MinimumRowsForHalves = 512;

/// Replaces the lower triangle of a Hermitian matrix by its Cholesky factor L; returns false when
/// the matrix is not positive definite. Proceeds panel by panel. All work except the diagonal
/// blocks of the panels is divided into two concurrent tasks (BothHalves.h), so the result does not
/// depend on the number of threads.
///
/// Scalar is double or std::complex<double>, as in DenseCholesky.
template <typename Scalar>
bool FactorInHalves(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& matrix);

/// Replaces the lower triangle L by the lower triangle of (L Lᴴ)⁻¹ = XᴴX, with X = L⁻¹ in blocks,
///   X = [ X₁ 0 ; −X₂ L₂₁ X₁, X₂ ], X₁ = L₁₁⁻¹, X₂ = L₂₂⁻¹,
/// also in two concurrent tasks.
template <typename Scalar>
void InvertInHalves(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& lower);

extern template bool FactorInHalves<double>(Eigen::MatrixXd& matrix);
extern template bool FactorInHalves<std::complex<double>>(Eigen::MatrixXcd& matrix);
extern template void InvertInHalves<double>(Eigen::MatrixXd& lower);
extern template void InvertInHalves<std::complex<double>>(Eigen::MatrixXcd& lower);
}
