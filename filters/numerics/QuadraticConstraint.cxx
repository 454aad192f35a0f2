#include "QuadraticConstraint.h"

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
  for (const Entry& entry : this->entries)
  {
    const Complex product = entry.value * x[entry.column];
    gradient[2 * entry.row] += product.real();
    gradient[2 * entry.row + 1] += product.imag();
  }
  return gradient;
}

QuadraticConstraint SumOfDegrees(const std::vector<DegreeConstraint>& constraints)
{
  QuadraticConstraint sum;
  sum.size = 0.0;
  const Complex i(0.0, 1.0);
  for (const DegreeConstraint& constraint : constraints)
  {
    const std::size_t m = constraint.unknowns.size();
    for (std::size_t j = 0; j < m; ++j)
    {
      const int here = constraint.unknowns[j];
      const int next = constraint.unknowns[(j + 1) % m];
      sum.entries.push_back({ here, next, -i });
      sum.entries.push_back({ next, here, i });
    }
    sum.target += constraint.target;
    sum.size += static_cast<double>(m);
  }
  return sum;
}

QuadraticConstraint UnitNorm(int unknown)
{
  return { { { unknown, unknown, 2.0 } }, 1.0, 1.0 };
}
}
