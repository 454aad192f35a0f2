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
/// A defect that changes by less than this, in radians, when a singularity crosses the whole domain
/// cannot be changed.
constexpr double LeastInfluence = 1e-3;

double LargestEntry(const Eigen::VectorXd& values)
{
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

/// A valley, as around the centre of a disk: derivatives below the first, times the diagonal, and so many
/// steps that lower the energy by less than 1e-8 of it. Meshes change W by more.
constexpr double ValleyGradient = 1e-2;
constexpr std::size_t ValleySteps = 10;
constexpr double ValleyGain = 1e-8;

bool IsValley(const std::vector<OptimizerStep>& history, double tolerance)
{
  if (history.size() <= ValleySteps)
  {
    return false;
  }
  const OptimizerStep& now = history.back();
  const OptimizerStep& before = history[history.size() - 1 - ValleySteps];
  return now.gradientNorm <= ValleyGradient && now.holonomyDefect <= tolerance &&
    std::abs(before.objective - now.objective) <= ValleyGain * (1.0 + std::abs(now.objective));
}

/// The combinations of defects that the singularities can change: orthonormal columns.
Eigen::MatrixXd ReachableDefects(const Eigen::MatrixXd& gradient)
{
  if (gradient.size() == 0)
  {
    return Eigen::MatrixXd::Zero(gradient.rows(), 0);
  }
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(gradient, Eigen::ComputeThinU);
  Eigen::Index rank = 0;
  while (rank < svd.singularValues().size() && svd.singularValues()[rank] > LeastInfluence)
  {
    ++rank;
  }
  return svd.matrixU().leftCols(rank);
}

/// A step and the multipliers of the reachable defects from the quadratic model,
/// [B Aᵀ; A 0] [p; λ] = −[g; c].
struct QuadraticStep
{
  Eigen::VectorXd step;
  Eigen::VectorXd defects;    ///< The reachable ones, c.
  Eigen::MatrixXd reachable;  ///< See ReachableDefects.
  Eigen::VectorXd lagrangian; ///< Its derivatives at the start of the step.
  Eigen::VectorXd pull;       ///< Aᵀ of the multipliers, for the curvature, in all defects: U λ.
};

/// The factor of a matrix, with as much added to its diagonal as makes it positive definite.
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

/// The model with a matrix for B.
QuadraticStep SolveModelWith(const Eigen::MatrixXd& matrix, const OptimizerPlace& here)
{
  QuadraticStep result;
  result.reachable = ReachableDefects(here.defectGradient);
  result.defects = result.reachable.transpose() * here.defects;
  const Eigen::MatrixXd rows = result.reachable.transpose() * here.defectGradient;
  const Eigen::VectorXd gradient = here.ObjectiveGradient();
  const Eigen::LLT<Eigen::MatrixXd> factor = FactorShifted(matrix);
  const Eigen::VectorXd free = factor.solve(gradient);
  Eigen::VectorXd multipliers = Eigen::VectorXd::Zero(rows.rows());
  if (rows.rows() > 0)
  {
    const Eigen::MatrixXd schur = rows * factor.solve(rows.transpose());
    multipliers = schur.ldlt().solve(result.defects - rows * free);
  }
  result.lagrangian = gradient + rows.transpose() * multipliers;
  result.step = -factor.solve(result.lagrangian);
  result.pull = result.reachable * multipliers;
  return result;
}

/// Along a valley, as by rotation of a disk, the curvature by differences is zero but for rounding, and the step
/// without end. So B gets more on its diagonal until no step is longer than a hundred diagonals of the
/// domain, or it is the defects that ask for it: what is shorter is a direction, which the boundary cuts off.
QuadraticStep SolveModel(const Eigen::MatrixXd& hessian, const OptimizerPlace& here)
{
  constexpr double Longest = 100.0;
  Eigen::MatrixXd matrix = hessian + here.barrier.hessian;
  double shift = 1e-6 * LargestEntry(matrix.diagonal());
  QuadraticStep model = SolveModelWith(matrix, here);
  for (double before = std::numeric_limits<double>::infinity();
       LargestEntry(model.step) > Longest && LargestEntry(model.step) < 0.9 * before; shift *= 4.0)
  {
    before = LargestEntry(model.step);
    matrix.diagonal().array() += shift;
    model = SolveModelWith(matrix, here);
  }
  return model;
}

/// The matrix with the absolute values of its eigenvalues: a step leaves a saddle along the directions in which it falls as
/// fast as it comes to rest along the others, and the updates go on, which need a positive definite one.
Eigen::MatrixXd WithoutSaddle(const Eigen::MatrixXd& hessian)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes(hessian);
  return modes.eigenvectors() * modes.eigenvalues().cwiseAbs().asDiagonal() *
    modes.eigenvectors().transpose();
}

