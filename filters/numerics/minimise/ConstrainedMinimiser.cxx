#include "ConstrainedMinimiser.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// The shifts, relative to M, that are tried: the first one, and how they grow. Where a
/// factorisation is dear, but a step that is damped too much dearer, as in GinzburgLandau.cxx.
struct Shifts
{
  double first;
  double growth;
};
constexpr Shifts DenseShifts = { 0.125, 2.0 };
constexpr Shifts SparseShifts = { 1.0 / 64.0, 4.0 };

/// Weighting the normals this heavily, relative to the stiffness, leaves the sign of a quadratic form
/// on their complement to decide whether it is positive definite.
constexpr double NormalWeight = 1e4;

/// As in GinzburgLandau.cxx: convexified steps that lower the merit by less are caught at a saddle.
constexpr double SlowDescent = 1e-4;

/// Merits that differ by less, relatively, may differ by what is left of the residual.
constexpr double NoticeableDescent = 1e-9;

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
  Eigen::MatrixXd normals;    ///< Column i is A_i x.
  Eigen::VectorXd violations; ///< c_i.
  double value = 0.0;

  LocalPoint(const ConstrainedFunctional& functional,
    const std::vector<QuadraticConstraint>& constraints, ComplexVector at)
    : x(std::move(at))
    , gradient(functional.Gradient(this->x))
    , value(functional.Value(this->x))
  {
    const auto count = static_cast<Eigen::Index>(constraints.size());
    this->normals.resize(2 * this->x.size(), count);
    this->violations.resize(count);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      const QuadraticConstraint& constraint = constraints[static_cast<std::size_t>(i)];
      this->normals.col(i) = constraint.Gradient(this->x);
      this->violations[i] = constraint.Value(this->x) - constraint.target;
    }
  }

  /// `weight` above every |λ_i| makes a solution of the problem a minimum of this.
  double Merit(double weight) const { return this->value + weight * this->violations.lpNorm<1>(); }
  /// λ that makes ∇f + Σ λ_i A_i x smallest.
  Eigen::VectorXd LeastSquaresMultipliers() const
  {
    return -SolveSmall(
      this->normals.transpose() * this->normals, this->normals.transpose() * this->gradient);
  }
  /// The shortest step that the linearised constraints ask for.
  ComplexVector Restoration() const
  {
    return FromParts(
      -this->normals * SolveSmall(this->normals.transpose() * this->normals, this->violations));
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
    , Here(functional, constraints, start)
    , Multipliers(this->Here.LeastSquaresMultipliers())
    , Residual(this->ResidualAt(this->Here, this->Multipliers))
  {
  }

  MinimiserResult Run(const Progress& progress)
  {
    MinimiserResult result;
    bool moved = true;
    bool slow = false;
    while (moved && result.iterations < this->Options.maximumIterations)
    {
      progress.Report(static_cast<double>(result.iterations) / this->Options.maximumIterations);
      const bool critical = this->Residual <= this->Options.tolerance;
      this->FactorConvexified(critical);
      if (critical && this->Shift == 0.0)
      {
        result.converged = true;
        break;
      }
      const double before = this->Here.Merit(this->Weight);
      // Off a critical point it has to pay more than the steps that it takes the place of.
      const bool leaves = this->Options.leavesSaddles && (critical || slow) &&
        this->LeaveSaddle(critical ? NoticeableDescent : SlowDescent);
      if (critical && !leaves)
      {
        break; // a saddle
      }
      slow = false;
      if (!leaves)
      {
        moved = this->Step();
        slow = this->Shift > 0.0 &&
          before - this->Here.Merit(this->Weight) < SlowDescent * std::abs(before);
      }
      ++result.iterations;
    }
    if (!result.converged && this->Residual <= this->Options.tolerance)
    {
      this->FactorConvexified(true);
      result.converged = this->Shift == 0.0;
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

  /// Factors with the smallest shift that works; Σ λ_i A_i is bounded, so there is one.
  void FactorConvexified(bool fromZero)
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
    additions.normals = this->Here.normals;
    additions.weight = NormalWeight * this->Functional.Stiffness();
    const Shifts& shifts = this->Options.leavesSaddles ? SparseShifts : DenseShifts;
    const bool remember = this->Options.leavesSaddles && !fromZero;
    additions.shift = remember && this->NextShift >= shifts.first ? this->NextShift : 0.0;
    while (!this->Functional.Factor(this->Here.x, additions))
    {
      additions.shift = additions.shift == 0.0 ? shifts.first : shifts.growth * additions.shift;
    }
    this->Shift = additions.shift;
    this->Scale = additions.weight;
  }

  /// One step of the convexified quadratic problem; false when no length of it helps.
  bool Step()
  {
    const LocalPoint& here = this->Here;
    // There may be no constraints, and not every solver takes no right-hand sides.
    const Eigen::MatrixXd fromNormals =
      here.normals.cols() == 0 ? here.normals : this->Functional.Solve(here.normals);
    const Eigen::VectorXd fromGradient = this->Functional.Solve(here.gradient);
    const Eigen::VectorXd plain = SolveSmall(here.normals.transpose() * fromNormals,
      here.violations - here.normals.transpose() * fromGradient);
    const Eigen::VectorXd direction = -fromGradient - fromNormals * plain;
    // The weight on the normals shifts the multipliers by weight × Nᵀ δx = −weight × c.
    const Eigen::VectorXd target = plain - this->Scale * here.violations;
    this->Weight = std::max(1.0, target.size() > 0 ? 2.0 * target.lpNorm<Eigen::Infinity>() : 0.0);
    const double slope = here.gradient.dot(direction) - this->Weight * here.violations.lpNorm<1>();
    const double merit = here.Merit(this->Weight);
    for (double length = 1.0; length > 1e-10; length *= 0.5)
    {
      const double wanted = merit + 1e-4 * length * slope;
      LocalPoint trial = this->At(length * direction);
      if (trial.Merit(this->Weight) > wanted)
      {
        // The constraints curve away from their tangents: one step back to them.
        trial = LocalPoint(this->Functional, this->Constraints, trial.x + trial.Restoration());
      }
      const Eigen::VectorXd moved = this->Multipliers + length * (target - this->Multipliers);
      const double residual = this->ResidualAt(trial, moved);
      // Near the solution the merit no longer resolves the progress that the residual shows.
      if (trial.Merit(this->Weight) <= wanted || residual <= 0.5 * this->Residual)
      {
        this->NextShift = length == 1.0 ? 0.25 * this->Shift : this->Shift;
        this->Here = std::move(trial);
        this->Multipliers = moved;
        this->Residual = residual;
        return true;
      }
    }
    return false;
  }

  /// A step along the direction of least curvature, which inverse iteration with the factor at hand
  /// finds; false when the merit does not fall along it by a given part of itself.
  bool LeaveSaddle(double wantedDescent)
  {
    Eigen::VectorXd direction(2 * this->Here.x.size());
    for (Eigen::Index i = 0; i < direction.size(); ++i)
    {
      direction[i] = std::sin(12.9898 * static_cast<double>(i + 1)); // no symmetry of any mesh
    }
    for (int round = 0; round < 30; ++round)
    {
      direction = this->Functional.Solve(direction);
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
  LocalPoint Here;
  Eigen::VectorXd Multipliers;
  double Residual;
  double Weight = 1.0;    ///< Of the violations in the merit.
  double Scale = 0.0;     ///< Weight of the normals in the last factorisation,
  double Shift = 0.0;     ///< and its shift.
  double NextShift = 0.0; ///< To begin with in the next step.
};
}

MinimiserResult MinimiseConstrained(ConstrainedFunctional& functional,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options, const Progress& progress)
{
  return Minimiser(functional, constraints, start, options).Run(progress);
}
}
