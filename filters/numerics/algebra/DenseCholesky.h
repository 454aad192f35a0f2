#pragma once

#include <Eigen/Core>

#include <complex>

namespace crossfield
{
/// Cholesky factorisation A = L Lᴴ of a dense Hermitian matrix by LAPACK (?potrf), which is ten
/// times faster than Eigen for the few hundred unknowns on holes and separators.
///
/// Scalar is double or std::complex<double>.
template <typename Scalar>
class DenseCholesky
{
public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// Constructs the factor of an empty matrix.
  DenseCholesky() = default;

  /// Factors the matrix. Only its lower triangle is read.
  explicit DenseCholesky(Matrix matrix);

  /// Returns whether the matrix is positive definite; all other functions require it.
  bool IsPositiveDefinite() const { return this->PositiveDefinite; }

  /// Returns L, with zeros above the diagonal.
  const Matrix& GetLower() const { return this->Lower; }

  /// Returns A⁻¹ B.
  Matrix Solve(const Matrix& rightHandSides) const
  {
    const auto lower = this->Lower.template triangularView<Eigen::Lower>();
    return lower.adjoint().solve(lower.solve(rightHandSides));
  }

  /// Returns Bᴴ A⁻¹ B, computed by BLAS (?trsm, ?gemm).
  Matrix Form(Matrix columns) const;

  /// Returns A⁻¹ (?potri), in half the time of a solve with the identity matrix.
  Matrix Inverse() const;

private:
  Matrix Lower;
  bool PositiveDefinite = true;
};

extern template class DenseCholesky<double>;
extern template class DenseCholesky<std::complex<double>>;
}
