#include "ConstrainedMinimiser.h"

#include "Error.h"

#include <Eigen/Cholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Shifts relative to M, tried in increasing order. Each one costs a factorisation, but a step that
/// is damped more than necessary costs additional steps, so the first shift is small. Where only
/// the constraints cause saddles, the soft directions are rotations of entire holes, whose
/// couplings are much smaller than M; there the first shift is smaller still.
constexpr double FirstShift = 1.0 / 64.0;
constexpr double FirstShiftOfConstraints = 1.0 / 16384.0;
constexpr double ShiftGrowth = 4.0;
/// Last shift to try, far larger than any Σ λ_i A_i requires; without constraints 1 is enough
/// (docs/method.md §4.2).
constexpr double LastShift = 1e9;

/// Weight of the normals relative to the stiffness. With a weight this large, the matrix is
/// positive definite exactly if the quadratic form is positive on the complement of the normals.
constexpr double NormalWeight = 1e4;

/// Relative decrease of the merit below which a convexified step is considered to be close to a
/// saddle. Such steps converge to the saddle slowly; another direction is needed to descend.
constexpr double SlowDescent = 1e-4;

/// Relative difference of merits below which it may come from the remaining residual.
constexpr double NoticeableDescent = 1e-9;

/// Relative difference of merits below which it may come from rounding.
constexpr double RelativeRounding = 1e-13;

/// Returns the real and imaginary parts of a complex vector as a real vector.
Eigen::Map<const Eigen::VectorXd> Parts(const ComplexVector& x)
{
  return { reinterpret_cast<const double*>(x.data()), 2 * x.size() };
}

ComplexVector FromParts(const Eigen::VectorXd& parts)
{
  return Eigen::Map<const ComplexVector>(
    reinterpret_cast<const Complex*>(parts.data()), parts.size() / 2);
}

/// Solves a positive definite system with one row per constraint, possibly with none.
Eigen::VectorXd SolveSmall(const Eigen::MatrixXd& matrix, const Eigen::VectorXd& rightHandSide)
{
  return matrix.size() == 0 ? rightHandSide : Eigen::VectorXd(matrix.ldlt().solve(rightHandSide));
}

/// Values and first derivatives of the functional and its constraints at a point.
struct LocalPoint
{
  ComplexVector x;
  Eigen::VectorXd gradient;
  Eigen::SparseMatrix<double>
    /// Column i is A_i x, which is sparse: a constraint involves few unknowns.
    normals;
  Eigen::VectorXd violations; ///< c_i.
  double value = 0.0;

  LocalPoint(const ConstrainedFunctional& functional,
    const std::vector<QuadraticConstraint>& constraints, ComplexVector at)
    : x(std::move(at))
    , gradient(functional.Gradient(this->x))
    , value(functional.Value(this->x))
  {
    const auto count = static_cast<Eigen::Index>(constraints.size());
    std::vector<Eigen::Triplet<double>> entries;
    this->violations.resize(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const QuadraticConstraint& constraint = constraints[i];
      constraint.AddGradient(this->x, static_cast<int>(i), entries);
      this->violations[i] = constraint.Value(this->x) - constraint.target;
    }
    this->normals.resize(2 * this->x.size(), count);
    this->normals.setFromTriplets(entries.begin(), entries.end());
  }

  /// Returns the merit. If `weight` exceeds every |λ_i|, a solution of the problem is a minimum of
  /// it.
  double Merit(double weight) const { return this->value + weight * this->violations.lpNorm<1>(); }
  /// Returns a bound on the rounding error of the merit. The terms of a quadratic function may
  /// cancel in f, but not in ∇f · x as well.
  double MeritRounding() const
  {
    return RelativeRounding *
      (std::abs(this->value) + std::abs(this->gradient.dot(Parts(this->x))));
  }
  /// Returns Nᵀ N.
  Eigen::MatrixXd ProductsOfNormals() const
  {
    return Eigen::MatrixXd(Eigen::SparseMatrix<double>(this->normals.transpose() * this->normals));
  }
  /// Returns the λ that minimises the norm of ∇f + Σ λ_i A_i x.
  Eigen::VectorXd LeastSquaresMultipliers() const
  {
    return -SolveSmall(this->ProductsOfNormals(), this->normals.transpose() * this->gradient);
  }
  /// Returns the shortest step that satisfies the linearised constraints.
  ComplexVector Restoration() const
  {
    return FromParts(-this->normals * SolveSmall(this->ProductsOfNormals(), this->violations));
  }
};

