#include "OptimizerIteration.h"

#include "DenseSolvers.h"
#include "OptimizerCurvature.h"
#include "Plane.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// Change in radians over the diagonal of the domain below which a defect counts as unchangeable.
constexpr double MinimumInfluence = 1e-3;

double LargestEntry(const Eigen::VectorXd& values)
{
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

/// Criteria for a valley, as around the centre of a disk: derivatives, multiplied by the diagonal,
/// are below `gradient`, and the last ValleySteps steps lowered the objective by less than `gain` of
/// its value in total. Differences between meshes change W by more.
struct ValleyLimits
{
  double gradient;
  double gain;
};
constexpr ValleyLimits Free = { 1e-2, 1e-8 };
/// Where singularities are held by the clearance: two that attract each other turn around each other
/// along a circle, on which the curvatures of W and of the barrier cancel up to the error of the mesh.
constexpr ValleyLimits Held = { 0.1, 3e-5 };
constexpr std::size_t ValleySteps = 10;

bool IsInValley(
  const std::vector<OptimizerStep>& history, const ValleyLimits& limits, double tolerance)
{
  if (history.size() <= ValleySteps)
  {
    return false;
  }
  const OptimizerStep& latest = history.back();
  const OptimizerStep& before = history[history.size() - 1 - ValleySteps];
  return latest.gradientNorm <= limits.gradient && latest.holonomyDefect <= tolerance &&
    std::abs(before.objective - latest.objective) <=
    limits.gain * (1.0 + std::abs(latest.objective));
}

/// Number of steps after which the Hessian is not computed again: a run that takes this long follows a
/// valley, along which updates are more accurate.
constexpr int LastRenewal = 60;

/// Returns whether derivatives are so small that the error of the second derivatives, which are those
/// of a coarser approximation of W, would determine the steps in flat directions. Then the updates of
/// the Hessian must not be lost.
bool IsNearMinimum(const std::vector<OptimizerStep>& history)
{
  constexpr double SmallGradient = 0.02;
  return !history.empty() && history.back().gradientNorm < SmallGradient;
}

/// Returns the combinations of defects that the singularities can change, as orthonormal columns.
Eigen::MatrixXd ReachableDefects(const Eigen::MatrixXd& gradient)
{
  if (gradient.size() == 0)
  {
    return Eigen::MatrixXd::Zero(gradient.rows(), 0);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(gradient, Eigen::ComputeThinU);
  Eigen::Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()[rank] > MinimumInfluence)
  {
    ++rank;
  }
  return svd.matrixU().leftCols(rank);
}

/// Step and multipliers of the reachable defects from the quadratic model
///   [B Aᵀ; A 0] [p; λ] = −[g; c].
struct QuadraticStep
{
  Eigen::VectorXd step;
  Eigen::VectorXd defects;     ///< Reachable defects c.
  double portion = 1.0;        ///< Portion of the defects that the step removes.
  Eigen::MatrixXd reachable;   ///< See ReachableDefects.
  Eigen::VectorXd lagrangian;  ///< Gradient of the Lagrangian at the start of the step.
  Eigen::VectorXd multipliers; ///< Multipliers of all defects, U λ.
};

/// Solves the model with a given factor of B.
QuadraticStep SolveModelWith(const Eigen::LLT<Eigen::MatrixXd>& factor,
  const OptimizerState& current, const Eigen::MatrixXd& reachable, double portion)
{
  QuadraticStep result;
  result.reachable = reachable;
  result.portion = portion;
  result.defects = result.reachable.transpose() * current.defects;
  const Eigen::MatrixXd rows = result.reachable.transpose() * current.defectGradient;
  const Eigen::VectorXd gradient = current.ObjectiveGradient();
  const Eigen::VectorXd unconstrained = factor.solve(gradient);
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(rows.rows());
  if (rows.rows() > 0)
  {
    const Eigen::MatrixXd schur = rows * factor.solve(rows.transpose());
    multipliers = schur.ldlt().solve(portion * result.defects - rows * unconstrained);
  }
  result.lagrangian = gradient + rows.transpose() * multipliers;
  result.step = -factor.solve(result.lagrangian);
  result.multipliers = result.reachable * multipliers;
  return result;
}

/// Solves the model with bounded steps: multiples of diag(π / s_j²), s_j the clearances of the
/// singularities, are added to B until it is positive definite and at least half of the step is
/// allowed (OptimizerObjective::LargestFraction), or until this no longer shortens the step, because
/// the defects require its length. In these units, the curvature of W near a boundary is 1. Without
/// this, the one singularity that has the least space would shorten the moves of all others.
QuadraticStep SolveModel(const OptimizerObjective& objective, const Eigen::MatrixXd& hessian,
  const OptimizerState& current)
{
  constexpr double Undefined = std::numeric_limits<double>::quiet_NaN();
  constexpr double SufficientFraction = 0.5;
  constexpr double FirstShift = 1e-3;
  constexpr double LargestShift = 1e3;
  constexpr double ShiftGrowth = 4.0;
  Eigen::MatrixXd matrix = hessian + current.barrier.hessian + current.barrier.negativeHessian;
  const Eigen::MatrixXd reachable = ReachableDefects(current.defectGradient);
  const Eigen::VectorXd clearances = objective.Clearances(current.positions);
  const Eigen::ArrayXd scale = Pi / clearances.array().square();
  // Convexity is needed only along the defects' level sets: in the directions that change them, the
  // constraints determine the step.
  constexpr double NormalCurvature = 10.0;
  double portion = 1.0;
  const Eigen::MatrixXd rows = reachable.transpose() * current.defectGradient;
  Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(rows.rows(), rows.rows());
  if (rows.rows() > 0)
  {
    const Eigen::MatrixXd moves = scale.inverse().matrix().asDiagonal() * rows.transpose();
    const Eigen::MatrixXd inverse = (rows * moves).inverse();
    normal = NormalCurvature * inverse;
    matrix += rows.transpose() * (normal * rows);
    // Shifts do not shorten the part of the step that removes the defects.
    constexpr double MinimumPortion = 1.0 / 16.0;
    const Eigen::VectorXd removal = -moves * (inverse * (reachable.transpose() * current.defects));
    portion = std::max(MinimumPortion, objective.LargestFraction(current.positions, removal));
  }
  QuadraticStep model;
  model.portion = portion;
  model.reachable = reachable;
  model.step = Eigen::VectorXd::Constant(current.positions.size(), Undefined);
  double before = std::numeric_limits<double>::infinity();
  for (double shift = FirstShift; std::isfinite(shift); shift *= ShiftGrowth)
  {
    if (const Eigen::LLT<Eigen::MatrixXd> factor(matrix); factor.info() == Eigen::Success)
    {
      model = SolveModelWith(factor, current, reachable, portion);
      const double length = LargestEntry((model.step.array() / clearances.array()).matrix());
      if (objective.LargestFraction(current.positions, model.step) >= SufficientFraction ||
        length > 0.9 * before || shift > LargestShift)
      {
        break;
      }
      before = length;
    }
    matrix.diagonal().array() += shift * scale;
  }
  if (!model.step.allFinite())
  {
    return model;
  }
  model.multipliers -= reachable * (normal * (portion * model.defects));
  return model;
}

/// Updates the Hessian by the symmetric formula of rank one, which also approximates indefinite
/// matrices (Nocedal and Wright 2006). `change` is that of the gradient of the Lagrangian
/// without the barrier.
void UpdateHessian(
  Eigen::MatrixXd& hessian, const Eigen::VectorXd& step, const Eigen::VectorXd& change)
{
  constexpr double MinimumCosine = 1e-8; // below it, the formula is dominated by rounding
  const Eigen::VectorXd difference = change - hessian * step;
  const double product = difference.dot(step);
  if (std::abs(product) > MinimumCosine * step.norm() * difference.norm())
  {
    hessian += difference * difference.transpose() / product;
  }
}

/// Halves a step until the merit function, the objective + penalty × |reachable defects|, decreases
/// sufficiently. Returns whether such a step was found.
bool SearchLine(const OptimizerObjective& objective, const OptimizerState& current,
  const QuadraticStep& model, double penalty, OptimizerState& next)
{
  const double infeasibility = model.defects.norm();
  const double slope =
    current.ObjectiveGradient().dot(model.step) - penalty * model.portion * infeasibility;
  const double rounding = 1e-13 * (1.0 + std::abs(current.energy));
  constexpr int MaximumHalvings = 40; // smaller steps are below the rounding of the coordinates
  double fraction = objective.LargestFraction(current.positions, model.step);
  for (int halving = 0; halving < MaximumHalvings; ++halving, fraction *= 0.5)
  {
    const Eigen::VectorXd positions = current.positions + fraction * model.step;
    if (!std::isfinite(objective.EvaluateBarrier(positions).energy))
    {
      continue;
    }
    next = objective.Evaluate(positions);
    const double gain = current.Objective() - next.Objective() +
      penalty * (infeasibility - (model.reachable.transpose() * next.defects).norm());
    if (gain >= -1e-4 * fraction * slope - rounding)
    {
      return true;
    }
  }
  return false;
}
}

