#include "ReducedLocal.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// A complex vector as a real one, real parts first.
Eigen::VectorXd Real(const ComplexVector& x)
{
  Eigen::VectorXd real(2 * x.size());
  real << x.real(), x.imag();
  return real;
}

ComplexVector Complexified(const Eigen::VectorXd& real)
{
  const Eigen::Index size = real.size() / 2;
  ComplexVector x(size);
  x.real() = real.head(size);
  x.imag() = real.tail(size);
  return x;
}

Eigen::MatrixXd Real(const Eigen::MatrixXcd& hermitian)
{
  const Eigen::Index size = hermitian.rows();
  Eigen::MatrixXd real(2 * size, 2 * size);
  real << hermitian.real(), -hermitian.imag(), hermitian.imag(), hermitian.real();
  return real;
}

/// Values and derivatives of objective and constraints at a point.
struct LocalPoint
{
  ComplexVector x;
  Eigen::VectorXd elastic;    ///< S x − b.
  Eigen::MatrixXd normals;    ///< Column i is A_i x.
  Eigen::VectorXd violations; ///< c_i.
  double objective = 0.0;     ///< ½ xᴴ S x − Re(bᴴ x).

  LocalPoint(const ReducedProblem& problem, ComplexVector at)
    : x(std::move(at))
  {
    const ComplexVector product = problem.matrix * this->x;
    this->elastic = Real(ComplexVector(product - problem.load));
    this->objective = 0.5 * this->x.dot(product).real() - problem.load.dot(this->x).real();
    const auto count = static_cast<Eigen::Index>(problem.constraints.size());
    this->normals.resize(2 * this->x.size(), count);
    this->violations.resize(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const DegreeConstraint& constraint = problem.constraints[static_cast<std::size_t>(i)];
      this->normals.col(i) = Real(constraint.Gradient(this->x));
      this->violations[i] = constraint.Value(this->x) - constraint.target;
    }
  }

  /// `weight` above every |λ_i| makes a solution of the problem a minimum of this.
  double Merit(double weight) const
  {
    return this->objective + weight * this->violations.lpNorm<1>();
  }
};

Eigen::MatrixXd LagrangianHessian(const ReducedProblem& problem, const Eigen::VectorXd& multipliers)
{
  Eigen::MatrixXcd hessian = problem.matrix.cast<Complex>();
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    hessian += multipliers[static_cast<Eigen::Index>(i)] *
      problem.constraints[i].Hessian(problem.matrix.rows());
  }
  return Real(hessian);
}

/// Weighting the normals this heavily, relative to S, leaves the sign of a quadratic form on their
/// complement to decide whether it is positive definite.
constexpr double NormalWeight = 1e4;

/// A step of the convexified quadratic problem, and the multipliers that come with it.
struct QuadraticStep
{
  Eigen::VectorXd x;
  Eigen::VectorXd multipliers;
  bool convexified = false;
};

QuadraticStep SolveQuadratic(
  const ReducedProblem& problem, const LocalPoint& point, const Eigen::VectorXd& multipliers)
{
  const Eigen::MatrixXd hessian = LagrangianHessian(problem, multipliers);
  const double scale = NormalWeight * problem.matrix.trace() / static_cast<double>(problem.matrix.rows());
  const Eigen::MatrixXd weighted = hessian + scale * point.normals * point.normals.transpose();
  const Eigen::MatrixXd elastic = Real(Eigen::MatrixXcd(problem.matrix.cast<Complex>()));
  QuadraticStep step;
  // S + τ S + Σ λ_i A_i is positive definite for some τ, so this ends.
  for (double shift = 0.0;; shift = shift == 0.0 ? 0.125 : 2.0 * shift)
  {
    const Eigen::LLT<Eigen::MatrixXd> factor(weighted + shift * elastic);
    if (factor.info() != Eigen::Success)
    {
      step.convexified = true;
      continue;
    }
    const Eigen::MatrixXd fromNormals = factor.solve(point.normals);
    const Eigen::VectorXd fromGradient = factor.solve(point.elastic);
    const Eigen::VectorXd plain = (point.normals.transpose() * fromNormals)
                                    .ldlt()
                                    .solve(point.violations - point.normals.transpose() * fromGradient);
    step.x = -fromGradient - fromNormals * plain;
    // The weight on the normals shifts the multipliers by weight × Nᵀ δx = −weight × c.
    step.multipliers = plain - scale * point.violations;
    return step;
  }
}

