#pragma once

#include "DirectPerforatedSolve.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
/// Returns a problem with holes of random degrees ±1 .. ±3 and a random positive definite matrix.
/// `noise` measures by how much the harmonic values violate the constraints.
inline ReducedProblem RandomProblem(Random& random, int holeCount, double noise)
{
  ReducedProblem problem;
  int size = 0;
  std::vector<Complex> harmonic;
  for (int h = 0; h < holeCount; ++h)
  {
    const int m = random.Integer(12, 24);
    DegreeConstraint constraint;
    constraint.degree = random.Integer(1, 3) * (random.Integer(0, 1) == 0 ? 1 : -1);
    constraint.target = m * std::sin(2.0 * Pi * constraint.degree / m);
    const Complex phase = random.UnitComplex();
    for (int j = 0; j < m; ++j)
    {
      constraint.unknowns.push_back(size++);
      harmonic.push_back(
        phase * std::polar(1.0, 2.0 * Pi * constraint.degree * j / m) + noise * random.Square());
    }
    problem.constraints.push_back(constraint);
  }
  const Eigen::MatrixXd root = RandomMatrix(random, size, size);
  problem.matrix = MatrixOn(problem.constraints,
    root * root.transpose() / size + 0.5 * Eigen::MatrixXd::Identity(size, size));
  problem.load = problem.matrix * ComplexVector(Eigen::Map<ComplexVector>(harmonic.data(), size));
  return problem;
}

/// Returns ½ xᴴ S x − Re bᴴ x.
inline double Objective(const ReducedProblem& problem, const ComplexVector& x)
{
  return 0.5 * x.dot(problem.matrix * x).real() - problem.load.dot(x).real();
}
}
