#include "DenseHalves.h"

#include "BothHalves.h"
#include "Lapack.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// View of a rectangular part of a matrix.
template <typename Scalar>
struct Part
{
  Scalar* data;
  int rows;
  int columns;
  int leading;

  template <typename Matrix>
  Part(Matrix& of, int row, int column, int height, int width)
    : data(of.data() + row + column * of.outerStride())
    , rows(height)
    , columns(width)
    , leading(static_cast<int>(of.outerStride()))
  {
  }
};

constexpr double MinusOne = -1.0;
constexpr double One = 1.0;

/// Replaces B by B L⁻ᴴ.
template <typename Scalar>
void SolveFromRight(const Part<Scalar>& lower, const Part<Scalar>& b)
{
  const Scalar one = One;
  Lapack<Scalar>::SolveTriangle("R", "L", "C", "N", &b.rows, &b.columns, &one, lower.data,
    &lower.leading, b.data, &b.leading, 1, 1, 1, 1);
}

/// Replaces B by factor × T B (side "L"), factor × Tᴴ B, or factor × B T (side "R"), where T is a
/// lower triangle.
template <typename Scalar>
void MultiplyByTriangle(const char* side, const char* turned, double factor,
  const Part<Scalar>& lower, const Part<Scalar>& b)
{
  const Scalar scale = factor;
  Lapack<Scalar>::MultiplyTriangle(side, "L", turned, "N", &b.rows, &b.columns, &scale, lower.data,
    &lower.leading, b.data, &b.leading, 1, 1, 1, 1);
}

/// Subtracts B Bᴴ from the lower triangle of C.
template <typename Scalar>
void SubtractSquare(const Part<Scalar>& b, const Part<Scalar>& c)
{
  Lapack<Scalar>::Square(
    "L", "N", &b.rows, &b.columns, &MinusOne, b.data, &b.leading, &One, c.data, &c.leading, 1, 1);
}

/// Subtracts A Bᴴ from C.
template <typename Scalar>
void SubtractProduct(const Part<Scalar>& a, const Part<Scalar>& b, const Part<Scalar>& c)
{
  const Scalar minus = MinusOne;
  const Scalar one = One;
  Lapack<Scalar>::Multiply("N", "C", &a.rows, &b.rows, &a.columns, &minus, a.data, &a.leading,
    b.data, &b.leading, &one, c.data, &c.leading, 1, 1);
}
}

template <typename Scalar>
bool FactorInHalves(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& matrix)
{
  constexpr int Panel = 192; // the diagonal blocks take a few per cent of the work
  const auto size = static_cast<int>(matrix.rows());
  for (int first = 0; first < size; first += Panel)
  {
    const int width = std::min(Panel, size - first);
    const Part<Scalar> triangle(matrix, first, first, width, width);
    int info = 0;
    Lapack<Scalar>::Factor("L", &width, triangle.data, &triangle.leading, &info, 1);
    if (info != 0)
    {
      return false;
    }
    const int next = first + width;
    const int rest = size - next;
    ForBothHalves(true,
      [&](std::size_t half)
      {
        const auto [begin, end] = HalfRange(rest, half);
        SolveFromRight(triangle, Part<Scalar>(matrix, next + begin, first, end - begin, width));
      });
    // The remaining triangle: one task updates its first columns, the other one the remaining
    // columns.
    const int columns = static_cast<int>(rest * (1.0 - std::sqrt(0.5)));
    const Part<Scalar> above(matrix, next, first, columns, width);
    const Part<Scalar> below(matrix, next + columns, first, rest - columns, width);
    ForBothHalves(true,
      [&](std::size_t half)
      {
        if (half == 0)
        {
          SubtractSquare(above, Part<Scalar>(matrix, next, next, columns, columns));
          SubtractProduct(
            below, above, Part<Scalar>(matrix, next + columns, next, rest - columns, columns));
        }
        else
        {
          SubtractSquare(below,
            Part<Scalar>(matrix, next + columns, next + columns, rest - columns, rest - columns));
        }
      });
  }
  return true;
}

template <typename Scalar>
void InvertInHalves(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& lower)
{
  const auto size = static_cast<int>(lower.rows());
  const int upper = size / 2;
  const int rest = size - upper;
  const Part<Scalar> first(lower, 0, 0, upper, upper);
  const Part<Scalar> second(lower, upper, upper, rest, rest);
  const Part<Scalar> across(lower, upper, 0, rest, upper);
  // 1. Compute X.
  ForBothHalves(true,
    [&](std::size_t half)
    {
      const Part<Scalar>& triangle = half == 0 ? first : second;
      int info = 0; // non-zero only for a zero on the diagonal, which L does not have
      Lapack<Scalar>::InvertTriangle(
        "L", "N", &triangle.rows, triangle.data, &triangle.leading, &info, 1, 1);
    });
  ForBothHalves(true,
    [&](std::size_t half)
    {
      const auto [begin, end] = HalfRange(upper, half);
      MultiplyByTriangle(
        "L", "N", MinusOne, second, Part<Scalar>(lower, upper, begin, rest, end - begin));
    });
  ForBothHalves(true,
    [&](std::size_t half)
    {
      const auto [begin, end] = HalfRange(rest, half);
      MultiplyByTriangle(
        "R", "N", One, first, Part<Scalar>(lower, upper + begin, 0, end - begin, upper));
    });
  // 2. Compute XᴴX. Both tasks read the off-diagonal block.
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> product =
    lower.bottomLeftCorner(rest, upper);
  ForBothHalves(true,
    [&](std::size_t half)
    {
      int info = 0;
      if (half == 0)
      {
        Lapack<Scalar>::SquareTriangle("L", &upper, first.data, &first.leading, &info, 1);
        Lapack<Scalar>::Square("L", "C", &upper, &rest, &One, across.data, &across.leading, &One,
          first.data, &first.leading, 1, 1);
      }
      else
      {
        MultiplyByTriangle("L", "C", One, second, Part<Scalar>(product, 0, 0, rest, upper));
        Lapack<Scalar>::SquareTriangle("L", &rest, second.data, &second.leading, &info, 1);
      }
    });
  lower.bottomLeftCorner(rest, upper) = product;
}

template bool FactorInHalves<double>(Eigen::MatrixXd& matrix);
template bool FactorInHalves<std::complex<double>>(Eigen::MatrixXcd& matrix);
template void InvertInHalves<double>(Eigen::MatrixXd& lower);
template void InvertInHalves<std::complex<double>>(Eigen::MatrixXcd& lower);
}
