#include "QuadraticConstraint.h"

#include <algorithm>

namespace crossfield
{
double QuadraticConstraint::Value(const ComplexVector& x) const
{
  double sum = 0.0;
  for (const Entry& entry : this->entries)
  {
    sum += 0.5 * (std::conj(x[entry.row]) * entry.value * x[entry.column]).real();
  }
  return sum;
}

Eigen::VectorXd QuadraticConstraint::Gradient(const ComplexVector& x) const
{
  Eigen::VectorXd gradient = Eigen::VectorXd::Zero(2 * x.size());
  std::vector<Eigen::Triplet<double>> parts;
  this->AddGradient(x, 0, parts);
  for (const Eigen::Triplet<double>& part : parts)
  {
    gradient[part.row()] += part.value();
  }
  return gradient;
}

void QuadraticConstraint::AddGradient(
  const ComplexVector& x, int column, std::vector<Eigen::Triplet<double>>& entriesOfMatrix) const
{
  for (const Entry& entry : this->entries)
  {
    const Complex product = entry.value * x[entry.column];
    entriesOfMatrix.emplace_back(2 * entry.row, column, product.real());
    entriesOfMatrix.emplace_back(2 * entry.row + 1, column, product.imag());
  }
}

QuadraticConstraint SumOfDegrees(const std::vector<DegreeConstraint>& constraints)
{
  QuadraticConstraint sum;
  sum.size = 0.0;
  for (const DegreeConstraint& constraint : constraints)
  {
    const int last = *std::max_element(constraint.unknowns.begin(), constraint.unknowns.end());
    const Eigen::SparseMatrix<Complex> hessian = constraint.Hessian(last + 1);
    for (const int column : constraint.unknowns)
    {
      for (Eigen::SparseMatrix<Complex>::InnerIterator entry(hessian, column); entry; ++entry)
      {
        sum.entries.push_back({ static_cast<int>(entry.row()), column, entry.value() });
      }
    }
    sum.target += constraint.target;
    sum.size += static_cast<double>(constraint.unknowns.size());
  }
  return sum;
}

QuadraticConstraint UnitNorm(int unknown)
{
  return { { { unknown, unknown, 2.0 } }, 1.0, 1.0 };
}
}
