#include "UnitSolve.h"

#include "DenseCholesky.h"
#include "DenseProduct.h"
#include "SerialBlas.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Problem ½ aᴴ M a − Re(cᴴ a) that remains for the factors a_i = e^{iφ_i} of the holes.
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
  Eigen::VectorXd radial; ///< Component of the gradient M a − c along each a_i.
  /// Component perpendicular to a_i: the derivative of the objective with respect to φ_i.
  Eigen::VectorXd tangential;
  double residual = 0.0;

  PhasePoint(const PhaseProblem& problem, ComplexVector at)
    : factors(std::move(at))
  {
    const ComplexVector product = problem.matrix * this->factors;
    this->objective =
      0.5 * this->factors.dot(product).real() - problem.load.dot(this->factors).real();
    const ComplexVector gradient = this->factors.conjugate().cwiseProduct(product - problem.load);
    this->radial = gradient.real();
    this->tangential = gradient.imag();
    const double scale = product.norm() + problem.load.norm();
    this->residual = scale == 0.0 ? 0.0 : this->tangential.norm() / scale;
  }
};

/// Final point of Newton's method.
struct Descent
{
  PhasePoint point;
  int iterations = 0;
  bool converged = false;
};

/// Newton step for a Hessian, and whether a stationary point is a minimum there.
struct PhaseStep
{
  Eigen::VectorXd step;
  bool minimum;
};

