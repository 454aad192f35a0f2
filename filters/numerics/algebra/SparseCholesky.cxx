#include "SparseCholesky.h"

#include "CholmodWorkspace.h"
#include "FactorisationCount.h"
#include "SerialBlas.h"
#include "SerialRegions.h"

#include <algorithm>

namespace crossfield
{
struct SparseCholesky::Factor
{
  CholmodWorkspace workspace;
  CholmodFactor factor;
};

SparseCholesky::SparseCholesky(const std::vector<int>& order)
  : Data(std::make_unique<Factor>())
  , Order(order)
{
}

SparseCholesky::SparseCholesky(
  const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order)
  : SparseCholesky(order)
{
  this->FactorFirst(matrix);
}

void SparseCholesky::FactorFirst(const Eigen::SparseMatrix<double>& matrix)
{
  if (matrix.rows() != matrix.cols() ||
    this->Order.size() != static_cast<std::size_t>(matrix.rows()) || !matrix.isCompressed())
  {
    throw Error("A factorisation needs a square compressed matrix and an order of all unknowns.");
  }
  RequireFinite(matrix);
  CountFactorisation();
  this->Data->factor = FactorInOrder(matrix, this->Data->workspace, &this->Order);
  this->RequirePositivePivots();
}

void SparseCholesky::Refactor(const Eigen::SparseMatrix<double>& matrix)
{
  const int* const starts = matrix.outerIndexPtr();
  const int* const rows = matrix.innerIndexPtr();
  const bool isKnown = this->Data->factor != nullptr &&
    std::equal(this->Starts.begin(), this->Starts.end(), starts, starts + matrix.cols() + 1) &&
    std::equal(this->Rows.begin(), this->Rows.end(), rows, rows + matrix.nonZeros());
  if (!isKnown)
  {
    this->Data->factor.reset(); // after an error there is none for other places
    this->Starts.assign(starts, starts + matrix.cols() + 1);
    this->Rows.assign(rows, rows + matrix.nonZeros());
    this->FactorFirst(matrix);
    return;
  }
  RequireFinite(matrix);
  CountFactorisation();
  FactorAgain(matrix, this->Data->workspace, *this->Data->factor);
  this->RequirePositivePivots();
}

void SparseCholesky::RequirePositivePivots() const
{
  if (this->Data->factor->minor < this->Order.size())
  {
    throw NotPositiveDefinite();
  }
}

SparseCholesky::~SparseCholesky() = default;

Eigen::MatrixXd SparseCholesky::Solve(const Eigen::MatrixXd& rightHandSides) const
{
  const SerialBlas serial;
  const SerialRegions regions;
  cholmod_dense view = {};
  view.nrow = static_cast<std::size_t>(rightHandSides.rows());
  view.ncol = static_cast<std::size_t>(rightHandSides.cols());
  view.nzmax = view.nrow * view.ncol;
  view.d = view.nrow;
  view.x = const_cast<double*>(rightHandSides.data());
  view.xtype = CHOLMOD_REAL;
  view.dtype = CHOLMOD_DOUBLE;
  CholmodWorkspace workspace;
  cholmod_dense* solution =
    cholmod_solve(CHOLMOD_A, this->Data->factor.get(), &view, workspace.Get());
  if (solution == nullptr)
  {
    throw Error("There is not enough memory to solve the linear system; use a larger mesh size.");
  }
  Eigen::MatrixXd result = Eigen::Map<Eigen::MatrixXd>(
    static_cast<double*>(solution->x), rightHandSides.rows(), rightHandSides.cols());
  cholmod_free_dense(&solution, workspace.Get());
  if (!result.allFinite())
  {
    throw Error("The solution of the linear system is not finite; the mesh has degenerate "
                "triangles, remesh the domain.");
  }
  return result;
}

Eigen::MatrixXd SparseCholesky::TrailingFactor(int count) const
{
  const cholmod_factor& factor = *this->Data->factor;
  const auto n = static_cast<int>(factor.n);
  const int begin = n - count;
  Eigen::MatrixXd trailing = Eigen::MatrixXd::Zero(count, count);
  const auto* columnStarts = static_cast<const int*>(factor.super);
  const auto* rowStarts = static_cast<const int*>(factor.pi);
  const auto* valueStarts = static_cast<const int*>(factor.px);
  const auto* rows = static_cast<const int*>(factor.s);
  const auto* values = static_cast<const double*>(factor.x);
  for (std::size_t s = factor.nsuper; s-- > 0 && columnStarts[s + 1] > begin;)
  {
    const int rowCount = rowStarts[s + 1] - rowStarts[s];
    for (int column = std::max(columnStarts[s], begin); column < columnStarts[s + 1]; ++column)
    {
      const int local = column - columnStarts[s];
      // The rows of a supernode start with its own columns; entries above the diagonal are
      // undefined.
      for (int k = local; k < rowCount; ++k)
      {
        trailing(rows[rowStarts[s] + k] - begin, column - begin) =
          values[static_cast<std::ptrdiff_t>(valueStarts[s]) +
            static_cast<std::ptrdiff_t>(local) * rowCount + k];
      }
    }
  }
  return trailing;
}
}
