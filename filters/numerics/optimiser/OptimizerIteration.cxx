#include "OptimizerIteration.h"

#include "OptimizerCurvature.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

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
/// are below ValleyGradient, and the last ValleySteps steps lowered the objective by less than
/// ValleyGain of its value in total. Differences between meshes change W by more.
constexpr double ValleyGradient = 1e-2;
constexpr std::size_t ValleySteps = 10;
constexpr double ValleyGain = 1e-8;

bool IsInValley(const std::vector<OptimizerStep>& history, double tolerance)
{
  if (history.size() <= ValleySteps)
  {
    return false;
  }
  const OptimizerStep& latest = history.back();
  const OptimizerStep& before = history[history.size() - 1 - ValleySteps];
  return latest.gradientNorm <= ValleyGradient && latest.holonomyDefect <= tolerance &&
    std::abs(before.objective - latest.objective) <=
    ValleyGain * (1.0 + std::abs(latest.objective));
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
  Eigen::MatrixXd reachable;   ///< See ReachableDefects.
  Eigen::VectorXd lagrangian;  ///< Gradient of the Lagrangian at the start of the step.
  Eigen::VectorXd multipliers; ///< Multipliers of all defects, U λ.
};

/// Factors a matrix, after adding multiples of the identity until it is positive definite.
Eigen::LLT<Eigen::MatrixXd> FactorShifted(Eigen::MatrixXd matrix)
{
  Eigen::LLT<Eigen::MatrixXd> factor(matrix);
  double shift = 1e-3 * LargestEntry(matrix.diagonal());
  while (factor.info() != Eigen::Success && std::isfinite(shift))
  {
    matrix.diagonal().array() += shift;
    shift *= 4.0;
    factor.compute(matrix);
  }
  return factor;
}

/// Solves the model with a given matrix B.
QuadraticStep SolveModelWith(
  const Eigen::MatrixXd& matrix, const OptimizerState& current, const Eigen::MatrixXd& reachable)
{
  QuadraticStep result;
  result.reachable = reachable;
  result.defects = result.reachable.transpose() * current.defects;
  const Eigen::MatrixXd rows = result.reachable.transpose() * current.defectGradient;
  const Eigen::VectorXd gradient = current.ObjectiveGradient();
  const Eigen::LLT<Eigen::MatrixXd> factor = FactorShifted(matrix);
  const Eigen::VectorXd unconstrained = factor.solve(gradient);
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(rows.rows());
  if (rows.rows() > 0)
  {
    const Eigen::MatrixXd schur = rows * factor.solve(rows.transpose());
    multipliers = schur.ldlt().solve(result.defects - rows * unconstrained);
  }
  result.lagrangian = gradient + rows.transpose() * multipliers;
  result.step = -factor.solve(result.lagrangian);
  result.multipliers = result.reachable * multipliers;
  return result;
}

/// Solves the model with bounded steps. Along a valley, as by rotation of a disk, the curvature by
/// differences is zero up to rounding, and the step is unbounded. Multiples of the identity are
/// added to B until no step is longer than a hundred diagonals of the domain, or until this no
/// longer shortens the step, because the defects require its length. Shorter steps are still useful
/// as directions, which the boundary cuts off.
QuadraticStep SolveModel(const Eigen::MatrixXd& hessian, const OptimizerState& current)
{
  constexpr double MaximumStep = 100.0;
  Eigen::MatrixXd matrix = hessian + current.barrier.hessian;
  double shift = 1e-6 * LargestEntry(matrix.diagonal());
  const Eigen::MatrixXd reachable = ReachableDefects(current.defectGradient);
  QuadraticStep model = SolveModelWith(matrix, current, reachable);
  for (double before = std::numeric_limits<double>::infinity();
       LargestEntry(model.step) > MaximumStep && LargestEntry(model.step) < 0.9 * before;
       shift *= 4.0)
  {
    before = LargestEntry(model.step);
    matrix.diagonal().array() += shift;
    model = SolveModelWith(matrix, current, reachable);
  }
  return model;
}

