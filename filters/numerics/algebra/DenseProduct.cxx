#include "DenseProduct.h"

#include "Lapack.h"
#include "Parts.h"
#include "SerialBlas.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns the minimum number of columns of a part of a product with the given number of
/// multiplications per column: those that take half a millisecond, and enough for BLAS.
Eigen::Index ColumnsForBlas(Eigen::Index perColumn)
{
  constexpr Eigen::Index Multiplications = 4000000;
  return std::max<Eigen::Index>(32, Multiplications / std::max<Eigen::Index>(1, perColumn));
}

/// Multiplies A, or its adjoint, by B; `ofLeft` is "N" for A and "C" for its adjoint.
template <typename Matrix>
Matrix Multiply(
  const char* ofLeft, const Eigen::Ref<const Matrix>& left, const Eigen::Ref<const Matrix>& right)
{
  const Eigen::Index height = *ofLeft == 'C' ? left.cols() : left.rows();
  Matrix product = Matrix::Zero(height, right.cols());
  if (product.size() > 0 && right.rows() > 0)
  {
    const SerialBlas serial;
    const auto rows = static_cast<int>(height);
    const auto inner = static_cast<int>(right.rows());
    const auto leadingOfLeft = static_cast<int>(left.outerStride());
    const auto leadingOfRight = static_cast<int>(right.outerStride());
    const typename Matrix::Scalar one = 1.0;
    const typename Matrix::Scalar zero = 0.0;
    ForRanges(
      right.cols(),
      [&](int begin, int end)
      {
        const int columns = end - begin;
        Lapack<typename Matrix::Scalar>::Multiply(ofLeft, "N", &rows, &columns, &inner, &one,
          left.data(), &leadingOfLeft, right.data() + begin * right.outerStride(), &leadingOfRight,
          &zero, product.data() + begin * height, &rows, 1, 1);
      },
      ColumnsForBlas(height * right.rows()));
  }
  return product;
}
}

Eigen::MatrixXd DenseProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right)
{
  return Multiply<Eigen::MatrixXd>("N", left, right);
}

Eigen::MatrixXd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXd>& left, const Eigen::Ref<const Eigen::MatrixXd>& right)
{
  return Multiply<Eigen::MatrixXd>("C", left, right);
}

Eigen::MatrixXcd AdjointProduct(
  const Eigen::Ref<const Eigen::MatrixXcd>& left, const Eigen::Ref<const Eigen::MatrixXcd>& right)
{
  return Multiply<Eigen::MatrixXcd>("C", left, right);
}

void AddMultiple(std::complex<double> factor, const Eigen::Ref<const Eigen::VectorXcd>& x,
  Eigen::Ref<Eigen::VectorXcd> y)
{
  const SerialBlas serial;
  const auto size = static_cast<int>(x.size());
  const int step = 1;
  zaxpy_(&size, &factor, x.data(), &step, y.data(), &step);
}

namespace
{
void SolveTriangle(const char* turned, const Eigen::Ref<const Eigen::MatrixXd>& lower,
  Eigen::Ref<Eigen::MatrixXd> columns)
{
  if (columns.size() == 0)
  {
    return;
  }
  const SerialBlas serial;
  const auto rows = static_cast<int>(columns.rows());
  const auto count = static_cast<int>(columns.cols());
  const auto leadingOfLower = static_cast<int>(lower.outerStride());
  if (count == 1)
  {
    const int step = 1;
    dtrsv_("L", turned, "N", &rows, lower.data(), &leadingOfLower, columns.data(), &step, 1, 1, 1);
    return;
  }
  const auto leading = static_cast<int>(columns.outerStride());
  const double one = 1.0;
  dtrsm_("L", "L", turned, "N", &rows, &count, &one, lower.data(), &leadingOfLower, columns.data(),
    &leading, 1, 1, 1, 1);
}
}

void SolveLowerInPlace(
  const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> columns)
{
  SolveTriangle("N", lower, columns);
}

void SolveLowerAdjointInPlace(
  const Eigen::Ref<const Eigen::MatrixXd>& lower, Eigen::Ref<Eigen::MatrixXd> columns)
{
  SolveTriangle("T", lower, columns);
}
}
