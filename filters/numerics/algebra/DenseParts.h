#pragma once

#include <Eigen/Core>

#include <complex>

namespace crossfield
{
/// Number of rows below which dense matrices are handled by LAPACK in one thread, in a few
/// milliseconds.
constexpr Eigen::Index MinimumRowsForParts = 512;

/// Eliminates the first columns of a Hermitian matrix, of which only the lower triangle is read:
///   [ A₁₁ . ; A₂₁ A₂₂ ] becomes [ L₁₁ . ; L₂₁, A₂₂ − L₂₁ L₂₁ᴴ ],  A₁₁ = L₁₁ L₁₁ᴴ.
/// With all columns this is its Cholesky factor. Returns false when A₁₁ is not positive definite.
/// Proceeds panel by panel. All work except the diagonal blocks of the panels is divided into tiles
/// (Parts.h), so the result does not depend on the number of threads.
///
/// Scalar is double or std::complex<double>, as in DenseCholesky.
template <typename Scalar>
bool FactorInParts(
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& matrix, Eigen::Index columns);

/// Replaces the lower triangle L by the lower triangle of (L Lᴴ)⁻¹ = XᴴX, with X = L⁻¹ in blocks,
///   X = [ X₁ 0 ; −X₂ L₂₁ X₁, X₂ ], X₁ = L₁₁⁻¹, X₂ = L₂₂⁻¹,
/// also in parts.
template <typename Scalar>
void InvertInParts(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& lower);

extern template bool FactorInParts<double>(Eigen::MatrixXd& matrix, Eigen::Index columns);
extern template bool FactorInParts<std::complex<double>>(
  Eigen::MatrixXcd& matrix, Eigen::Index columns);
extern template void InvertInParts<double>(Eigen::MatrixXd& lower);
extern template void InvertInParts<std::complex<double>>(Eigen::MatrixXcd& lower);
}
