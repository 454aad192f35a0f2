#include "DualProblem.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
DualProblem WithTargets(const ReducedProblem& problem)
{
  const auto holes = static_cast<Eigen::Index>(problem.constraints.size());
  DualProblem dual;
  dual.targets.resize(holes);
  dual.sizes.resize(holes);
  for (Eigen::Index i = 0; i < holes; ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[static_cast<std::size_t>(i)];
    dual.targets[i] = constraint.target;
    dual.sizes[i] = static_cast<double>(constraint.unknowns.size());
  }
  return dual;
}
}

DualProblem InValues(const ReducedProblem& problem)
{
  DualProblem dual = WithTargets(problem);
  dual.matrix = problem.matrix.cast<Complex>();
  dual.load = problem.load;
  dual.holeOf.resize(static_cast<std::size_t>(problem.matrix.rows()));
  for (const DegreeConstraint& constraint : problem.constraints)
  {
    for (int unknown : constraint.unknowns)
    {
      dual.holeOf[static_cast<std::size_t>(unknown)] =
        static_cast<Eigen::Index>(dual.constraints.size());
    }
    dual.constraints.push_back(constraint.Hessian(problem.matrix.rows()));
  }
  return dual;
}

DualProblem InModes(const ReducedProblem& problem, int extra)
{
  DualProblem dual = WithTargets(problem);
  std::vector<Eigen::Triplet<Complex>> waves;
  std::vector<std::vector<Eigen::Triplet<Complex>>> diagonals;
  int count = 0;
  for (const DegreeConstraint& constraint : problem.constraints)
  {
    const auto hole = static_cast<Eigen::Index>(diagonals.size());
    diagonals.emplace_back();
    const auto m = static_cast<int>(constraint.unknowns.size());
    const int highest = std::abs(constraint.degree) + std::min(extra, m);
    for (int q = std::max(-highest, -(m - 1) / 2); q <= std::min(highest, m / 2); ++q)
    {
      for (int j = 0; j < m; ++j)
      {
        // The remainder keeps the argument small, and the mode exactly periodic.
        const double angle = 2.0 * Pi * ((q * j) % m) / m;
        waves.emplace_back(constraint.unknowns[static_cast<std::size_t>(j)], count,
          std::polar(1.0 / std::sqrt(m), angle));
      }
      diagonals.back().emplace_back(count, count, 2.0 * std::sin(2.0 * Pi * q / m));
      dual.holeOf.push_back(hole);
      ++count;
    }
  }
  Eigen::SparseMatrix<Complex> modes(problem.matrix.rows(), count);
  modes.setFromTriplets(waves.begin(), waves.end());
  // S is real: two real products instead of a complex one.
  Eigen::MatrixXcd product(problem.matrix.rows(), count);
  product.real() = problem.matrix * Eigen::SparseMatrix<double>(modes.real());
  product.imag() = problem.matrix * Eigen::SparseMatrix<double>(modes.imag());
  dual.matrix = modes.adjoint() * product;
  dual.load = modes.adjoint() * problem.load;
  for (const auto& diagonal : diagonals)
  {
    dual.constraints.emplace_back(count, count);
    dual.constraints.back().setFromTriplets(diagonal.begin(), diagonal.end());
  }
  return dual;
}
}