class Minimiser
{
public:
  Minimiser(ConstrainedFunctional& functional, const std::vector<QuadraticConstraint>& constraints,
    const ComplexVector& start, const MinimiserOptions& options)
    : Functional(functional)
    , Constraints(constraints)
    , Options(options)
    , Metric(functional.Metric())
    , First(this->Metric.size() > 0 ? FirstShift : FirstShiftOfConstraints)
    , Here(functional, constraints, functional.Relax(start))
    , Multipliers(this->Here.LeastSquaresMultipliers())
    , Residual(this->ResidualAt(this->Here, this->Multipliers))
  {
  }

  MinimiserResult Run(const Progress& progress)
  {
    MinimiserResult result;
    result.values.push_back(this->Here.value);
    while (true)
    {
      const bool critical = this->Residual <= this->Options.tolerance;
      if (critical && this->TryFactor(0.0, true))
      {
        result.converged = true;
        break;
      }
      if (result.iterations >= this->Options.maximumIterations)
      {
        break;
      }
      progress.Report(static_cast<double>(result.iterations) / this->Options.maximumIterations);
      this->FactorConvexified(critical ? this->First : this->NextShift, critical);
      const bool nearSaddle = critical || (this->Slow && this->Shift > 0.0);
      // Away from a critical point, leaving the saddle must gain more than the steps that it
      // replaces.
      if (nearSaddle && this->LeaveSaddle(critical ? NoticeableDescent : SlowDescent))
      {
        ++result.saddlesLeft;
      }
      else if (!critical && this->Step())
      {
        if (this->Shift > 0.0)
        {
          ++result.convexifiedSteps;
          this->RelaxHere();
        }
      }
      else
      {
        break; // the saddle cannot be left, or no step improves the merit
      }
      ++result.iterations;
      result.values.push_back(this->Here.value);
    }
    result.x = this->Here.x;
    result.multipliers = this->Multipliers;
    result.residual = this->Residual;
    return result;
  }

private:
  /// Returns the relative residual of the optimality conditions.
  double ResidualAt(const LocalPoint& point, const Eigen::VectorXd& multipliers) const
  {
    double residual = 0.0;
    for (std::size_t i = 0; i < this->Constraints.size(); ++i)
    {
      residual = std::max(residual,
        std::abs(point.violations[static_cast<Eigen::Index>(i)]) / this->Constraints[i].size);
    }
    const double scale = this->Functional.GradientScale(point.x);
    const Eigen::VectorXd gradient = point.gradient + point.normals * multipliers;
    return std::max(residual, scale > 0.0 ? gradient.norm() / scale : 0.0);
  }

  /// Factors with this shift; returns false when the shift is too small. `certain` as in Additions.
  bool TryFactor(double shift, bool certain)
  {
    ConstrainedFunctional::Additions additions;
    for (std::size_t i = 0; i < this->Constraints.size(); ++i)
    {
      for (const QuadraticConstraint::Entry& entry : this->Constraints[i].entries)
      {
        additions.constraints.push_back({ entry.row, entry.column,
          this->Multipliers[static_cast<Eigen::Index>(i)] * entry.value });
      }
    }
    additions.multipliers = this->Multipliers;
    additions.normals = this->Here.normals;
    additions.weight = NormalWeight * this->Functional.Stiffness();
    additions.shift = shift;
    additions.certain = certain;
    this->Shift = additions.shift;
    this->Scale = additions.weight;
    return this->Functional.Factor(this->Here.x, additions);
  }

  /// Factors with the smallest sufficient shift, starting from the given one.
  void FactorConvexified(double shift, bool certain)
  {
    shift = shift < this->First ? 0.0 : shift;
    while (!this->TryFactor(shift, certain))
    {
      if (shift >= LastShift)
      {
        throw Error(
          "The second derivatives cannot be factored; the mesh may be in several parts or "
          "have degenerate triangles, remesh the domain.");
      }
      shift = std::max(this->First, ShiftGrowth * shift);
    }
  }

  /// Moves along the motion known to the functional (Relax), without changing the multipliers.
  void RelaxHere()
  {
    ComplexVector relaxed = this->Functional.Relax(this->Here.x);
    if (relaxed != this->Here.x)
    {
      this->Here = LocalPoint(this->Functional, this->Constraints, std::move(relaxed));
      this->Residual = this->ResidualAt(this->Here, this->Multipliers);
    }
  }

