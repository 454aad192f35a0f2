#include "DualMaximum.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// ∇ and −∇² of q or of another concave function.
struct Derivatives
{
  Eigen::VectorXd gradient;
  Eigen::MatrixXd curvature;

  Eigen::VectorXd NewtonStep() const { return this->curvature.ldlt().solve(this->gradient); }
};

Derivatives DualDerivatives(const DualPoint& point)
{
  return { point.gradient, point.factor.Forms(point.normals).real() };
}

/// Returns the increase of q predicted by Newton's model. Where q is close to an interior maximum,
/// this is the distance to the maximum; on a path towards the border the model does not see the end
/// of the region.
double PredictedIncrease(const Derivatives& derivatives)
{
  const double rise = 0.5 * derivatives.gradient.dot(derivatives.NewtonStep());
  return rise > 0.0 ? rise
                    : std::numeric_limits<double>::infinity(); // 0 indicates zero curvature: x = 0
}

/// Derivatives of both functions along the path: q, and log det H with ∂_i = tr(H⁻¹ A_i) and −∂_i
/// ∂_j = tr(H⁻¹ A_i H⁻¹ A_j).
struct DerivativesOnPath
{
  Derivatives ofDual;
  Derivatives ofBarrier;

  DerivativesOnPath(const DualProblem& problem, const DualPoint& point)
  {
    BlockCholesky<Complex>::Traces traces =
      point.factor.ComputeTraces(problem.constraints, point.normals);
    this->ofDual = { point.gradient, traces.forms.real() };
    this->ofBarrier = { std::move(traces.first), std::move(traces.second) };
  }
};

/// Candidate for x(λ), with A_i x and the residual b − H x.
struct Stationary
{
  ComplexVector x;
  ComplexVector normals;
  ComplexVector residual;

  Stationary(const DualProblem& problem, const Eigen::VectorXd& multipliers, ComplexVector at)
    : x(std::move(at))
    , normals(this->x.size())
    , residual(problem.load - problem.Elastic(this->x))
  {
    Eigen::Index row = 0;
    for (std::size_t i = 0; i < problem.constraints.size(); ++i)
    {
      const Eigen::Index size = problem.constraints[i].rows();
      this->normals.segment(row, size) = problem.constraints[i] * this->x.segment(row, size);
      this->residual.segment(row, size) -=
        multipliers[static_cast<Eigen::Index>(i)] * this->normals.segment(row, size);
      row += size;
    }
  }
};

/// Factors H(λ) minus a diagonal matrix.
BlockCholesky<Complex> FactorDual(
  const DualProblem& problem, const Eigen::VectorXd& multipliers, const DualProblem::Margin& less)
{
  std::vector<Eigen::MatrixXcd> blocks;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    blocks.emplace_back(problem.matrix.blocks[i] +
      multipliers[static_cast<Eigen::Index>(i)] * problem.constraints[i]);
    const Eigen::Index coupled = problem.matrix.coupled[i];
    blocks.back().diagonal().head(blocks.back().rows() - coupled).array() -= less.uncoupled;
    blocks.back().diagonal().tail(coupled).array() -= less.coupled;
  }
  return { blocks, problem.matrix.coupled, problem.matrix.coupling.cast<Complex>() };
}

/// Fraction of the predicted increase that a step must reach (Armijo condition).
constexpr double ArmijoFraction = 1e-4;

bool HalvesGradient(const DualPoint& from, const DualPoint& to)
{
  return to.gradient.norm() <= 0.5 * from.gradient.norm();
}

/// Returns whether a Newton step increases q sufficiently. Close to the maximum the value no longer
/// resolves the progress that the gradient still shows.
bool Improves(const DualPoint& from, const DualPoint& to, double predicted)
{
  return to.positiveDefinite &&
    (to.value - from.value >= ArmijoFraction * predicted || HalvesGradient(from, to));
}

/// Returns whether a step increases q + μ log det H sufficiently. ∇q may decide only where rounding
/// hides the increase: next to the border it grows and falls by arbitrary factors.
bool RaisesBarrierFunction(
  const DualPoint& from, const DualPoint& to, double barrier, double predicted)
{
  if (!to.positiveDefinite)
  {
    return false;
  }
  constexpr double Rounding = 1e-12; // relative rounding error of sums over all holes
  const double rise = to.value - from.value + barrier * (to.logDeterminant - from.logDeterminant);
  const double hidden = Rounding * (std::abs(from.value) + barrier * std::abs(from.logDeterminant));
  return rise >= ArmijoFraction * predicted || (rise >= -hidden && HalvesGradient(from, to));
}
}

