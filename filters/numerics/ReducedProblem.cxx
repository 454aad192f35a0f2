#include "ReducedProblem.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// The dual function and what Newton's method needs of it at one λ.
struct DualPoint
{
  bool positiveDefinite = false;
  Eigen::VectorXd multipliers;
  ComplexVector x;
  double value = 0.0;
  Eigen::VectorXd gradient; ///< C_i(x) − t_i.
  double residual = 0.0;    ///< Of all optimality conditions, relative.
  Eigen::LLT<Eigen::MatrixXcd> factor;
};

DualPoint Evaluate(const ReducedProblem& problem, Eigen::VectorXd at)
{
  DualPoint point;
  point.multipliers = std::move(at);
  Eigen::MatrixXcd hessian = problem.matrix.cast<Complex>();
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    problem.constraints[i].AddHessian(
      point.multipliers[static_cast<Eigen::Index>(i)], hessian);
  }
  point.factor.compute(hessian);
  point.positiveDefinite = point.factor.info() == Eigen::Success;
  if (!point.positiveDefinite)
  {
    return point;
  }
  point.x = point.factor.solve(problem.load);
  point.value = -0.5 * problem.load.dot(point.x).real();
  point.gradient.resize(point.multipliers.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[i];
    const auto row = static_cast<Eigen::Index>(i);
    point.gradient[row] = constraint.Value(point.x) - constraint.target;
    point.value -= point.multipliers[row] * constraint.target;
    // C is a sum of terms of size one over the edges.
    point.residual = std::max(point.residual,
      std::abs(point.gradient[row]) / static_cast<double>(constraint.unknowns.size()));
  }
  const ComplexVector elastic = hessian * point.x;
  const double scale = elastic.norm() + problem.load.norm();
  if (scale > 0.0)
  {
    point.residual = std::max(point.residual, (elastic - problem.load).norm() / scale);
  }
  return point;
}

/// δλ with ∇²q δλ = −∇q.
Eigen::VectorXd NewtonStep(const ReducedProblem& problem, const DualPoint& point)
{
  Eigen::MatrixXcd normals(point.x.size(), point.gradient.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    normals.col(static_cast<Eigen::Index>(i)) = problem.constraints[i].Gradient(point.x);
  }
  const Eigen::MatrixXd curvature = (normals.adjoint() * point.factor.solve(normals)).real();
  return curvature.ldlt().solve(point.gradient);
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
  DualPoint point = Evaluate(problem,
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.constraints.size())));
  ReducedSolution solution;
  bool stalled = !point.positiveDefinite;
  while (!stalled && point.residual > options.tolerance &&
    solution.iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(solution.iterations) / options.maximumIterations);
    const Eigen::VectorXd step = NewtonStep(problem, point);
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
    ++solution.iterations;
  }
  solution.x = point.x;
  solution.multipliers = point.multipliers;
  solution.residual = point.residual;
  solution.converged = point.positiveDefinite && point.residual <= options.tolerance;
  return solution;
}
}
