#include "DissectedCholesky.h"

#include "BothHalves.h"
#include "Lapack.h"
#include "MemoryBudget.h"
#include "NestedDissection.h"
#include "SerialBlas.h"

#include <algorithm>
#include <numeric>

namespace crossfield
{
namespace
{
/// Returns the lower triangle of L Lᵀ, computed by BLAS.
Eigen::MatrixXd TimesTranspose(const Eigen::MatrixXd& lower)
{
  Eigen::MatrixXd product = Eigen::MatrixXd::Zero(lower.rows(), lower.rows());
  if (lower.size() > 0)
  {
    const auto size = static_cast<int>(lower.rows());
    const double one = 1.0;
    const double zero = 0.0;
    dsyrk_("L", "N", &size, &size, &one, lower.data(), &size, &zero, product.data(), &size, 1, 1);
  }
  return product;
}

/// Minimum number of right-hand side values for a substitution in two threads. With fewer, the
/// threads wait for each other longer than they compute when other programs use the processors too,
/// as in an optimiser that solves ten thousand times on a coarse mesh.
constexpr Eigen::Index MinimumValuesForTwoThreads = 20000;

Eigen::Index Count(const std::vector<int>& list)
{
  return static_cast<Eigen::Index>(list.size());
}

void AddTo(const std::vector<int>& positions, const Eigen::MatrixXd& part, Eigen::MatrixXd& whole)
{
  for (std::size_t j = 0; j < positions.size(); ++j)
  {
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      whole(positions[i], positions[j]) +=
        part(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
    }
  }
}

/// Returns the number of border unknowns that are coupled to a half.
Eigen::Index CountCoupled(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& half,
  const std::vector<int>& border)
{
  std::vector<char> inHalf(static_cast<std::size_t>(matrix.rows()), 0);
  for (const int unknown : half)
  {
    inHalf[static_cast<std::size_t>(unknown)] = 1;
  }
  return std::count_if(border.begin(), border.end(),
    [&](int unknown)
    {
      for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, unknown); entry; ++entry)
      {
        if (inHalf[static_cast<std::size_t>(entry.row())] != 0)
        {
          return true;
        }
      }
      return false;
    });
}

/// Throws Error when the factors of both halves and the dense matrices on their borders do not fit
/// into memory.
void RequireMemoryForFactor(const Eigen::SparseMatrix<double>& matrix, const Dissection& dissection)
{
  const auto square = [](std::size_t n) { return static_cast<double>(n) * static_cast<double>(n); };
  double entries = square(dissection.border.size());
  for (const std::vector<int>* half : { &dissection.left, &dissection.right })
  {
    const Eigen::Index border = CountCoupled(matrix, *half, dissection.border);
    // The last block of the half's factor, a copy of it, its square, and the matrix that is
    // subtracted.
    entries += DissectionFill(static_cast<double>(half->size())) +
      4.0 * square(static_cast<std::size_t>(border));
  }
  RequireMemory(entries * sizeof(double),
    "The factorisation of " + std::to_string(matrix.rows()) + " unknowns, of which " +
      std::to_string(dissection.border.size()) +
      " on holes and on the cut through the mesh are dense,",
    "use a larger mesh size, fewer holes or fewer edges on them");
}
}

