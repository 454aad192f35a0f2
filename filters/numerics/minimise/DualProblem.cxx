#include "DualProblem.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// The rows of a matrix with these numbers.
template <typename Matrix>
Matrix RowsOf(const Matrix& matrix, const std::vector<int>& rows)
{
  Matrix part(static_cast<Eigen::Index>(rows.size()), matrix.cols());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    part.row(static_cast<Eigen::Index>(i)) = matrix.row(rows[i]);
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

/// An orthonormal basis of the values on a hole, those members last that are coupled to others.
struct HoleBasis
{
  Eigen::MatrixXd members;
  Eigen::Index coupled = 0;
  double leftOut = 0.0; ///< Frobenius norm.
};

/// By a QR decomposition of the coupling with pivots, in which what is left falls as fast as the singular values but
/// for a small factor.
HoleBasis BasisFor(Eigen::MatrixXd coupling, double tolerance)
{
  const Eigen::Index size = coupling.rows();
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> decomposition(std::move(coupling));
  HoleBasis basis;
  // What is left after so many members.
  const Eigen::MatrixXd& upper = decomposition.matrixR();
  double left = 0.0;
  Eigen::Index kept = std::min(size, upper.cols());
  while (kept > 0)
  {
    const double more = std::hypot(left, upper.row(kept - 1).tail(upper.cols() - kept + 1).norm());
    if (more > tolerance)
    {
      break;
    }
    left = more;
    --kept;
  }
  const Eigen::MatrixXd members = decomposition.householderQ();
  basis.members.resize(size, size);
  basis.members << members.rightCols(size - kept), members.leftCols(kept);
  basis.coupled = kept;
  basis.leftOut = left;
  return basis;
}
}

ComplexVector TimesMatrix(const ReducedProblem& problem, const ComplexVector& x)
{
  // Two products with a vector read S as it is; one with both parts copies it.
  ComplexVector result(x.size());
  result.real() = problem.matrix * Eigen::VectorXd(x.real());
  result.imag() = problem.matrix * Eigen::VectorXd(x.imag());
  return result;
}

ComplexVector DualProblem::Elastic(const ComplexVector& x) const
{
  return this->refinedWith != nullptr
    ? this->InBases(TimesMatrix(*this->refinedWith, this->InValues(x)))
    : ComplexVector(this->matrix * x);
}

ComplexVector DualProblem::InBases(const ComplexVector& x) const
{
  ComplexVector result(x.size());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < this->bases.size(); ++i)
  {
    const Eigen::Index size = this->bases[i].rows();
    result.segment(row, size) = this->bases[i].transpose() * RowsOf(x, this->unknowns[i]);
    row += size;
  }
  return result;
}

ComplexVector DualProblem::InValues(const ComplexVector& x) const
{
  ComplexVector result(x.size());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < this->bases.size(); ++i)
  {
    const Eigen::Index size = this->bases[i].rows();
    const ComplexVector part = this->bases[i] * x.segment(row, size);
    for (Eigen::Index j = 0; j < size; ++j)
    {
      result[this->unknowns[i][static_cast<std::size_t>(j)]] = part[j];
    }
    row += size;
  }
  return result;
}

DualProblem InBlocks(const ReducedProblem& problem, double tolerance)
{
  const auto holes = static_cast<Eigen::Index>(problem.constraints.size());
  const double unit = problem.matrix.trace() / static_cast<double>(problem.matrix.rows());
  DualProblem dual;
  dual.targets.resize(holes);
  dual.sizes.resize(holes);
  std::vector<Eigen::MatrixXd> coupledMembers;
  double leftOut = 0.0;
  for (Eigen::Index i = 0; i < holes; ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[static_cast<std::size_t>(i)];
    const auto size = static_cast<Eigen::Index>(constraint.unknowns.size());
    dual.targets[i] = constraint.target;
    dual.sizes[i] = static_cast<double>(size);
    dual.unknowns.push_back(constraint.unknowns);

    // S is symmetric, and its columns are together in memory.
    Eigen::MatrixXd coupling = ColumnsOf(problem.matrix, constraint.unknowns).transpose();
    const Eigen::MatrixXd own = ColumnsOf(coupling, constraint.unknowns);
    for (const int unknown : constraint.unknowns)
    {
      coupling.col(unknown).setZero();
    }
    HoleBasis basis = BasisFor(std::move(coupling), tolerance * unit);
    leftOut += 2.0 * basis.leftOut * basis.leftOut;
    dual.matrix.blocks.push_back(basis.members.transpose() * own * basis.members);
    dual.matrix.coupled.push_back(basis.coupled);
    coupledMembers.push_back(basis.members.rightCols(basis.coupled));

    std::vector<int> positions(constraint.unknowns.size());
    for (std::size_t j = 0; j < positions.size(); ++j)
    {
      positions[j] = static_cast<int>(j);
    }
    DegreeConstraint alone = constraint;
    alone.unknowns = positions;
    const Eigen::MatrixXcd hessian = alone.Hessian(size);
    dual.constraints.push_back(basis.members.transpose() * hessian * basis.members);
    dual.bases.push_back(std::move(basis.members));
  }
  dual.leftOut = std::sqrt(leftOut);

  Eigen::Index count = 0;
  for (const Eigen::Index coupled : dual.matrix.coupled)
  {
    count += coupled;
  }
  dual.matrix.coupling = Eigen::MatrixXd::Zero(count, count);
  Eigen::Index column = 0;
  for (std::size_t j = 0; j < coupledMembers.size(); ++j)
  {
    const Eigen::MatrixXd product = ColumnsOf(problem.matrix, dual.unknowns[j]) * coupledMembers[j];
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < coupledMembers.size(); ++i)
    {
      if (i != j)
      {
        dual.matrix.coupling.block(row, column, coupledMembers[i].cols(), product.cols()) =
          coupledMembers[i].transpose() * RowsOf(product, dual.unknowns[i]);
      }
      row += coupledMembers[i].cols();
    }
    column += coupledMembers[j].cols();
  }
  dual.load = dual.InBases(problem.load);
  return dual;
}
}