OptimizerEnd OptimizerIteration::Run(
  const OptimizerObjective& objective, const Progress& progress, OptimizerState& current)
{
  double penalty = 0.0;
  bool isNew = false;    // whether the Hessian was just computed
  bool isScaled = false; // whether it was replaced by a multiple of the identity after that
  for (;;)
  {
    if (current.positions.size() > 0 &&
      (this->Hessian.rows() != current.positions.size() ||
        (objective.Budget().GetSpent() >= this->Renewal && this->iterations < LastRenewal &&
          !IsNearMinimum(this->history))))
    {
      this->Hessian = objective.Hessian(current, EstimateMultipliers(current));
      this->Renewal = objective.Budget().GetSpent() + objective.HessianCost();
      isNew = true;
    }
    const QuadraticStep model = SolveModel(objective, this->Hessian, current);
    this->unreachableDefect = LargestEntry(current.defects - model.reachable * model.defects);
    const double residual = LargestEntry(model.lagrangian);
    const double defect = LargestEntry(model.defects);
    const OptimizerStep latest{ current.fullEnergy, current.energy, residual,
      LargestEntry(current.defects), this->LastDisplacement * objective.LengthUnit() };
    if (this->history.size() == static_cast<std::size_t>(this->iterations) + 1)
    {
      this->history.back() = latest; // the same positions on another mesh
    }
    else
    {
      this->history.push_back(latest);
    }
    if ((residual <= this->tolerance && defect <= this->tolerance) ||
      IsInValley(this->history, current.barrier.energy > 0.0 ? Held : Free, this->tolerance))
    {
      return OptimizerEnd::Converged;
    }
    if (this->stopsForChange && this->stopsForChange(current))
    {
      return OptimizerEnd::ChangeRequested;
    }
    if (this->checksMesh && objective.NeedsFinerMesh(current.positions))
    {
      return OptimizerEnd::MeshTooCoarse;
    }
    if (this->iterations == this->maximumIterations)
    {
      return OptimizerEnd::IterationLimit;
    }
    if (objective.Budget().IsSpent())
    {
      return OptimizerEnd::BudgetSpent;
    }
    try
    {
      progress.Report(static_cast<double>(this->iterations) / this->maximumIterations);
    }
    catch (const Aborted&)
    {
      return OptimizerEnd::Aborted;
    }

    // With this penalty every step of the model is a descent direction of the merit function.
    // The multipliers of shortened steps may be large; without them, the penalty decreases again.
    penalty = std::max(0.5 * penalty, 1.5 * model.multipliers.norm());
    OptimizerState next;
    // The updates may overflow where singularities are pressed together.
    if (!model.step.allFinite() || !SearchLine(objective, current, model, penalty, next))
    {
      if (isScaled)
      {
        return OptimizerEnd::NoDescent;
      }
      if (isNew)
      {
        // A first step of about a twentieth of the diagonal along the gradient.
        this->Hessian = std::max(20.0 * LargestEntry(current.gradient), 1.0) *
          Eigen::MatrixXd::Identity(current.positions.size(), current.positions.size());
        isScaled = true;
        continue;
      }
      this->Restart();
      continue;
    }
    const Eigen::VectorXd step = next.positions - current.positions;
    const Eigen::VectorXd change = next.gradient - current.gradient +
      (next.defectGradient - current.defectGradient).transpose() * model.multipliers;
    isNew = isScaled = false;
    UpdateHessian(this->Hessian, step, change);
    current = next;
    this->LastDisplacement = LargestDisplacement(step);
    ++this->iterations;
  }
}
}