DissectedCholesky::DissectedCholesky(const Eigen::SparseMatrix<double>& matrix,
  const std::vector<Point>& places, const std::vector<int>& trailing,
  const std::vector<int>& leftOut, const Progress& progress, const std::vector<int>& partners)
  : Size(matrix.rows())
{
  const SerialBlas serial;
  Dissection dissection = Dissect(matrix, places, trailing, leftOut, partners);
  RequireMemoryForFactor(matrix, dissection);
  progress.Report(0.1);
  this->Halves[0].unknowns = std::move(dissection.left);
  this->Halves[1].unknowns = std::move(dissection.right);
  this->Border = std::move(dissection.border);

  const auto borderSize = static_cast<Eigen::Index>(this->Border.size());
  std::vector<int> borderPosition(static_cast<std::size_t>(this->Size), -1);
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    borderPosition[static_cast<std::size_t>(this->Border[i])] = static_cast<int>(i);
  }
  Eigen::MatrixXd schur = Eigen::MatrixXd::Zero(borderSize, borderSize);
  for (Eigen::Index j = 0; j < borderSize; ++j)
  {
    const int column = this->Border[static_cast<std::size_t>(j)];
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, column); entry; ++entry)
    {
      const int i = borderPosition[static_cast<std::size_t>(entry.row())];
      if (i >= 0)
      {
        schur(i, j) = entry.value();
      }
    }
  }
  std::array<Eigen::MatrixXd, 2> parts;
  ForBothHalves(
    true, [&](std::size_t half) { parts[half] = this->FactorHalf(matrix, this->Halves[half]); });
  progress.Report(0.9);
  for (std::size_t half = 0; half < 2; ++half)
  {
    AddTo(this->Halves[half].border, parts[half], schur);
  }
  if (!schur.allFinite())
  {
    throw Error("The matrix has entries that are not finite; the mesh has degenerate triangles, "
                "remesh it.");
  }
  this->BorderFactor = DenseCholesky<double>(std::move(schur));
  if (!this->BorderFactor.IsPositiveDefinite())
  {
    throw NotPositiveDefinite();
  }
  const auto trailingSize = static_cast<Eigen::Index>(trailing.size());
  this->TrailingFactor =
    this->BorderFactor.GetLower().bottomRightCorner(trailingSize, trailingSize);
}

Eigen::MatrixXd DissectedCholesky::FactorHalf(
  const Eigen::SparseMatrix<double>& matrix, Half& half) const
{
  if (half.unknowns.empty())
  {
    return {}; // the matrix is so small that it consists of the border only
  }

  // 1. Find the border unknowns coupled to the half, in the order of the border.
  std::vector<int> local(static_cast<std::size_t>(this->Size), -1); // position in elimination order
  for (std::size_t i = 0; i < half.unknowns.size(); ++i)
  {
    local[static_cast<std::size_t>(half.unknowns[i])] = static_cast<int>(i);
  }
  for (std::size_t i = 0; i < this->Border.size(); ++i)
  {
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, this->Border[i]); entry; ++entry)
    {
      if (local[static_cast<std::size_t>(entry.row())] >= 0)
      {
        half.border.push_back(static_cast<int>(i));
        break;
      }
    }
  }

  // 2. Extract the lower triangle of the matrix on both sets, in elimination order.
  const auto innerSize = static_cast<int>(half.unknowns.size());
  const auto borderSize = static_cast<int>(half.border.size());
  for (int i = 0; i < borderSize; ++i)
  {
    local[static_cast<std::size_t>(
      this->Border[static_cast<std::size_t>(half.border[static_cast<std::size_t>(i)])])] =
      innerSize + i;
  }
  Eigen::SparseMatrix<double> part(innerSize + borderSize, innerSize + borderSize);
  part.reserve(matrix.nonZeros() / 3);
  Eigen::MatrixXd before = Eigen::MatrixXd::Zero(borderSize, borderSize);
  std::vector<std::pair<int, double>> column;
  for (int j = 0; j < innerSize + borderSize; ++j)
  {
    const int unknown = j < innerSize
      ? half.unknowns[static_cast<std::size_t>(j)]
      : this
          ->Border[static_cast<std::size_t>(half.border[static_cast<std::size_t>(j - innerSize)])];
    column.clear();
    for (Eigen::SparseMatrix<double>::InnerIterator entry(matrix, unknown); entry; ++entry)
    {
      const int i = local[static_cast<std::size_t>(entry.row())];
      if (i >= j)
      {
        column.emplace_back(i, entry.value());
      }
      if (i >= innerSize && j >= innerSize)
      {
        before(i - innerSize, j - innerSize) = entry.value();
      }
    }
    std::sort(
      column.begin(), column.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    part.startVec(j);
    for (const auto& [row, value] : column)
    {
      part.insertBack(row, j) = value;
    }
  }
  part.finalize();

  // 3. Factor it; return the Schur complement on the border without the border's own entries.
  std::vector<int> order(static_cast<std::size_t>(innerSize + borderSize));
  std::iota(order.begin(), order.end(), 0);
  half.factor = std::make_unique<SparseCholesky>(part, order);
  half.borderFactor = half.factor->TrailingFactor(borderSize);
  // The lower triangle is sufficient: the half keeps the order of the border, so no entry moves to
  // the upper one.
  return TimesTranspose(half.borderFactor) - before;
}

