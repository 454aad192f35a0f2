#include "DenseProduct.h"

#include "SerialBlas.h"

// The Fortran interface of BLAS; see DenseCholesky.
extern "C" void dgemm_(const char* ofLeft, const char* ofRight, const int* rows, const int* columns,
  const int* inner, const double* factor, const double* left, const int* leadingOfLeft,
  const double* right, const int* leadingOfRight, const double* factorOfResult, double* result,
  const int* leadingOfResult, std::size_t ofLeftLength, std::size_t ofRightLength);

namespace crossfield
{
namespace
{
using Columns = Eigen::Ref<const Eigen::MatrixXd>;

Eigen::MatrixXd Multiply(const Columns& left, char ofLeft, const Columns& right)
{
  const Eigen::Index height = ofLeft == 'T' ? left.cols() : left.rows();
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(height, right.cols());
  if (product.size() > 0 && right.rows() > 0)
  {
    const SerialBlas serial;
    const auto rows = static_cast<int>(height);
    const auto columns = static_cast<int>(right.cols());
    const auto inner = static_cast<int>(right.rows());
    const auto leadingOfLeft = static_cast<int>(left.outerStride());
    const auto leadingOfRight = static_cast<int>(right.outerStride());
    const double one = 1.0;
    const double zero = 0.0;
    dgemm_(&ofLeft, "N", &rows, &columns, &inner, &one, left.data(), &leadingOfLeft, right.data(),
      &leadingOfRight, &zero, product.data(), &rows, 1, 1);
  }
  return product;
}
}

Eigen::MatrixXd DenseProduct(const Columns& left, const Columns& right)
{
  return Multiply(left, 'N', right);
}

Eigen::MatrixXd TransposedProduct(const Columns& left, const Columns& right)
{
  return Multiply(left, 'T', right);
}
}
