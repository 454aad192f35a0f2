#pragma once

#include <complex>
#include <cstddef>
#include <type_traits>

namespace crossfield
{
/// Function types of the Fortran interface of BLAS and LAPACK, whose C headers are in other
/// packages. The last arguments are the lengths of the strings, as Fortran compilers pass them.
template <typename Scalar>
struct LapackTypes
{
  using MatrixFunction = void(const char* half, const int* size, Scalar* matrix, const int* leading,
    int* info, std::size_t halfLength);
  using TriangleFunction = void(const char* half, const char* unit, const int* size, Scalar* matrix,
    const int* leading, int* info, std::size_t halfLength, std::size_t unitLength);
  using TriangleProduct = void(const char* side, const char* half, const char* turned,
    const char* unit, const int* rows, const int* columns, const Scalar* factor,
    const Scalar* triangle, const int* leadingOfTriangle, Scalar* matrix, const int* leading,
    std::size_t sideLength, std::size_t halfLength, std::size_t turnedLength,
    std::size_t unitLength);
  using Square = void(const char* half, const char* turned, const int* size, const int* inner,
    const double* factor, const Scalar* matrix, const int* leading, const double* factorOfResult,
    Scalar* result, const int* leadingOfResult, std::size_t halfLength, std::size_t turnedLength);
  using Multiply = void(const char* ofLeft, const char* ofRight, const int* rows,
    const int* columns, const int* inner, const Scalar* factor, const Scalar* left,
    const int* leadingOfLeft, const Scalar* right, const int* leadingOfRight,
    const Scalar* factorOfResult, Scalar* result, const int* leadingOfResult,
    std::size_t ofLeftLength, std::size_t ofRightLength);
  using SolveVector = void(const char* half, const char* turned, const char* unit, const int* size,
    const Scalar* triangle, const int* leading, Scalar* vector, const int* step,
    std::size_t halfLength, std::size_t turnedLength, std::size_t unitLength);
  using MultiplyVector = void(const char* turned, const int* rows, const int* columns,
    const Scalar* factor, const Scalar* matrix, const int* leading, const Scalar* vector,
    const int* step, const Scalar* factorOfResult, Scalar* result, const int* stepOfResult,
    std::size_t turnedLength);
  using AddMultiple = void(const int* size, const Scalar* factor, const Scalar* x,
    const int* stepOfX, Scalar* y, const int* stepOfY);
};

extern "C"
{
  LapackTypes<double>::MatrixFunction dpotrf_, dpotri_, dlauum_;
  LapackTypes<double>::TriangleFunction dtrtri_;
  LapackTypes<double>::TriangleProduct dtrsm_, dtrmm_;
  LapackTypes<double>::Square dsyrk_;
  LapackTypes<double>::Multiply dgemm_;
  LapackTypes<double>::SolveVector dtrsv_;
  LapackTypes<double>::MultiplyVector dgemv_;
  LapackTypes<std::complex<double>>::MatrixFunction zpotrf_, zpotri_, zlauum_;
  LapackTypes<std::complex<double>>::TriangleFunction ztrtri_;
  LapackTypes<std::complex<double>>::TriangleProduct ztrsm_, ztrmm_;
  LapackTypes<std::complex<double>>::Square zherk_;
  LapackTypes<std::complex<double>>::Multiply zgemm_;
  LapackTypes<std::complex<double>>::AddMultiple zaxpy_;
}

/// Returns the function for the given scalar type.
template <typename Scalar, typename Real, typename Complex>
constexpr auto* LapackOf(Real* real, Complex* complex)
{
  if constexpr (std::is_same_v<Scalar, double>)
  {
    return real;
  }
  else
  {
    return complex;
  }
}

/// BLAS and LAPACK functions by their purpose, for either scalar type.
template <typename Scalar>
struct Lapack
{
  static constexpr auto* Factor = LapackOf<Scalar>(dpotrf_, zpotrf_);
  static constexpr auto* InvertFactored = LapackOf<Scalar>(dpotri_, zpotri_);
  static constexpr auto* InvertTriangle = LapackOf<Scalar>(dtrtri_, ztrtri_);
  static constexpr auto* SquareTriangle = LapackOf<Scalar>(dlauum_, zlauum_);
  static constexpr auto* SolveTriangle = LapackOf<Scalar>(dtrsm_, ztrsm_);
  static constexpr auto* MultiplyTriangle = LapackOf<Scalar>(dtrmm_, ztrmm_);
  static constexpr auto* Square = LapackOf<Scalar>(dsyrk_, zherk_);
  static constexpr auto* Multiply = LapackOf<Scalar>(dgemm_, zgemm_);
};
}
