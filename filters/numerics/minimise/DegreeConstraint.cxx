#include "DegreeConstraint.h"

#include "Error.h"

#include <cmath>
#include <cstdlib>
#include <string>

namespace crossfield
{
double DegreeConstraint::Value(const ComplexVector& u) const
{
  double sum = 0.0;
  for (std::size_t j = 0; j < this->unknowns.size(); ++j)
  {
    const Complex here = u[this->unknowns[j]];
    const Complex next = u[this->unknowns[(j + 1) % this->unknowns.size()]];
    sum += (std::conj(here) * next).imag();
  }
  return sum;
}

ComplexVector DegreeConstraint::Gradient(const ComplexVector& u) const
{
  const Complex i(0.0, 1.0);
  const std::size_t m = this->unknowns.size();
  ComplexVector gradient = ComplexVector::Zero(u.size());
  for (std::size_t j = 0; j < m; ++j)
  {
    gradient[this->unknowns[j]] =
      i * (u[this->unknowns[(j + m - 1) % m]] - u[this->unknowns[(j + 1) % m]]);
  }
  return gradient;
}

Eigen::SparseMatrix<Complex> DegreeConstraint::Hessian(Eigen::Index size) const
{
  const Complex i(0.0, 1.0);
  std::vector<Eigen::Triplet<Complex>> entries;
  for (std::size_t j = 0; j < this->unknowns.size(); ++j)
  {
    const int here = this->unknowns[j];
    const int next = this->unknowns[(j + 1) % this->unknowns.size()];
    entries.emplace_back(here, next, -i);
    entries.emplace_back(next, here, i);
  }
  Eigen::SparseMatrix<Complex> matrix(size, size);
  matrix.setFromTriplets(entries.begin(), entries.end());
  return matrix;
}

DegreeConstraint MakeDegreeConstraint(
  std::vector<int> unknowns, const std::vector<Point>& midpoints, const Point& centre, int degree)
{
  DegreeConstraint constraint{ std::move(unknowns), degree, DegreeTarget(midpoints, centre, degree),
    {} };
  for (const Point& midpoint : midpoints)
  {
    const Point arm = midpoint - centre;
    constraint.turning.push_back(std::polar(1.0, degree * std::atan2(arm.y(), arm.x())));
  }
  return constraint;
}

double DegreeTarget(const std::vector<Point>& midpoints, const Point& centre, int degree)
{
  const auto m = static_cast<int>(midpoints.size());
  if (2 * std::abs(degree) >= m)
  {
    throw Error("A hole with " + std::to_string(m) + " edges cannot carry quarter index " +
      std::to_string(degree) + "; it needs at least " + std::to_string(2 * std::abs(degree) + 1) +
      " edges.");
  }
  double target = 0.0;
  for (std::size_t j = 0; j < midpoints.size(); ++j)
  {
    const Point here = midpoints[j] - centre;
    const Point next = midpoints[(j + 1) % midpoints.size()] - centre;
    target += std::sin(degree * AngleBetween(here, next));
  }
  return target;
}
}