PhaseStep ComputeStep(const Eigen::MatrixXd& hessian, const PhasePoint& point, double stiffness)
{
  // Directions of negative curvature are followed downhill; steps along flat directions are
  // bounded.
  constexpr double Flat = 1e-8;
  // If no curvature is that small, use a Cholesky factorisation, which detects this at a tenth of
  // the cost of the spectrum.
  const double largest = std::max(stiffness, hessian.cwiseAbs().rowwise().sum().maxCoeff());
  Eigen::MatrixXd lessFlat = hessian;
  lessFlat.diagonal().array() -= Flat * largest;
  if (DenseCholesky<double>(std::move(lessFlat)).IsPositiveDefinite())
  {
    return { -DenseCholesky<double>(hessian).Solve(point.tangential), true };
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> spectrum(hessian);
  const Eigen::VectorXd& curvatures = spectrum.eigenvalues();
  const double flat = Flat * std::max(stiffness, curvatures.lpNorm<Eigen::Infinity>());
  return { -(spectrum.eigenvectors() *
             curvatures.cwiseAbs().cwiseMax(flat).cwiseInverse().asDiagonal() *
             spectrum.eigenvectors().transpose() * point.tangential),
    // Without a load all holes may turn together: one curvature is zero, up to rounding.
    curvatures[0] >= -1e-13 * stiffness };
}

/// Minimises by Newton's method with a line search.
Descent Descend(const PhaseProblem& phases, PhasePoint start, const MinimiserOptions& options,
  const Progress& progress)
{
  Descent descent{ std::move(start) };
  bool stalled = false;
  bool minimum = false;
  while (!stalled && descent.iterations < options.maximumIterations)
  {
    progress.Report(static_cast<double>(descent.iterations) / options.maximumIterations);
    // Re(conj(a_i) M_ik a_k)
    const Eigen::MatrixXd elastic = (descent.point.factors.conjugate().asDiagonal() *
      phases.matrix * descent.point.factors.asDiagonal())
                                      .real();
    Eigen::MatrixXd hessian = elastic;
    hessian.diagonal() -= descent.point.radial;
    const double stiffness = elastic.diagonal().maxCoeff();
    const PhaseStep newton = ComputeStep(hessian, descent.point, stiffness);
    minimum = newton.minimum;
    if (minimum && descent.point.residual <= options.tolerance)
    {
      break;
    }
    ++descent.iterations;
    const Eigen::VectorXd& step = newton.step;
    const double slope = descent.point.tangential.dot(step);
    stalled = true;
    for (double length = 1.0; stalled && length > 1e-10; length *= 0.5)
    {
      const ComplexVector turn =
        step.unaryExpr([length](double angle) { return Complex(std::polar(1.0, length * angle)); });
      PhasePoint trial(phases, descent.point.factors.cwiseProduct(turn));
      // Near the minimum the objective no longer resolves the progress that the residual shows.
      if (trial.objective <= descent.point.objective + 1e-4 * length * slope ||
        trial.residual <= 0.5 * descent.point.residual)
      {
        descent.point = std::move(trial);
        stalled = false;
      }
    }
  }
  descent.converged = minimum && descent.point.residual <= options.tolerance;
  return descent;
}

/// Sets each factor in turn to its optimal value for the current others, beginning after the factor
/// of `hole`. In the first sweep the factor of `hole` itself is kept, so that the others follow it.
/// Ends when no factor turns noticeably.
ComplexVector Relax(
  const PhaseProblem& phases, ComplexVector factors, Eigen::Index hole, int sweeps)
{
  // Radians. The remaining error of the objective is of the order of its square, and Newton's
  // method removes it. So a hole is expensive only while it turns, and most are far from the one
  // that was turned.
  constexpr double Noticeable = 1e-3;
  const SerialBlas serial; // once, not for every hole
  ComplexVector product = phases.matrix * factors;
  Eigen::Index still = 0;
  for (Eigen::Index step = 1; step <= sweeps * factors.size() && still < factors.size(); ++step)
  {
    const Eigen::Index i = (hole + step) % factors.size();
    const Complex pull = phases.load[i] - product[i] + phases.matrix(i, i) * factors[i];
    const Complex change = std::abs(pull) > 0.0 && step != factors.size()
      ? pull / std::abs(pull) - factors[i]
      : Complex(0.0);
    ++still;
    if (std::abs(change) > Noticeable)
    {
      AddMultiple(change, phases.matrix.col(i), product);
      factors[i] += change;
      still = 0;
    }
  }
  return factors;
}

/// Returns whether another descent ended better by more than the rounding of the objective.
bool IsBetter(const Descent& other, const Descent& best, double rounding)
{
  return other.converged != best.converged
    ? other.converged
    : other.point.objective < best.point.objective - rounding;
}

/// Turns, from the best result so far, the phase of each hole in turn by π, lets the others follow,
/// and descends again, until no hole gives an improvement. The objective is a single cosine of each
/// phase, so the opposite phase is the worst one for the current others and makes them turn too.
Descent DescendFromManyStarts(const PhaseProblem& phases, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  // Newton's method costs the cube of the number of holes, and a sweep its square.
  constexpr Eigen::Index FewHoles = 16;
  constexpr int Sweeps = 20;
  const double rounding = 1e-13 * (phases.matrix.trace().real() + phases.load.lpNorm<1>());
  Descent best = Descend(phases, PhasePoint(phases, start), options, progress.Part(0.0, 0.5));
  if (!best.converged)
  {
    return best; // out of iterations; sweeps, which are not counted, must not hide this
  }
  const Eigen::Index count = start.size();
  Eigen::Index tried = 0;
  for (Eigen::Index sinceBetter = 0; sinceBetter < count; ++tried, ++sinceBetter)
  {
    const double done =
      0.5 + 0.5 * std::min(1.0, 0.5 * static_cast<double>(tried) / static_cast<double>(count));
    progress.Report(done);
    const Eigen::Index hole = tried % count;
    ComplexVector factors = best.point.factors;
    factors[hole] = -factors[hole];
    PhasePoint relaxed(phases, Relax(phases, std::move(factors), hole, Sweeps));
    if (count > FewHoles && relaxed.objective >= best.point.objective)
    {
      continue;
    }
    Descent other = Descend(phases, std::move(relaxed), options, progress.Part(done, done));
    if (IsBetter(other, best, rounding))
    {
      best = std::move(other);
      sinceBetter = -1;
    }
  }
  return best;
}

/// Returns the evenly turning unit values of all holes.
ComplexVector EvenTurning(const ReducedProblem& problem)
{
  ComplexVector turning(problem.matrix.Rows());
  for (const DegreeConstraint& constraint : problem.constraints)
  {
    for (std::size_t j = 0; j < constraint.unknowns.size(); ++j)
    {
      turning[constraint.unknowns[j]] = constraint.turning[j];
    }
  }
  return turning;
}

/// Returns B a, where the values of hole i are column i of B.
ComplexVector ApplyFactors(
  const ReducedProblem& problem, const ComplexVector& values, const ComplexVector& factors)
{
  ComplexVector turned(values.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    for (const int unknown : problem.constraints[i].unknowns)
    {
      turned[unknown] = values[unknown] * factors[static_cast<Eigen::Index>(i)];
    }
  }
  return turned;
}

/// Returns Bᴴ x.
ComplexVector ApplyAdjoint(
  const ReducedProblem& problem, const ComplexVector& values, const ComplexVector& x)
{
  const ComplexVector products = values.conjugate().cwiseProduct(x);
  ComplexVector sums = ComplexVector::Zero(static_cast<Eigen::Index>(problem.constraints.size()));
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    for (const int unknown : problem.constraints[i].unknowns)
    {
      sums[static_cast<Eigen::Index>(i)] += products[unknown];
    }
  }
  return sums;
}

