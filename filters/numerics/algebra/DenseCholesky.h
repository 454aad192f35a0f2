#pragma once

#include <Eigen/Core>

#include <complex>

namespace crossfield
{
/// Cholesky factorisation A = L Lᴴ of a dense Hermitian matrix by LAPACK (?potrf), which is ten
/// times faster than Eigen's at the few hundred unknowns of holes and separators.
///
/// Scalar is double or std::complex<double>.
template <typename Scalar>
class DenseCholesky
{
public:
  using Matrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;

  /// Of an empty matrix.
  DenseCholesky() = default;

  /// Reads the lower half of the matrix.
  explicit DenseCholesky(Matrix matrix);

  /// Without this the rest is undefined.
  bool IsPositiveDefinite() const { return this->PositiveDefinite; }

  /// L, zero above the diagonal.
  const Matrix& GetLower() const { return this->Lower; }

  /// A⁻¹ B.
  Matrix Solve(const Matrix& rightHandSides) const
  {
    const auto lower = this->Lower.template triangularView<Eigen::Lower>();
    return lower.adjoint().solve(lower.solve(rightHandSides));
  }

  /// Bᴴ A⁻¹ B, by BLAS (?trsm, ?gemm).
  Matrix Form(Matrix columns) const;

  /// A⁻¹ (?potri), in half the time of solving for the unit matrix.
  Matrix Inverse() const;

private:
  Matrix Lower;
  bool PositiveDefinite = true;
};

extern template class DenseCholesky<double>;
extern template class DenseCholesky<std::complex<double>>;
}
