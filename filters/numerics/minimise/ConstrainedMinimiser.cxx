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
/// The shifts, relative to M, that are tried in turn. Each costs a factorisation; but a step that is
/// damped more than necessary costs more of them, so the first one is small. Where constraints alone make saddles, what
/// is soft are holes as a whole, which feel each other by far less than M is: there it is smaller still.
constexpr double FirstShift = 1.0 / 64.0;
constexpr double FirstShiftOfConstraints = 1.0 / 16384.0;
constexpr double ShiftGrowth = 4.0;
/// Far more than any Σ λ_i A_i asks for; without constraints 1 is enough (docs/method.md §4.2).
constexpr double LastShift = 1e9;

/// Weighting the normals this heavily, relative to the stiffness, leaves the sign of a quadratic form
/// on their complement to decide whether it is positive definite.
constexpr double NormalWeight = 1e4;

/// A convexified step that lowers the merit by less than this, relatively, is caught at a saddle:
/// such steps converge to it slowly, where the way down is another one.
constexpr double SlowDescent = 1e-4;

/// Merits that differ by less, relatively, may differ by what is left of the residual.
constexpr double NoticeableDescent = 1e-9;

/// Merits that differ by less, relatively, differ by rounding.
constexpr double RelativeRounding = 1e-13;

/// The parts of a complex vector as a real one.
Eigen::Map<const Eigen::VectorXd> Parts(const ComplexVector& x)
{
  return { reinterpret_cast<const double*>(x.data()), 2 * x.size() };
}

ComplexVector FromParts(const Eigen::VectorXd& parts)
{
  return Eigen::Map<const ComplexVector>(
    reinterpret_cast<const Complex*>(parts.data()), parts.size() / 2);
}

/// Solves a positive definite system with one row per constraint; there may be none.
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
    normals;                  ///< Column i is A_i x: a constraint has to do with few unknowns.
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
      const QuadraticConstraint& constraint = constraints[static_cast<std::size_t>(i)];
      constraint.AddGradient(this->x, static_cast<int>(i), entries);
      this->violations[i] = constraint.Value(this->x) - constraint.target;
    }
    this->normals.resize(2 * this->x.size(), count);
    this->normals.setFromTriplets(entries.begin(), entries.end());
  }

  /// `weight` above every |λ_i| makes a solution of the problem a minimum of this.
  double Merit(double weight) const { return this->value + weight * this->violations.lpNorm<1>(); }
  /// By how much rounding may change a merit. The terms of a quadratic function may cancel in f, but
  /// not in ∇f · x as well.
  double MeritRounding() const
  {
    return RelativeRounding *
      (std::abs(this->value) + std::abs(this->gradient.dot(Parts(this->x))));
  }
  /// Nᵀ N.
  Eigen::MatrixXd ProductsOfNormals() const
  {
    return Eigen::MatrixXd(Eigen::SparseMatrix<double>(this->normals.transpose() * this->normals));
  }
  /// λ that makes ∇f + Σ λ_i A_i x smallest.
  Eigen::VectorXd LeastSquaresMultipliers() const
  {
    return -SolveSmall(this->ProductsOfNormals(), this->normals.transpose() * this->gradient);
  }
  /// The shortest step that the linearised constraints ask for.
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
      const bool caught = critical || (this->Slow && this->Shift > 0.0);
      // Off a critical point it has to pay more than the steps that it takes the place of.
      if (caught && this->LeaveSaddle(critical ? NoticeableDescent : SlowDescent))
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
        break; // a saddle that is not left, or no step helps
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
  /// Relative residual of the optimality conditions.
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

  /// Factors with this shift; false where it is too small. `certain` as in Additions.
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

  /// Factors with the smallest shift, of those from this one on, that works.
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

  /// Along the motion that the functional knows, with the multipliers as they are.
  void RelaxHere()
  {
    ComplexVector relaxed = this->Functional.Relax(this->Here.x);
    if (relaxed != this->Here.x)
    {
      this->Here = LocalPoint(this->Functional, this->Constraints, std::move(relaxed));
      this->Residual = this->ResidualAt(this->Here, this->Multipliers);
    }
  }

  /// One step of the convexified quadratic problem; false when no length of it helps.
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
      const double wanted = merit + 1e-4 * length * slope;
      LocalPoint trial = this->At(length * direction);
      if (!this->Constraints.empty() && trial.Merit(this->Weight) > wanted)
      {
        // The constraints curve away from their tangents: one step back to them.
        trial = LocalPoint(this->Functional, this->Constraints, trial.x + trial.Restoration());
      }
      const double trialMerit = trial.Merit(this->Weight);
      const Eigen::VectorXd moved = this->Multipliers + length * (target - this->Multipliers);
      const double residual = this->ResidualAt(trial, moved);
      // Near the solution rounding hides the progress in the merit that the residual shows. Where it
      // does not, a smaller residual is no excuse: it leads to saddles and maxima as well.
      const bool falls = trialMerit <= wanted && trialMerit < merit;
      const bool settles =
        trialMerit <= merit + here.MeritRounding() && residual <= 0.5 * this->Residual;
      if (falls || settles)
      {
        // A full step says that the quadratic model holds: ask for less help next time.
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

  /// A step along the direction of least curvature; false when the merit does not fall along it by a
  /// given part of itself.
  ///
  /// Inverse iteration finds it, with the factor at hand, which costs nothing; and as its shift is hardly
  /// more than makes up for that curvature, others fade faster than with a larger one. Relative to the
  /// metric, or a small triangle would count as much as a large one.
  bool LeaveSaddle(double wantedDescent)
  {
    this->Slow = false;
    if (this->Metric.size() == 0)
    {
      return false;
    }
    Eigen::VectorXd direction(this->Metric.size());
    for (Eigen::Index i = 0; i < direction.size(); ++i)
    {
      direction[i] = std::sin(12.9898 * static_cast<double>(i + 1)); // no symmetry of any mesh
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
      if (trial.Merit(this->Weight) < merit - wantedDescent * std::abs(merit))
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
  double First; ///< Of the shifts.
  LocalPoint Here;
  Eigen::VectorXd Multipliers;
  double Residual;
  double Weight = 1.0;    ///< Of the violations in the merit.
  double Scale = 0.0;     ///< Weight of the normals in the last factorisation,
  double Shift = 0.0;     ///< and its shift.
  double NextShift = 0.0; ///< To begin with in the next step; below the first: none.
  bool Slow = false;      ///< The last step was convexified and lowered the merit by little.
};
}

MinimiserResult MinimiseConstrained(ConstrainedFunctional& functional,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  return Minimiser(functional, constraints, start, options).Run(progress);
}
}