DissectedCholesky::Eliminated DissectedCholesky::Eliminate(
  const Eigen::MatrixXd& rightHandSides) const
{
  Eliminated eliminated;
  std::array<Eigen::MatrixXd, 2> ofBorder;
  ForBothHalves(rightHandSides.size() >= MinimumValuesForTwoThreads,
    [&](std::size_t h)
    {
      const Half& half = this->Halves[h];
      if (half.unknowns.empty())
      {
        eliminated.halves[h].resize(0, rightHandSides.cols());
        return;
      }
      Eigen::MatrixXd load =
        Eigen::MatrixXd::Zero(Count(half.unknowns) + Count(half.border), rightHandSides.cols());
      for (Eigen::Index i = 0; i < Count(half.unknowns); ++i)
      {
        load.row(i) = rightHandSides.row(half.unknowns[static_cast<std::size_t>(i)]);
      }
      const Eigen::MatrixXd solved = half.factor->SolveLower(load);
      eliminated.halves[h] = solved.topRows(Count(half.unknowns));
      ofBorder[h] = half.borderFactor * solved.bottomRows(Count(half.border));
    });
  eliminated.border.resize(Count(this->Border), rightHandSides.cols());
  for (Eigen::Index i = 0; i < Count(this->Border); ++i)
  {
    eliminated.border.row(i) = rightHandSides.row(this->Border[static_cast<std::size_t>(i)]);
  }
  for (std::size_t h = 0; h < 2; ++h)
  {
    for (Eigen::Index i = 0; i < Count(this->Halves[h].border); ++i)
    {
      eliminated.border.row(this->Halves[h].border[static_cast<std::size_t>(i)]) +=
        ofBorder[h].row(i);
    }
  }
  this->BorderFactor.GetLower().triangularView<Eigen::Lower>().solveInPlace(eliminated.border);
  return eliminated;
}

Eigen::MatrixXd DissectedCholesky::Substitute(const Eliminated& eliminated) const
{
  const Eigen::Index columns = eliminated.border.cols();
  Eigen::MatrixXd solution = Eigen::MatrixXd::Zero(this->Size, columns);
  const Eigen::MatrixXd border =
    this->BorderFactor.GetLower().transpose().triangularView<Eigen::Upper>().solve(
      eliminated.border);
  for (Eigen::Index i = 0; i < Count(this->Border); ++i)
  {
    solution.row(this->Border[static_cast<std::size_t>(i)]) = border.row(i);
  }
  ForBothHalves(solution.size() >= MinimumValuesForTwoThreads,
    [&](std::size_t h)
    {
      const Half& half = this->Halves[h];
      if (half.unknowns.empty())
      {
        return;
      }
      Eigen::MatrixXd next(Count(half.border), columns);
      for (Eigen::Index i = 0; i < Count(half.border); ++i)
      {
        next.row(i) = border.row(half.border[static_cast<std::size_t>(i)]);
      }
      Eigen::MatrixXd load(Count(half.unknowns) + Count(half.border), columns);
      load << eliminated.halves[h], half.borderFactor.transpose() * next;
      const Eigen::MatrixXd solved = half.factor->SolveUpper(load);
      for (Eigen::Index i = 0; i < Count(half.unknowns); ++i)
      {
        solution.row(half.unknowns[static_cast<std::size_t>(i)]) = solved.row(i);
      }
    });
  if (!solution.allFinite())
  {
    throw Error("The solution of the linear system is not finite; the mesh has degenerate "
                "triangles, remesh the domain.");
  }
  return solution;
}
}