/// λ that makes S x − b + Σ λ_i A_i x smallest.
Eigen::VectorXd LeastSquaresMultipliers(const LocalPoint& point)
{
  return -(point.normals.transpose() * point.normals)
            .ldlt()
            .solve(point.normals.transpose() * point.elastic);
}

/// Relative residual of the optimality conditions, as in SolveReduced.
double Residual(
  const ReducedProblem& problem, const LocalPoint& point, const Eigen::VectorXd& multipliers)
{
  double residual = 0.0;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    residual = std::max(residual,
      std::abs(point.violations[static_cast<Eigen::Index>(i)]) /
        static_cast<double>(problem.constraints[i].unknowns.size()));
  }
  const double scale = (problem.matrix * point.x).norm() + problem.load.norm();
  const Eigen::VectorXd gradient = point.elastic + point.normals * multipliers;
  return std::max(residual, scale > 0.0 ? gradient.norm() / scale : 0.0);
}

/// The shortest step that the linearised constraints ask for.
ComplexVector Restoration(const LocalPoint& point)
{
  return Complexified(Eigen::VectorXd(-point.normals *
    (point.normals.transpose() * point.normals).ldlt().solve(point.violations)));
}
}

ReducedSolution SolveReducedFrom(const ReducedProblem& problem, const ComplexVector& start,
  const ReducedOptions& options, const Progress& progress)
{
  LocalPoint point(problem, start);
  Eigen::VectorXd multipliers = LeastSquaresMultipliers(point);
  ReducedSolution solution;
  double residual = Residual(problem, point, multipliers);
  bool stalled = false;
  bool saddle = true;
  while (!stalled && (saddle || residual > options.tolerance) &&
    solution.iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(solution.iterations) / options.maximumIterations);
    const QuadraticStep step = SolveQuadratic(problem, point, multipliers);
    saddle = step.convexified;
    if (residual <= options.tolerance)
    {
      break; // only asked whether the point is a minimum
    }
    ++solution.iterations;
    const ComplexVector direction = Complexified(step.x);
    const double weight = std::max(1.0, 2.0 * step.multipliers.lpNorm<Eigen::Infinity>());
    const double slope = point.elastic.dot(step.x) - weight * point.violations.lpNorm<1>();
    stalled = true;
    for (double length = 1.0; stalled && length > 1e-10; length *= 0.5)
    {
      LocalPoint trial(problem, point.x + length * direction);
      const double wanted = point.Merit(weight) + 1e-4 * length * slope;
      if (trial.Merit(weight) > wanted)
      {
        // The constraints curve away from their tangents: one step back to them.
        trial = LocalPoint(problem, trial.x + Restoration(trial));
      }
      const Eigen::VectorXd moved = multipliers + length * (step.multipliers - multipliers);
      const double trialResidual = Residual(problem, trial, moved);
      // Near the solution the merit no longer resolves the progress that the residual shows.
      if (trial.Merit(weight) <= wanted || trialResidual <= 0.5 * residual)
      {
        point = std::move(trial);
        multipliers = moved;
        residual = trialResidual;
        stalled = false;
      }
    }
  }
  solution.converged = residual <= options.tolerance && !saddle;
  solution.x = std::move(point.x);
  solution.multipliers = std::move(multipliers);
  solution.residual = residual;
  return solution;
}
}
