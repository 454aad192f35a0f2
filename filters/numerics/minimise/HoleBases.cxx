#include "HoleBases.h"

#include "DenseProduct.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>

namespace crossfield
{
namespace
{
/// More random columns than a hole has values: their span is then that of all couplings but for improbable accidents,
/// which would cost couplings, not correctness: what is left out is measured.
constexpr Eigen::Index MoreColumns = 8;

/// The rows of a matrix with these numbers.
Eigen::MatrixXd RowsOf(const Eigen::MatrixXd& matrix, const std::vector<int>& rows)
{
  Eigen::MatrixXd part(static_cast<Eigen::Index>(rows.size()), matrix.cols());
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      part(static_cast<Eigen::Index>(i), column) = matrix(rows[i], column);
    }
  }
  return part;
}

/// The columns of a matrix with these numbers.
Eigen::MatrixXd ColumnsOf(const Eigen::MatrixXd& matrix, const std::vector<int>& columns)
{
  Eigen::MatrixXd part(matrix.rows(), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t j = 0; j < columns.size(); ++j)
  {
    part.col(static_cast<Eigen::Index>(j)) = matrix.col(columns[j]);
  }
  return part;
}

/// Numbers between −1 and 1, the same ones each time.
Eigen::MatrixXd RandomColumns(Eigen::Index rows, Eigen::Index columns)
{
  std::mt19937 generator(1);
  const double scale = 2.0 / static_cast<double>(std::mt19937::max());
  return Eigen::MatrixXd::NullaryExpr(
    rows, columns, [&] { return scale * static_cast<double>(generator()) - 1.0; });
}

/// A_i in the values of its hole, in their order.
Eigen::MatrixXcd HessianOf(DegreeConstraint constraint)
{
  std::iota(constraint.unknowns.begin(), constraint.unknowns.end(), 0);
  return constraint.Hessian(static_cast<Eigen::Index>(constraint.unknowns.size()));
}
}

HoleBases::HoleBases(const ReducedProblem& problem)
  : MeanDiagonal(problem.matrix.trace() / static_cast<double>(problem.matrix.rows()))
{
  const auto holes = static_cast<Eigen::Index>(problem.constraints.size());
  DualProblem& dual = this->Complete;
  dual.targets.resize(holes);
  dual.sizes.resize(holes);
  Eigen::Index largest = 0;
  for (Eigen::Index i = 0; i < holes; ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[static_cast<std::size_t>(i)];
    const auto size = static_cast<Eigen::Index>(constraint.unknowns.size());
    dual.targets[i] = constraint.target;
    dual.sizes[i] = static_cast<double>(size);
    dual.unknowns.push_back(constraint.unknowns);
    largest = std::max(largest, size);
  }

  // 1. The bases: a QR decomposition with pivots, in which what is left falls as fast as the singular values but for a
  //    small factor. Not of what couples a hole to all others, but of its products with a few random columns.
  const Eigen::Index rows = problem.matrix.rows();
  const Eigen::MatrixXd random = RandomColumns(rows, std::min(rows, largest + MoreColumns));
  const Eigen::MatrixXd product = DenseProduct(problem.matrix, random);
  this->Couplings.resize(rows, rows);
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < dual.unknowns.size(); ++i)
  {
    const std::vector<int>& unknowns = dual.unknowns[i];
    const Eigen::MatrixXd columns = ColumnsOf(problem.matrix, unknowns);
    const Eigen::MatrixXd own = RowsOf(columns, unknowns);
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(
      RowsOf(product, unknowns) - own * RowsOf(random, unknowns));
    const Eigen::MatrixXd strongestFirst = decomposition.householderQ();
    const Eigen::MatrixXd basis = strongestFirst.rowwise().reverse();
    dual.matrix.blocks.push_back(basis.transpose() * own * basis);
    dual.constraints.push_back(basis.transpose() * HessianOf(problem.constraints[i]) * basis);
    dual.bases.push_back(basis);
    this->Rows.push_back(row);
    this->Couplings.middleCols(row, basis.cols()) = DenseProduct(columns, basis);
    row += basis.cols();
  }

  // 2. S in them.
  const Eigen::MatrixXd half = std::move(this->Couplings);
  this->Couplings.resize(rows, rows);
  for (std::size_t i = 0; i < dual.unknowns.size(); ++i)
  {
    const Eigen::Index size = dual.bases[i].cols();
    this->Couplings.middleRows(this->Rows[i], size) =
      AdjointProduct(dual.bases[i], RowsOf(half, dual.unknowns[i]));
    this->Couplings.block(this->Rows[i], this->Rows[i], size, size).setZero();
  }
  dual.load = dual.InBases(problem.load);
}

DualProblem HoleBases::InBlocks(double tolerance) const
{
  DualProblem dual = this->Complete;
  double leftOut = 0.0;
  std::vector<Eigen::Index> kept;
  for (std::size_t i = 0; i < dual.bases.size(); ++i)
  {
    const Eigen::Index size = dual.bases[i].cols();
    Eigen::Index without = 0;
    double left = 0.0; // Frobenius norm of the couplings of so many
    for (; without < size; ++without)
    {
      // S is symmetric, and its columns are together in memory.
      const double more = std::hypot(left, this->Couplings.col(this->Rows[i] + without).norm());
      if (more > tolerance * this->MeanDiagonal)
      {
        break;
      }
      left = more;
    }
    leftOut += 2.0 * left * left;
    dual.matrix.coupled.push_back(size - without);
    for (Eigen::Index j = without; j < size; ++j)
    {
      kept.push_back(this->Rows[i] + j);
    }
  }
  dual.leftOut = std::sqrt(leftOut);
  const auto count = static_cast<Eigen::Index>(kept.size());
  dual.matrix.coupling.resize(count, count);
  for (Eigen::Index j = 0; j < count; ++j)
  {
    for (Eigen::Index i = 0; i < count; ++i)
    {
      dual.matrix.coupling(i, j) =
        this->Couplings(kept[static_cast<std::size_t>(i)], kept[static_cast<std::size_t>(j)]);
    }
  }
  return dual;
}
}