  /// Takes one step of the convexified quadratic problem; returns false when no step length
  /// improves the merit.
  bool Step()
  {
    const LocalPoint& here = this->Here;
    Eigen::VectorXd direction = -this->Functional.Solve(here.gradient);
    Eigen::VectorXd plain(0);
    if (!this->Constraints.empty())
    {
      plain = SolveSmall(this->Functional.Forms(here.normals),
        here.violations + here.normals.transpose() * direction);
      direction -= this->Functional.Solve(here.normals * plain);
    }
    // The weight on the normals shifts the multipliers by weight × Nᵀ δx = −weight × c.
    const Eigen::VectorXd target = plain - this->Scale * here.violations;
    this->Weight = std::max(1.0, target.size() > 0 ? 2.0 * target.lpNorm<Eigen::Infinity>() : 0.0);
    const double slope = here.gradient.dot(direction) - this->Weight * here.violations.lpNorm<1>();
    const double merit = here.Merit(this->Weight);
    for (double length = 1.0; length > 1e-10; length *= 0.5)
    {
      const double acceptable = merit + 1e-4 * length * slope;
      LocalPoint trial = this->At(length * direction);
      if (!this->Constraints.empty() && trial.Merit(this->Weight) > acceptable)
      {
        // The constraints are curved: take one step back towards them.
        trial = LocalPoint(this->Functional, this->Constraints, trial.x + trial.Restoration());
      }
      const double trialMerit = trial.Merit(this->Weight);
      const Eigen::VectorXd moved = this->Multipliers + length * (target - this->Multipliers);
      const double residual = this->ResidualAt(trial, moved);
      // Near the solution rounding hides progress in the merit that the residual still shows.
      // Elsewhere a smaller residual does not justify a step: it leads to saddles and maxima as
      // well.
      const bool decreases = trialMerit <= acceptable && trialMerit < merit;
      const bool converges =
        trialMerit <= merit + here.MeritRounding() && residual <= 0.5 * this->Residual;
      if (decreases || converges)
      {
        // A full step indicates that the quadratic model holds: use a smaller shift next time.
        this->NextShift = length == 1.0 ? this->Shift / ShiftGrowth : this->Shift;
        this->Slow = this->Shift > 0.0 && merit - trialMerit < SlowDescent * std::abs(merit);
        this->Here = std::move(trial);
        this->Multipliers = moved;
        this->Residual = residual;
        return true;
      }
    }
    return false;
  }

  /// Takes a step along the direction of minimum curvature; returns false when the merit does not
  /// decrease by the given fraction of itself.
  ///
  /// The direction is found by inverse iteration with the available factor, at no extra
  /// factorisation. The shift of that factor barely compensates the negative curvature, so other
  /// directions are damped faster than with a larger shift. Curvature is measured relative to the
  /// metric, otherwise small triangles would count as much as large ones.
  bool LeaveSaddle(double requiredDescent)
  {
    this->Slow = false;
    if (this->Metric.size() == 0)
    {
      return false;
    }
    Eigen::VectorXd direction(this->Metric.size());
    for (Eigen::Index i = 0; i < direction.size(); ++i)
    {
      // a start without the symmetry of any mesh
      direction[i] = std::sin(12.9898 * static_cast<double>(i + 1));
    }
    for (int round = 0; round < 30; ++round)
    {
      direction = this->Functional.Solve(this->Metric.cwiseProduct(direction).eval());
      direction /= direction.lpNorm<Eigen::Infinity>();
    }
    if (direction.dot(this->Here.gradient) > 0.0)
    {
      direction = -direction;
    }
    const double merit = this->Here.Merit(this->Weight);
    for (double length = 1.0; length > 1e-3; length *= 0.5)
    {
      LocalPoint trial = this->At(length * direction);
      trial = LocalPoint(this->Functional, this->Constraints, trial.x + trial.Restoration());
      if (trial.Merit(this->Weight) < merit - requiredDescent * std::abs(merit))
      {
        this->Here = std::move(trial);
        this->Multipliers = this->Here.LeastSquaresMultipliers();
        this->Residual = this->ResidualAt(this->Here, this->Multipliers);
        return true;
      }
    }
    return false;
  }

  LocalPoint At(const Eigen::VectorXd& step) const
  {
    return { this->Functional, this->Constraints, FromParts(Parts(this->Here.x) + step) };
  }

  ConstrainedFunctional& Functional;
  const std::vector<QuadraticConstraint>& Constraints;
  MinimiserOptions Options;
  Eigen::VectorXd Metric;
  double First; ///< First shift to try.
  LocalPoint Here;
  Eigen::VectorXd Multipliers;
  double Residual;
  double Weight = 1.0;    ///< Weight of the violations in the merit.
  double Scale = 0.0;     ///< Weight of the normals in the last factorisation.
  double Shift = 0.0;     ///< Shift of the last factorisation.
  double NextShift = 0.0; ///< Shift to try first in the next step; below First it counts as none.
  /// Whether the last step was convexified and decreased the merit by little.
  bool Slow = false;
};
}

MinimiserResult MinimiseConstrained(ConstrainedFunctional& functional,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  return Minimiser(functional, constraints, start, options).Run(progress);
}
}
