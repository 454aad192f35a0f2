#include "ReducedProblem.h"

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
/// The reduced problem in the discrete Fourier modes of every hole, x_j = Σ_q a_q e^{2πi q j/m} / √m
/// over its m edges: the matrices A_i become diagonal there, with entries 2 sin(2πq/m).
struct ModalProblem
{
  Eigen::SparseMatrix<Complex> modes; ///< Orthonormal columns.
  Eigen::MatrixXcd matrix;            ///< S in these modes, Hermitian positive definite.
  ComplexVector load;                 ///< b in these modes.
  Eigen::MatrixXd turning;            ///< Column i: diagonal of A_i.
  Eigen::VectorXd targets;
  Eigen::VectorXd sizes; ///< Number of edges of every hole.
};

/// Modes |q| ≤ |d| + extra of every hole.
ModalProblem ToModes(const ReducedProblem& problem, int extra)
{
  std::vector<Eigen::Triplet<Complex>> entries;
  std::vector<std::pair<int, double>> turning; // hole and entry of every mode
  ModalProblem modal;
  const auto holes = static_cast<Eigen::Index>(problem.constraints.size());
  modal.targets.resize(holes);
  modal.sizes.resize(holes);
  for (int i = 0; i < static_cast<int>(holes); ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[static_cast<std::size_t>(i)];
    const auto m = static_cast<int>(constraint.unknowns.size());
    modal.targets[i] = constraint.target;
    modal.sizes[i] = m;
    const int highest = std::abs(constraint.degree) + std::min(extra, m);
    for (int q = std::max(-highest, -(m - 1) / 2); q <= std::min(highest, m / 2); ++q)
    {
      for (int j = 0; j < m; ++j)
      {
        // The remainder keeps the argument small, and the mode exactly periodic.
        const double angle = 2.0 * Pi * ((q * j) % m) / m;
        entries.emplace_back(constraint.unknowns[static_cast<std::size_t>(j)],
          static_cast<int>(turning.size()), std::polar(1.0 / std::sqrt(m), angle));
      }
      turning.emplace_back(i, 2.0 * std::sin(2.0 * Pi * q / m));
    }
  }
  const auto count = static_cast<Eigen::Index>(turning.size());
  modal.modes.resize(problem.matrix.rows(), count);
  modal.modes.setFromTriplets(entries.begin(), entries.end());
  modal.turning = Eigen::MatrixXd::Zero(count, holes);
  for (Eigen::Index mode = 0; mode < count; ++mode)
  {
    const auto& [hole, value] = turning[static_cast<std::size_t>(mode)];
    modal.turning(mode, hole) = value;
  }
  const Eigen::MatrixXcd product = problem.matrix.cast<Complex>() * modal.modes;
  modal.matrix = modal.modes.adjoint() * product;
  modal.load = modal.modes.adjoint() * problem.load;
  return modal;
}

/// The dual function and what Newton's method needs of it at one λ.
struct DualPoint
{
  bool positiveDefinite = false;
  Eigen::VectorXd multipliers;
  ComplexVector a;
  double value = 0.0;
  Eigen::VectorXd gradient; ///< C_i(x) − t_i.
  double residual = std::numeric_limits<double>::infinity(); ///< Of all optimality conditions.
  Eigen::LLT<Eigen::MatrixXcd> factor;
};

DualPoint Evaluate(const ModalProblem& problem, Eigen::VectorXd at)
{
  DualPoint point;
  point.multipliers = std::move(at);
  Eigen::MatrixXcd hessian = problem.matrix;
  hessian.diagonal() += (problem.turning * point.multipliers).cast<Complex>();
  point.factor.compute(hessian);
  point.positiveDefinite = point.factor.info() == Eigen::Success;
  if (!point.positiveDefinite)
  {
    return point;
  }
  point.a = point.factor.solve(problem.load);
  point.gradient =
    0.5 * (problem.turning.transpose() * point.a.cwiseAbs2()) - problem.targets;
  point.value =
    -0.5 * problem.load.dot(point.a).real() - point.multipliers.dot(problem.targets);
  // C is a sum of terms of size one over the edges.
  const double violation = point.gradient.size() == 0
    ? 0.0
    : point.gradient.cwiseAbs().cwiseQuotient(problem.sizes).maxCoeff();
  const ComplexVector elastic = hessian.selfadjointView<Eigen::Lower>() * point.a;
  const double scale = elastic.norm() + problem.load.norm();
  point.residual =
    std::max(violation, scale > 0.0 ? (elastic - problem.load).norm() / scale : 0.0);
  return point;
}

/// δλ with ∇²q δλ = −∇q.
Eigen::VectorXd NewtonStep(const ModalProblem& problem, const DualPoint& point)
{
  const Eigen::MatrixXcd normals = point.a.asDiagonal() * problem.turning;
  const Eigen::MatrixXd curvature = (normals.adjoint() * point.factor.solve(normals)).real();
  return curvature.ldlt().solve(point.gradient);
}

/// Newton's method from given multipliers; counts its steps.
DualPoint Maximise(const ModalProblem& problem, DualPoint point, const ReducedOptions& options,
  const Progress& progress, int& iterations)
{
  bool stalled = !point.positiveDefinite;
  while (!stalled && point.residual > options.tolerance && iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(iterations) / options.maximumIterations);
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
  const Eigen::VectorXd zero =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.constraints.size()));

  // 1. In the few modes that carry most of the field, where a step costs next to nothing.
  constexpr int LowModes = 4;
  ReducedOptions rough = options;
  rough.tolerance = std::max(options.tolerance, 1e-6); // what the missing modes change is larger
  const ModalProblem low = ToModes(problem, LowModes);
  const DualPoint start =
    Maximise(low, Evaluate(low, zero), rough, progress.Part(0.0, 0.5), solution.iterations);

  // 2. In all modes from there, or from the harmonic field if the multipliers are out of reach.
  const ModalProblem full = ToModes(problem, std::numeric_limits<int>::max());
  DualPoint point = Evaluate(full, start.multipliers);
  if (!point.positiveDefinite)
  {
    point = Evaluate(full, zero);
  }
  point = Maximise(full, std::move(point), options, progress.Part(0.5, 1.0), solution.iterations);

  solution.x = full.modes * point.a;
  solution.multipliers = point.multipliers;
  solution.residual = point.residual;
  solution.converged = point.positiveDefinite && point.residual <= options.tolerance;
  return solution;
}
}
