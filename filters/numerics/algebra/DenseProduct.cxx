#include "DenseProduct.h"

#include "SerialBlas.h"

#include <complex>

// The Fortran interface of BLAS; see DenseCholesky.
extern "C"
{
  void dtrsm_(const char* side, const char* half, const char* transposed, const char* unit,
    const int* rows, const int* columns, const double* factor, const double* triangle,
    const int* leadingOfTriangle, double* result, const int* leadingOfResult,
    std::size_t sideLength, std::size_t halfLength, std::size_t transposedLength,
    std::size_t unitLength);
  void dgemm_(const char* ofLeft, const char* ofRight, const int* rows, const int* columns,
    const int* inner, const double* factor, const double* left, const int* leadingOfLeft,
    const double* right, const int* leadingOfRight, const double* factorOfResult, double* result,
    const int* leadingOfResult, std::size_t ofLeftLength, std::size_t ofRightLength);
  void zgemm_(const char* ofLeft, const char* ofRight, const int* rows, const int* columns,
    const int* inner, const std::complex<double>* factor, const std::complex<double>* left,
    const int* leadingOfLeft, const std::complex<double>* right, const int* leadingOfRight,
    const std::complex<double>* factorOfResult, std::complex<double>* result,
    const int* leadingOfResult, std::size_t ofLeftLength, std::size_t ofRightLength);
  void zaxpy_(const int* size, const std::complex<double>* factor, const std::complex<double>* x,
    const int* stepOfX, std::complex<double>* y, const int* stepOfY);
}

namespace crossfield
{
namespace
{
/// With "N" or "C" for A or its adjoint, by one of the functions above.
template <typename Matrix, typename Function>
Matrix Multiply(Function* gemm, const char* ofLeft, const Eigen::Ref<const Matrix>& left,
  const Eigen::Ref<const Matrix>& right)
{
  const Eigen::Index height = *ofLeft == 'C' ? left.cols() : left.rows();
  Matrix product = Matrix::Zero(height, right.cols());
  if (product.size() > 0 && right.rows() > 0)
  {
    const SerialBlas serial;
    const auto rows = static_cast<int>(height);
    const auto columns = static_cast<int>(right.cols());
    const auto inner = static_cast<int>(right.rows());
    const auto leadingOfLeft = static_cast<int>(left.outerStride());
    const auto leadingOfRight = static_cast<int>(right.outerStride());
    const typename Matrix::Scalar one = 1.0;
    const typename Matrix::Scalar zero = 0.0;
    gemm(ofLeft, "N", &rows, &columns, &inner, &one, left.data(), &leadingOfLeft, right.data(),
      &leadingOfRight, &zero, product.data(), &rows, 1, 1);
  }
  return product;
}
}

Eigen::MatrixXd DenseProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right)
{
  return Multiply<Eigen::MatrixXd>(dgemm_, "N", left, right);
}

Eigen::MatrixXd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right)
{
  return Multiply<Eigen::MatrixXd>(dgemm_, "C", left, right);
}

Eigen::MatrixXcd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXcd>& left, const Eigen::Ref<const Eigen::MatrixXcd>& right)
{
  return Multiply<Eigen::MatrixXcd>(zgemm_, "C", left, right);
}

void AddMultiple(std::complex<double> factor, const Eigen::Ref<const Eigen::VectorXcd>& x,
  Eigen::Ref<Eigen::VectorXcd> y)
{
  const SerialBlas serial;
  const auto size = static_cast<int>(x.size());
  const int step = 1;
  zaxpy_(&size, &factor, x.data(), &step, y.data(), &step);
}

void SolveLowerInPlace(
  const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> columns)
{
  if (columns.size() > 0)
  {
    const SerialBlas serial;
    const auto rows = static_cast<int>(columns.rows());
    const auto count = static_cast<int>(columns.cols());
    const auto leadingOfLower = static_cast<int>(lower.outerStride());
    const auto leading = static_cast<int>(columns.outerStride());
    const double one = 1.0;
    dtrsm_("L", "L", "N", "N", &rows, &count, &one, lower.data(), &leadingOfLower, columns.data(),
      &leading, 1, 1, 1, 1);
  }
}
}
