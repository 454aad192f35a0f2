#include "DualProblem.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the entries of a vector with the given indices.
ComplexVector PartOf(const ComplexVector& vector, const std::vector<int>& numbers)
{
  ComplexVector part(static_cast<Eigen::Index>(numbers.size()));
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    part[static_cast<Eigen::Index>(i)] = vector[numbers[i]];
  }
  return part;
}

}

DualProblem::Margin DualProblem::MarginOfLeftOut() const
{
  // Let E be the matrix of the couplings left out, d_i the uncoupled part of x on hole i, and R_i
  // the rows of hole i of E. Then xᵀEx is at most √5 Σ ‖d_i‖ ‖R_i‖ ‖x‖ ≤ τ Σ ‖d_i‖² + 5/(4τ) Σ
  // ‖R_i‖² ‖x‖² for any τ, and leftOut² is 2 Σ ‖R_i‖². The uncoupled part is stiff, and rotating an
  // entire hole is soft. So τ, the margin on the uncoupled part only, is larger than the margin on
  // all members; both decrease with leftOut.
  const double unit = this->matrix.Trace() / static_cast<double>(this->matrix.Rows());
  const double stiff = std::max(this->leftOut, 0.05 * std::sqrt(this->leftOut * unit));
  const double all = stiff > 0.0 ? 0.625 * this->leftOut * this->leftOut / stiff : 0.0;
  return { stiff + all, all };
}

ComplexVector DualProblem::Elastic(const ComplexVector& x) const
{
  return this->refinedWith != nullptr ? this->InBases(this->refinedWith->matrix * this->InValues(x))
                                      : ComplexVector(this->matrix * x);
}

ComplexVector DualProblem::InBases(const ComplexVector& x) const
{
  ComplexVector result(x.size());
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < this->bases.size(); ++i)
  {
    const Eigen::Index size = this->bases[i].rows();
    result.segment(row, size) = this->bases[i].transpose() * PartOf(x, this->unknowns[i]);
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
      result[this->unknowns[i][j]] = part[j];
    }
    row += size;
  }
  return result;
}
}
