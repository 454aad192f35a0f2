#include "DenseCholesky.h"

#include "DenseParts.h"
#include "DenseProduct.h"
#include "Lapack.h"
#include "Parts.h"
#include "SerialBlas.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
template <typename Scalar>
DenseCholesky<Scalar>::DenseCholesky(Matrix matrix)
  : Lower(std::move(matrix))
{
  if (this->Lower.size() == 0)
  {
    return; // LAPACK rejects a leading dimension of 0
  }
  const SerialBlas serial;
  if (this->Lower.rows() >= MinimumRowsForParts)
  {
    this->PositiveDefinite = FactorInParts<Scalar>(this->Lower, this->Lower.cols());
  }
  else
  {
    const auto size = static_cast<int>(this->Lower.rows());
    int info = 0;
    Lapack<Scalar>::Factor("L", &size, this->Lower.data(), &size, &info, 1);
    this->PositiveDefinite = info == 0;
  }
  this->Lower.template triangularView<Eigen::StrictlyUpper>().setZero();
}

template <typename Scalar>
typename DenseCholesky<Scalar>::Matrix DenseCholesky<Scalar>::Form(Matrix columns) const
{
  if (columns.size() > 0)
  {
    const SerialBlas serial;
    const auto size = static_cast<int>(columns.rows());
    const Scalar one = 1.0;
    constexpr Eigen::Index MinimumColumns = 32; // BLAS is slower with fewer
    ForRanges(
      columns.cols(),
      [&](int begin, int end)
      {
        const int count = end - begin;
        Lapack<Scalar>::SolveTriangle("L", "L", "N", "N", &size, &count, &one, this->Lower.data(),
          &size, columns.data() + begin * columns.rows(), &size, 1, 1, 1, 1);
      },
      size >= MinimumRowsForParts ? MinimumColumns : std::max<Eigen::Index>(1, columns.cols()));
  }
  return AdjointProduct(columns, columns);
}

template <typename Scalar>
typename DenseCholesky<Scalar>::Matrix DenseCholesky<Scalar>::Inverse() const
{
  Matrix inverse = this->Lower;
  if (inverse.size() > 0)
  {
    const SerialBlas serial;
    if (inverse.rows() >= MinimumRowsForParts)
    {
      InvertInParts<Scalar>(inverse);
    }
    else
    {
      const auto size = static_cast<int>(inverse.rows());
      int info = 0; // non-zero only for a zero on the diagonal, which L does not have
      Lapack<Scalar>::InvertFactored("L", &size, inverse.data(), &size, &info, 1);
    }
    inverse.template triangularView<Eigen::StrictlyUpper>() = inverse.adjoint();
  }
  return inverse;
}

template class DenseCholesky<double>;
template class DenseCholesky<std::complex<double>>;
}
