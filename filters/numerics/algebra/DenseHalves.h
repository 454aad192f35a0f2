#pragma once

#include <Eigen/Core>

#include <complex>

namespace crossfield
{
/// Below this number of rows a dense matrix is left to LAPACK in one thread: it takes some milliseconds.
constexpr Eigen::Index FewestRowsForHalves = 512;

/// L of a Hermitian matrix of which the lower half is read and replaced by L; false when it is not positive definite.
/// Panel by panel, and all but the panels' own triangles in two halves at the same time (BothHalves.h), so
/// the result does not depend on the number of threads.
///
/// Scalar is double or std::complex<double>, as in DenseCholesky.
template <typename Scalar>
bool FactorInHalves(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& matrix);

/// The lower half of (L Lᴴ)⁻¹ = XᴴX in the place of that of L, with X = L⁻¹ by blocks,
///   X = [ X₁ 0 ; −X₂ L₂₁ X₁, X₂ ],  X₁ = L₁₁⁻¹,  X₂ = L₂₂⁻¹,
/// in two halves at the same time as well.
template <typename Scalar>
void InvertInHalves(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& lower);

extern template bool FactorInHalves<double>(Eigen::MatrixXd& matrix);
extern template bool FactorInHalves<std::complex<double>>(Eigen::MatrixXcd& matrix);
extern template void InvertInHalves<double>(Eigen::MatrixXd& lower);
extern template void InvertInHalves<std::complex<double>>(Eigen::MatrixXcd& lower);
}
