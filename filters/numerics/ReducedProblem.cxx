#include "ReducedProblem.h"

#include "DenseCholesky.h"
#include "SerialBlas.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// The reduced problem in some orthonormal basis of the values x on the holes.
struct DualProblem
{
  Eigen::MatrixXcd matrix;                              ///< S in this basis, lower half.
  ComplexVector load;                                   ///< b in this basis.
  std::vector<Eigen::SparseMatrix<Complex>> constraints; ///< A_i in this basis.
  Eigen::VectorXd targets;
  Eigen::VectorXd sizes; ///< Number of edges of every hole.
};

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

/// In the values themselves.
DualProblem InValues(const ReducedProblem& problem)
{
  DualProblem dual = WithTargets(problem);
  dual.matrix = problem.matrix.cast<Complex>();
  dual.load = problem.load;
  for (const DegreeConstraint& constraint : problem.constraints)
  {
    dual.constraints.push_back(constraint.Hessian(problem.matrix.rows()));
  }
  return dual;
}

/// In the discrete Fourier modes |q| ≤ |d| + extra of every hole, x_j = Σ_q a_q e^{2πi q j/m} / √m over
/// its m edges: A_i is diagonal there, with entries 2 sin(2πq/m).
DualProblem InModes(const ReducedProblem& problem, int extra)
{
  std::vector<Eigen::Triplet<Complex>> waves;
  std::vector<std::vector<Eigen::Triplet<Complex>>> diagonals;
  int count = 0;
  for (const DegreeConstraint& constraint : problem.constraints)
  {
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
      ++count;
    }
  }
  Eigen::SparseMatrix<Complex> modes(problem.matrix.rows(), count);
  modes.setFromTriplets(waves.begin(), waves.end());
  DualProblem dual = WithTargets(problem);
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

/// The dual function and what Newton's method needs of it at one λ.
struct DualPoint
{
  bool positiveDefinite = false;
  Eigen::VectorXd multipliers;
  ComplexVector x;
  Eigen::MatrixXcd normals; ///< Column i is A_i x.
  double value = 0.0;
  Eigen::VectorXd gradient; ///< C_i(x) − t_i.
  double residual = std::numeric_limits<double>::infinity(); ///< Of all optimality conditions.
  DenseCholesky<Complex> factor;
};

DualPoint Evaluate(const DualProblem& problem, Eigen::VectorXd at)
{
  DualPoint point;
  point.multipliers = std::move(at);
  Eigen::MatrixXcd hessian = problem.matrix;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    hessian += point.multipliers[static_cast<Eigen::Index>(i)] * problem.constraints[i];
  }
  point.factor = DenseCholesky<Complex>(hessian);
  point.positiveDefinite = point.factor.IsPositiveDefinite();
  if (!point.positiveDefinite)
  {
    return point;
  }
  point.x = point.factor.Solve(problem.load);
  point.normals.resize(point.x.size(), point.multipliers.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    point.normals.col(static_cast<Eigen::Index>(i)) = problem.constraints[i] * point.x;
  }
  point.gradient = 0.5 * (point.normals.adjoint() * point.x).real() - problem.targets;
  point.value =
    -0.5 * problem.load.dot(point.x).real() - point.multipliers.dot(problem.targets);
  // C is a sum of terms of size one over the edges.
  const double violation = point.gradient.cwiseAbs().cwiseQuotient(problem.sizes).maxCoeff();
  const ComplexVector elastic = hessian.selfadjointView<Eigen::Lower>() * point.x;
  const double scale = elastic.norm() + problem.load.norm();
  point.residual =
    std::max(violation, scale > 0.0 ? (elastic - problem.load).norm() / scale : 0.0);
  return point;
}

/// δλ with ∇²q δλ = −∇q.
Eigen::VectorXd NewtonStep(const DualPoint& point)
{
  const Eigen::MatrixXcd lower =
    point.factor.GetLower().triangularView<Eigen::Lower>().solve(point.normals);
  const Eigen::MatrixXd curvature = (lower.adjoint() * lower).real();
  return curvature.ldlt().solve(point.gradient);
}

/// Newton's method from given multipliers; counts its steps.
DualPoint Maximise(const DualProblem& problem, DualPoint point, const ReducedOptions& options,
  const Progress& progress, int& iterations)
{
  bool stalled = !point.positiveDefinite;
  while (!stalled && point.residual > options.tolerance && iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(iterations) / options.maximumIterations);
    const Eigen::VectorXd step = NewtonStep(point);
    const double slope = point.gradient.dot(step);
    stalled = true;
    // 40 halvings span the range of a double's mantissa that a step can still be told apart in.
    double length = 1.0;
    for (int halving = 0; stalled && halving < 40; ++halving, length *= 0.5)
    {
      DualPoint trial = Evaluate(problem, point.multipliers + length * step);
      // Close to the maximum q no longer resolves the progress that its gradient still shows.
      stalled = !(trial.positiveDefinite &&
        (trial.value >= point.value + 1e-4 * length * slope ||
          trial.gradient.norm() <= 0.5 * point.gradient.norm()));
      if (!stalled)
      {
        point = std::move(trial);
      }
    }
    ++iterations;
  }
  return point;
}
}

ComplexVector ReducedSolution::Forces(const ReducedProblem& problem) const
{
  ComplexVector forces = ComplexVector::Zero(this->x.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    forces -=
      this->multipliers[static_cast<Eigen::Index>(i)] * problem.constraints[i].Gradient(this->x);
  }
  return forces;
}

ReducedSolution SolveReduced(
  const ReducedProblem& problem, const ReducedOptions& options, const Progress& progress)
{
  ReducedSolution solution;
  if (problem.constraints.empty())
  {
    solution.converged = true;
    return solution;
  }
  const SerialBlas serial; // once, not for every small factorisation
  const Eigen::VectorXd zero =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.constraints.size()));

  // 1. In the few modes that carry most of the field, where a step costs next to nothing.
  constexpr int LowModes = 4;
  ReducedOptions rough = options;
  rough.tolerance = std::max(options.tolerance, 1e-6); // what the missing modes change is larger
  const DualProblem low = InModes(problem, LowModes);
  const DualPoint start =
    Maximise(low, Evaluate(low, zero), rough, progress.Part(0.0, 0.5), solution.iterations);

  // 2. In all values from there, or from the harmonic field if the multipliers are out of reach.
  const DualProblem full = InValues(problem);
  DualPoint point = Evaluate(full, start.multipliers);
  if (!point.positiveDefinite)
  {
    point = Evaluate(full, zero);
  }
  point = Maximise(full, std::move(point), options, progress.Part(0.5, 1.0), solution.iterations);

  solution.x = point.x;
  solution.multipliers = point.multipliers;
  solution.residual = point.residual;
  solution.converged = point.positiveDefinite && point.residual <= options.tolerance;
  return solution;
}
}