/// Returns the matrix with the absolute values of its eigenvalues. A step then leaves a saddle
/// along descent directions as fast as it converges along the others, and the matrix is positive
/// definite, as the updates require.
Eigen::MatrixXd WithAbsoluteEigenvalues(const Eigen::MatrixXd& hessian)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(hessian);
  return modes.eigenvectors() * modes.eigenvalues().cwiseAbs().asDiagonal() *
    modes.eigenvectors().transpose();
}

/// Updates the Hessian by the damped BFGS formula (Powell 1978), which keeps it positive definite
/// where the Lagrangian is not convex.
void UpdateHessian(Eigen::MatrixXd& hessian, const Eigen::VectorXd& step, Eigen::VectorXd change)
{
  const Eigen::VectorXd product = hessian * step;
  const double curvature = step.dot(product);
  if (!(curvature > 0.0))
  {
    return;
  }
  if (step.dot(change) < 0.2 * curvature)
  {
    const double theta = 0.8 * curvature / (curvature - step.dot(change));
    change = theta * change + (1.0 - theta) * product;
  }
  hessian +=
    change * change.transpose() / step.dot(change) - product * product.transpose() / curvature;
}

/// Halves a step until the merit function, the objective + penalty × |reachable defects|, decreases
/// sufficiently. Returns whether such a step was found.
bool SearchLine(const OptimizerObjective& objective, const OptimizerState& current,
  const QuadraticStep& model, double penalty, OptimizerState& next)
{
  const double infeasibility = model.defects.norm();
  const double slope = current.ObjectiveGradient().dot(model.step) - penalty * infeasibility;
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
  bool isReset = false; // whether the Hessian was just reset
  int shortSteps = 0;   // in succession
  for (;;)
  {
    if (this->Hessian.rows() != current.positions.size())
    {
      // The first step has a length of about a twentieth of the diagonal; the updates determine the
      // curvature.
      this->Hessian = std::max(20.0 * LargestEntry(current.gradient), 1.0) *
        Eigen::MatrixXd::Identity(current.positions.size(), current.positions.size());
      isReset = true;
    }
    const QuadraticStep model = SolveModel(this->Hessian, current);
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
      IsInValley(this->history, this->tolerance))
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
    penalty = std::max(penalty, 1.5 * model.multipliers.norm());
    OptimizerState next;
    // The updates may overflow where singularities are pressed together.
    if (!model.step.allFinite() || !SearchLine(objective, current, model, penalty, next))
    {
      if (isReset)
      {
        return OptimizerEnd::NoDescent;
      }
      this->Restart();
      continue;
    }
    const Eigen::VectorXd step = next.positions - current.positions;
    const Eigen::VectorXd change = next.gradient - current.gradient +
      (next.defectGradient - current.defectGradient).transpose() * model.multipliers +
      next.barrier.negativeHessian * step;
    if (isReset && step.dot(change) > 0.0)
    {
      this->Hessian = (change.squaredNorm() / step.dot(change)) *
        Eigen::MatrixXd::Identity(step.size(), step.size());
    }
    isReset = false;
    UpdateHessian(this->Hessian, step, change);
    current = next;
    this->LastDisplacement = LargestDisplacement(step);
    ++this->iterations;
    // Where the barrier is strongly curved, the updates may accumulate wrong curvature, and steps
    // become short.
    constexpr int MaximumShortSteps = 5;
    constexpr double ShortStep = 0.01; // relative to the clearance
    // With more coordinates, differences cost more than further iterations.
    constexpr Eigen::Index MaximumCoordinates = 60;
    shortSteps = this->LastDisplacement < ShortStep * objective.Clearance() ? shortSteps + 1 : 0;
    if (shortSteps == MaximumShortSteps && current.positions.size() <= MaximumCoordinates)
    {
      this->Hessian =
        WithAbsoluteEigenvalues(DifferenceHessian(objective, current, model.multipliers));
      shortSteps = 0;
    }
  }
}
}
