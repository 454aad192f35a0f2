#include "DenseCholesky.h"

#include "BothHalves.h"
#include "DenseHalves.h"
#include "DenseProduct.h"
#include "SerialBlas.h"

#include <array>
#include <utility>

// The Fortran interface of LAPACK; its C headers are another package. The last argument is the
// length of the string, as Fortran compilers pass it.
extern "C"
{
  void dpotrf_(const char* half, const int* size, double* matrix, const int* leading, int* info,
    std::size_t halfLength);
  void zpotrf_(const char* half, const int* size, std::complex<double>* matrix, const int* leading,
    int* info, std::size_t halfLength);
  void dpotri_(const char* half, const int* size, double* matrix, const int* leading, int* info,
    std::size_t halfLength);
  void zpotri_(const char* half, const int* size, std::complex<double>* matrix, const int* leading,
    int* info, std::size_t halfLength);
  void dtrsm_(const char* side, const char* half, const char* transposed, const char* diagonal,
    const int* rows, const int* columns, const double* factor, const double* triangle,
    const int* leading, double* matrix, const int* leadingOfMatrix, std::size_t sideLength,
    std::size_t halfLength, std::size_t transposedLength, std::size_t diagonalLength);
  void ztrsm_(const char* side, const char* half, const char* transposed, const char* diagonal,
    const int* rows, const int* columns, const std::complex<double>* factor,
    const std::complex<double>* triangle, const int* leading, std::complex<double>* matrix,
    const int* leadingOfMatrix, std::size_t sideLength, std::size_t halfLength,
    std::size_t transposedLength, std::size_t diagonalLength);
}

namespace crossfield
{
namespace
{
void Factorise(const int* size, double* matrix, int* info)
{
  dpotrf_("L", size, matrix, size, info, 1);
}

void Factorise(const int* size, std::complex<double>* matrix, int* info)
{
  zpotrf_("L", size, matrix, size, info, 1);
}

/// L⁻¹ times the columns of a matrix, in place.
void SolveLower(const int* size, const double* lower, const int* columns, double* matrix)
{
  const double one = 1.0;
  dtrsm_("L", "L", "N", "N", size, columns, &one, lower, size, matrix, size, 1, 1, 1, 1);
}

void SolveLower(const int* size, const std::complex<double>* lower, const int* columns,
  std::complex<double>* matrix)
{
  const std::complex<double> one = 1.0;
  ztrsm_("L", "L", "N", "N", size, columns, &one, lower, size, matrix, size, 1, 1, 1, 1);
}

void Invert(const int* size, double* factor, int* info)
{
  dpotri_("L", size, factor, size, info, 1);
}

void Invert(const int* size, std::complex<double>* factor, int* info)
{
  zpotri_("L", size, factor, size, info, 1);
}
}

template <typename Scalar>
DenseCholesky<Scalar>::DenseCholesky(Matrix matrix)
  : Lower(std::move(matrix))
{
  if (this->Lower.size() == 0)
  {
    return; // LAPACK calls a leading dimension of 0 an error
  }
  const SerialBlas serial;
  if (this->Lower.rows() >= FewestRowsForHalves)
  {
    this->PositiveDefinite = FactorInHalves<Scalar>(this->Lower);
  }
  else
  {
    const auto size = static_cast<int>(this->Lower.rows());
    int info = 0;
    Factorise(&size, this->Lower.data(), &info);
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
    const auto middle = static_cast<int>(columns.cols()) / 2;
    const std::array<int, 3> ends = { 0, middle, static_cast<int>(columns.cols()) };
    ForBothHalves(size >= FewestRowsForHalves,
      [&](std::size_t half)
      {
        const int count = ends[half + 1] - ends[half];
        SolveLower(
          &size, this->Lower.data(), &count, columns.col(0).data() + ends[half] * columns.rows());
      });
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
    if (inverse.rows() >= FewestRowsForHalves)
    {
      InvertInHalves<Scalar>(inverse);
    }
    else
    {
      const auto size = static_cast<int>(inverse.rows());
      int info =
        0; // not 0 only for a zero on the diagonal, which a positive definite matrix has not
      Invert(&size, inverse.data(), &info);
    }
    inverse.template triangularView<Eigen::StrictlyUpper>() = inverse.adjoint();
  }
  return inverse;
}

template class DenseCholesky<double>;
template class DenseCholesky<std::complex<double>>;
}