DualPoint EvaluateDual(const DualProblem& problem, Eigen::VectorXd multipliers)
{
  DualPoint point;
  point.multipliers = std::move(multipliers);
  point.factor = FactorDual(problem, point.multipliers, { 0.0, 0.0 });
  point.positiveDefinite = point.factor.IsPositiveDefinite();
  if (!point.positiveDefinite)
  {
    return point;
  }
  Stationary here(problem, point.multipliers, point.factor.Solve(problem.load));
  // The factor lacks the couplings left out: refine with the residual as long as that helps.
  for (bool helps = problem.refinedWith != nullptr; helps;)
  {
    Stationary next(problem, point.multipliers, here.x + point.factor.Solve(here.residual));
    helps = next.residual.norm() < 0.5 * here.residual.norm();
    if (helps)
    {
      here = std::move(next);
    }
  }
  point.x = std::move(here.x);
  point.normals = std::move(here.normals);
  const ComplexVector elastic = problem.load - here.residual;
  point.gradient = -problem.targets;
  Eigen::Index row = 0;
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    const Eigen::Index size = problem.constraints[i].rows();
    point.gradient[static_cast<Eigen::Index>(i)] +=
      0.5 * point.x.segment(row, size).dot(point.normals.segment(row, size)).real();
    row += size;
  }
  point.value = -0.5 * problem.load.dot(point.x).real() - point.multipliers.dot(problem.targets);
  point.logDeterminant = point.factor.LogDeterminant();
  // C is a sum of terms of order one over the edges.
  const double violation = point.gradient.cwiseAbs().cwiseQuotient(problem.sizes).maxCoeff();
  const double scale = elastic.norm() + problem.load.norm();
  point.residual = std::max(violation, scale > 0.0 ? here.residual.norm() / scale : 0.0);
  return point;
}

bool IsCertain(const DualProblem& problem, const DualPoint& point)
{
  return point.positiveDefinite &&
    FactorDual(problem, point.multipliers, problem.MarginOfLeftOut()).IsPositiveDefinite();
}

DualPoint MaximiseNearby(const DualProblem& problem, DualPoint point,
  const MinimiserOptions& options, const Progress& progress, int& iterations)
{
  bool stalled = !point.positiveDefinite;
  while (!stalled && point.residual > options.tolerance && iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(iterations) / options.maximumIterations);
    const Derivatives derivatives = DualDerivatives(point);
    const Eigen::VectorXd step = derivatives.NewtonStep();
    DualPoint next = EvaluateDual(problem, point.multipliers + step);
    ++iterations;
    stalled = !Improves(point, next, derivatives.gradient.dot(step));
    if (!stalled)
    {
      point = std::move(next);
    }
  }
  return point;
}

DualPoint MaximiseFromZero(const DualProblem& problem, const MinimiserOptions& options,
  const Progress& progress, int& iterations)
{
  DualPoint point = EvaluateDual(problem, Eigen::VectorXd::Zero(problem.targets.size()));
  // λ scales as S, and the barrier as one. The barrier parameter is measured in units of the mean
  // of S: at 1 the path has hardly left λ = 0, where it begins; `Last` is above the value at which
  // rounding in H hides the barrier. On random hard cases the increase predicted by Newton's model
  // was below the gap on all late parts of paths to an interior maximum, and above 100 times the
  // gap on the others.
  constexpr double Late = 1e-7;
  constexpr double Last = 1e-12;
  const double unit = problem.matrix.Trace() / static_cast<double>(problem.matrix.Rows());
  double relative = 1.0;
  double reach = 1.0; // fraction of the intended decrease that a step along the tangent covers
  bool stalled = !point.positiveDefinite;
  while (!stalled && relative > Last && point.residual > options.tolerance &&
    iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(iterations) / options.maximumIterations);
    const DerivativesOnPath derivatives(problem, point);
    const Derivatives& ofDual = derivatives.ofDual;
    const Derivatives& ofBarrier = derivatives.ofBarrier;
    const double barrier = unit * relative;
    const Eigen::LDLT<Eigen::MatrixXd> curvature(ofDual.curvature + barrier * ofBarrier.curvature);
    const Eigen::VectorXd gradient = ofDual.gradient + barrier * ofBarrier.gradient;
    // In units of the barrier parameter, the slope of Newton's step is the square of its decrement.
    // From a decrement below one, Newton's method converges to the path. A smaller barrier
    // parameter, farther away from the path, would lead next to the border and along it.
    const bool centred = gradient.dot(curvature.solve(gradient)) <= barrier;
    if (centred && relative < Late &&
      PredictedIncrease(ofDual) > 10.0 * barrier * static_cast<double>(point.x.size()))
    {
      point.onBorder = true;
      return point;
    }
    const double target = std::min(0.1 * relative, std::pow(relative, 1.2));
    stalled = true;
    // 40 halvings reach below the smallest step that a double's mantissa resolves.
    double length = centred ? reach : 1.0;
    for (int halving = 0; stalled && halving < 40; ++halving)
    {
      // On the path, step along its tangent: use the curvature of this barrier parameter to predict
      // the point for a smaller one. Otherwise step towards the path.
      const double next = centred ? relative - length * (relative - target) : relative;
      const Eigen::VectorXd towards = ofDual.gradient + unit * next * ofBarrier.gradient;
      const Eigen::VectorXd step = (centred ? 1.0 : length) * curvature.solve(towards);
      DualPoint trial = EvaluateDual(problem, point.multipliers + step);
      stalled = !RaisesBarrierFunction(point, trial, unit * next, towards.dot(step));
      if (!stalled)
      {
        point = std::move(trial);
        relative = next;
        reach = centred ? std::min(1.0, 2.0 * length) : reach;
      }
      length *= 0.5;
    }
    ++iterations;
  }
  return MaximiseNearby(problem, std::move(point), options, progress, iterations);
}
}