/// Returns the phase problem with P = Bᴴ S B and c = Bᴴ b.
PhaseProblem ReduceToPhases(const ReducedProblem& problem, const ComplexVector& values)
{
  // For v = r + i s on hole i and on hole k: (rᵀSr + sᵀSs) + i (rᵀSs − sᵀSr).
  std::vector<Eigen::MatrixXd> parts;
  for (int hole = 0; hole < problem.matrix.BlockCount(); ++hole)
  {
    const auto ofHole = values.segment(problem.matrix.First(hole), problem.matrix.Size(hole));
    parts.emplace_back(ofHole.size(), 2);
    parts.back() << ofHole.real(), ofHole.imag();
  }
  const Eigen::MatrixXd forms = problem.matrix.Congruence(parts).Dense();
  const auto holes = static_cast<Eigen::Index>(parts.size());
  PhaseProblem phases{ Eigen::MatrixXcd(holes, holes),
    ApplyAdjoint(problem, values, problem.load) };
  for (Eigen::Index k = 0; k < holes; ++k)
  {
    for (Eigen::Index i = 0; i < holes; ++i)
    {
      const auto form = forms.block<2, 2>(2 * i, 2 * k);
      phases.matrix(i, k) = { form(0, 0) + form(1, 1), form(0, 1) - form(1, 0) };
    }
  }
  return phases;
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
  const ComplexVector turning = EvenTurning(problem);
  const PhaseProblem phases = ReduceToPhases(problem, turning);
  const ComplexVector nearest = ApplyAdjoint(problem, turning, start);
  const Descent best = DescendFromManyStarts(phases,
    nearest.unaryExpr([](const Complex& sum) { return std::polar(1.0, std::arg(sum)); }), options,
    progress);
  solution.iterations = best.iterations;
  solution.converged = best.converged;
  solution.residual = best.point.residual;
  solution.x = ApplyFactors(problem, turning, best.point.factors);
  solution.multipliers =
    Eigen::VectorXd::Zero(static_cast<Eigen::Index>(problem.constraints.size()));
  return solution;
}

ComplexVector RelaxPhases(const ReducedProblem& problem, const ComplexVector& x)
{
  if (problem.constraints.empty())
  {
    return x;
  }
  const PhaseProblem phases = ReduceToPhases(problem, x);
  const Descent descent =
    Descend(phases, PhasePoint(phases, ComplexVector::Ones(phases.load.size())), {}, {});
  return ApplyFactors(problem, x, descent.point.factors);
}
}
