#include "DualProblem.h"

namespace crossfield
{
namespace
{
/// The entries of a vector with these numbers.
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
      result[this->unknowns[i][static_cast<std::size_t>(j)]] = part[j];
    }
    row += size;
  }
  return result;
}
}
