#include "UnitSolve.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// The problem ½ aᴴ M a − Re(cᴴ a) that remains for the factors a_i = e^{iφ_i} of the holes.
struct PhaseProblem
{
  Eigen::MatrixXcd matrix;
  ComplexVector load;
};

/// Objective and derivatives at given factors.
struct PhasePoint
{
  ComplexVector factors;
  double objective = 0.0;
  Eigen::VectorXd radial;     ///< Part of the forces M a − c along each a_i.
  Eigen::VectorXd tangential; ///< Part across: derivative of the objective in φ_i.
  double residual = 0.0;

  PhasePoint(const PhaseProblem& problem, ComplexVector at)
    : factors(std::move(at))
  {
    const ComplexVector product = problem.matrix * this->factors;
    this->objective =
      0.5 * this->factors.dot(product).real() - problem.load.dot(this->factors).real();
    const ComplexVector forces = this->factors.conjugate().cwiseProduct(product - problem.load);
    this->radial = forces.real();
    this->tangential = forces.imag();
    const double scale = product.norm() + problem.load.norm();
    this->residual = scale > 0.0 ? this->tangential.norm() / scale : 0.0;
  }
};

/// Column i holds the evenly turning unit values of hole i.
Eigen::MatrixXcd EvenTurning(const ReducedProblem& problem)
{
  Eigen::MatrixXcd turning = Eigen::MatrixXcd::Zero(
    problem.matrix.rows(), static_cast<Eigen::Index>(problem.constraints.size()));
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[i];
    for (std::size_t j = 0; j < constraint.unknowns.size(); ++j)
    {
      turning(constraint.unknowns[j], static_cast<Eigen::Index>(i)) = constraint.turning[j];
    }
  }
  return turning;
}
}

MinimiserResult SolveReducedUnit(const ReducedProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  MinimiserResult solution;
  if (problem.constraints.empty())
  {
    solution.converged = true;
    return solution;
  }
  const Eigen::MatrixXcd turning = EvenTurning(problem);
  const PhaseProblem phases{ turning.adjoint() * problem.matrix.cast<Complex>() * turning,
    turning.adjoint() * problem.load };
  const ComplexVector nearest = turning.adjoint() * start;
  PhasePoint point(
    phases, nearest.unaryExpr([](const Complex& sum) { return std::polar(1.0, std::arg(sum)); }));

  bool stalled = false;
  bool minimum = false;
  while (!stalled && solution.iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(solution.iterations) / options.maximumIterations);
    // Re(conj(a_i) M_ik a_k)
    const Eigen::MatrixXd elastic =
      (point.factors.conjugate().asDiagonal() * phases.matrix * point.factors.asDiagonal()).real();
    Eigen::MatrixXd hessian = elastic;
    hessian.diagonal() -= point.radial;
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(hessian);
    const Eigen::VectorXd& curvatures = spectrum.eigenvalues();
    minimum = curvatures.size() == 0 || curvatures[0] > 0.0;
    if (minimum && point.residual <= options.tolerance)
    {
      break;
    }
    ++solution.iterations;
    // Directions of negative curvature are followed downhill; flat ones not to infinity.
    const double flat = 1e-8 * curvatures.lpNorm<Eigen::Infinity>();
    const Eigen::VectorXd step =
      -(spectrum.eigenvectors() * curvatures.cwiseAbs().cwiseMax(flat).cwiseInverse().asDiagonal() *
        spectrum.eigenvectors().transpose() * point.tangential);
    const double slope = point.tangential.dot(step);
    stalled = true;
    for (double length = 1.0; stalled && length > 1e-10; length *= 0.5)
    {
      const ComplexVector turn =
        step.unaryExpr([length](double angle) { return Complex(std::polar(1.0, length * angle)); });
      PhasePoint trial(phases, point.factors.cwiseProduct(turn));
      // Near the minimum the objective no longer resolves the progress that the residual shows.
      if (trial.objective <= point.objective + 1e-4 * length * slope ||
        trial.residual <= 0.5 * point.residual)
      {
        point = std::move(trial);
        stalled = false;
      }
    }
  }
  solution.converged = minimum && point.residual <= options.tolerance;
  solution.residual = point.residual;
  solution.x = turning * point.factors;
  solution.multipliers =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.constraints.size()));
  return solution;
}
}
