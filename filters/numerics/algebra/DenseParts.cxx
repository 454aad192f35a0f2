#include "DenseParts.h"

#include "Lapack.h"
#include "Parts.h"

#include <algorithm>
#include <utility>
#include <vector>

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

/// Replaces B by factor × T B (side "L") or factor × B T (side "R"), where T is a lower triangle.
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

/// Replaces C by Aᴴ B.
template <typename Scalar>
void SetAdjointProduct(const Part<Scalar>& a, const Part<Scalar>& b, const Part<Scalar>& c)
{
  const Scalar zero = 0.0;
  const Scalar one = One;
  Lapack<Scalar>::Multiply("C", "N", &a.columns, &b.columns, &a.rows, &one, a.data, &a.leading,
    b.data, &b.leading, &zero, c.data, &c.leading, 1, 1);
}

/// Rows and columns of a tile.
constexpr int TileSize = 256;

/// Returns the number of strips of rows, or of columns, of at most about one tile.
std::size_t StripCount(int size)
{
  return static_cast<std::size_t>(std::max(1, (size + TileSize / 2) / TileSize));
}

/// Calls function(i, j) for the tiles on and below the diagonal of a matrix of tiles.
template <typename Function>
void ForLowerTiles(std::size_t strips, const Function& function)
{
  std::vector<std::pair<std::size_t, std::size_t>> tiles;
  for (std::size_t i = 0; i < strips; ++i)
  {
    for (std::size_t j = 0; j <= i; ++j)
    {
      tiles.emplace_back(i, j);
    }
  }
  ForParts(
    tiles.size(), [&](std::size_t tile) { function(tiles[tile].first, tiles[tile].second); });
}

/// Replaces a lower triangle, from a row and column on, by its inverse.
template <typename Matrix>
void InvertTriangle(Matrix& lower, int first, int size)
{
  using Scalar = typename Matrix::Scalar;
  const Part<Scalar> triangle(lower, first, first, size, size);
  if (size <= static_cast<int>(MinimumRowsForParts))
  {
    int info = 0; // non-zero only for a zero on the diagonal, which L does not have
    Lapack<Scalar>::InvertTriangle("L", "N", &size, triangle.data, &triangle.leading, &info, 1, 1);
    return;
  }
  const int upper = size / 2;
  const int rest = size - upper;
  ForParts(2,
    [&](std::size_t part)
    { InvertTriangle(lower, part == 0 ? first : first + upper, part == 0 ? upper : rest); });
  const Part<Scalar> before(lower, first, first, upper, upper);
  const Part<Scalar> after(lower, first + upper, first + upper, rest, rest);
  ForParts(StripCount(upper),
    [&](std::size_t strip)
    {
      const auto [begin, end] = PartRange(upper, strip, StripCount(upper));
      MultiplyByTriangle("L", "N", MinusOne, after,
        Part<Scalar>(lower, first + upper, first + begin, rest, end - begin));
    });
  ForParts(StripCount(rest),
    [&](std::size_t strip)
    {
      const auto [begin, end] = PartRange(rest, strip, StripCount(rest));
      MultiplyByTriangle("R", "N", One, before,
        Part<Scalar>(lower, first + upper + begin, first, end - begin, upper));
    });
}
}

template <typename Scalar>
bool FactorInParts(
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& matrix, Eigen::Index columns)
{
  constexpr int Panel = 192; // the diagonal blocks take a few per cent of the work
  const auto size = static_cast<int>(matrix.rows());
  const auto end = static_cast<int>(columns);
  for (int first = 0; first < end; first += Panel)
  {
    const int width = std::min(Panel, end - first);
    const Part<Scalar> triangle(matrix, first, first, width, width);
    int info = 0;
    Lapack<Scalar>::Factor("L", &width, triangle.data, &triangle.leading, &info, 1);
    if (info != 0)
    {
      return false;
    }
    const int next = first + width;
    const int rest = size - next;
    if (rest == 0)
    {
      break;
    }
    const std::size_t strips = StripCount(rest);
    const auto panelRows = [&](std::size_t strip)
    {
      const auto [from, to] = PartRange(rest, strip, strips);
      return Part<Scalar>(matrix, next + from, first, to - from, width);
    };
    ForParts(strips, [&](std::size_t strip) { SolveFromRight(triangle, panelRows(strip)); });
    ForLowerTiles(strips,
      [&](std::size_t i, std::size_t j)
      {
        const Part<Scalar> left = panelRows(i);
        const Part<Scalar> right = panelRows(j);
        const Part<Scalar> tile(matrix, next + PartRange(rest, i, strips).first,
          next + PartRange(rest, j, strips).first, left.rows, right.rows);
        if (i == j)
        {
          SubtractSquare(left, tile);
        }
        else
        {
          SubtractProduct(left, right, tile);
        }
      });
  }
  return true;
}

template <typename Scalar>
void InvertInParts(Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>& lower)
{
  const auto size = static_cast<int>(lower.rows());
  lower.template triangularView<Eigen::StrictlyUpper>().setZero();
  InvertTriangle(lower, 0, size);
  // Rows above those of tile i are zero in its columns of X.
  Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic> product(size, size);
  const std::size_t strips = StripCount(size);
  ForLowerTiles(strips,
    [&](std::size_t i, std::size_t j)
    {
      const auto [row, rowEnd] = PartRange(size, i, strips);
      const auto [column, columnEnd] = PartRange(size, j, strips);
      SetAdjointProduct(Part<Scalar>(lower, row, row, size - row, rowEnd - row),
        Part<Scalar>(lower, row, column, size - row, columnEnd - column),
        Part<Scalar>(product, row, column, rowEnd - row, columnEnd - column));
    });
  lower = std::move(product);
}

template bool FactorInParts<double>(Eigen::MatrixXd& matrix, Eigen::Index columns);
template bool FactorInParts<std::complex<double>>(Eigen::MatrixXcd& matrix, Eigen::Index columns);
template void InvertInParts<double>(Eigen::MatrixXd& lower);
template void InvertInParts<std::complex<double>>(Eigen::MatrixXcd& lower);
}