/// Damped BFGS update (Powell 1978): stays positive definite where the Lagrangian is not convex.
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

/// Halves a step until the merit, the objective + penalty × |reachable defects|, falls as it should.
bool Search(const OptimizerObjective& objective, const OptimizerPlace& here,
  const QuadraticStep& model, double penalty, OptimizerPlace& next)
{
  const double infeasibility = model.defects.norm();
  const double slope = here.ObjectiveGradient().dot(model.step) - penalty * infeasibility;
  const double rounding = 1e-13 * (1.0 + std::abs(here.energy));
  constexpr int MostHalvings = 40; // then the step is lost in the rounding of the places
  double part = objective.LongestPart(here.place, model.step);
  for (int halving = 0; halving < MostHalvings; ++halving, part *= 0.5)
  {
    const Eigen::VectorXd place = here.place + part * model.step;
    if (!std::isfinite(objective.EvaluateBarrier(place).energy))
    {
      continue;
    }
    next = objective.Evaluate(place);
    const double gain = here.Objective() - next.Objective() +
      penalty * (infeasibility - (model.reachable.transpose() * next.defects).norm());
    if (gain >= -1e-4 * part * slope - rounding)
    {
      return true;
    }
  }
  return false;
}
}

OptimizerEnd OptimizerIteration::Run(
  const OptimizerObjective& objective, const Progress& progress, OptimizerPlace& here)
{
  double penalty = 0.0;
  bool fresh = false; // whether the curvature was just forgotten
  int shortSteps = 0; // that followed each other
  for (;;)
  {
    if (this->Hessian.rows() != here.place.size())
    {
      // A first step of about a twentieth of the diagonal; the updates find the curvature.
      this->Hessian = std::max(20.0 * LargestEntry(here.gradient), 1.0) *
        Eigen::MatrixXd::Identity(here.place.size(), here.place.size());
      fresh = true;
    }
    const QuadraticStep model = SolveModel(this->Hessian, here);
    this->unreachableDefect = LargestEntry(here.defects - model.reachable * model.defects);
    const double residual = LargestEntry(model.lagrangian);
    const double defect = LargestEntry(model.defects);
    const OptimizerStep now{ here.fullEnergy, here.energy, residual, LargestEntry(here.defects),
      this->Moved * objective.Unit() };
    if (this->history.size() == static_cast<std::size_t>(this->iterations) + 1)
    {
      this->history.back() = now; // the same place on another mesh
    }
    else
    {
      this->history.push_back(now);
    }
    if ((residual <= this->tolerance && defect <= this->tolerance) ||
      IsValley(this->history, this->tolerance))
    {
      return OptimizerEnd::Rest;
    }
    if (this->changes && this->changes(here))
    {
      return OptimizerEnd::Change;
    }
    if (this->watchesMesh && objective.OutgrowsMesh(here.place))
    {
      return OptimizerEnd::Mesh;
    }
    if (this->iterations == this->maximumIterations)
    {
      return OptimizerEnd::Limit;
    }
    try
    {
      progress.Report(static_cast<double>(this->iterations) / this->maximumIterations);
    }
    catch (const Aborted&)
    {
      return OptimizerEnd::Aborted;
    }

    // The penalty makes every step of the model one that lowers the merit.
    penalty = std::max(penalty, 1.5 * model.pull.norm());
    OptimizerPlace next;
    if (!Search(objective, here, model, penalty, next))
    {
      if (fresh)
      {
        return OptimizerEnd::Stuck;
      }
      this->Restart();
      continue;
    }
    const Eigen::VectorXd step = next.place - here.place;
    const Eigen::VectorXd change = next.gradient - here.gradient +
      (next.defectGradient - here.defectGradient).transpose() * model.pull +
      next.barrier.bend * step;
    if (fresh && step.dot(change) > 0.0)
    {
      this->Hessian = (change.squaredNorm() / step.dot(change)) *
        Eigen::MatrixXd::Identity(step.size(), step.size());
    }
    fresh = false;
    UpdateHessian(this->Hessian, step, change);
    here = next;
    this->Moved = LongestMove(step);
    ++this->iterations;
    // Held by barriers that bend, updates may learn a curvature that is none: steps become short.
    constexpr int MostShortSteps = 5;
    constexpr double Short = 0.01;               // of the clearance
    constexpr Eigen::Index MostCoordinates = 60; // more would take longer than going on
    shortSteps = this->Moved < Short * objective.Clearance() ? shortSteps + 1 : 0;
    if (shortSteps == MostShortSteps && here.place.size() <= MostCoordinates)
    {
      this->Hessian = WithoutSaddle(DifferenceHessian(objective, here, model.pull));
      shortSteps = 0;
    }
  }
}
}
