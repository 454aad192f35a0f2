#include "SingularityOptimizer.h"

#include "BoundarySingularities.h"
#include "ConfigurationPlacement.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "RenormalizedEnergy.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// W, the defects and their derivatives at one place; lengths in units of the domain's diagonal.
struct Evaluation
{
  Eigen::VectorXd place;
  double energy = 0.0;     ///< Single-valued W.
  double fullEnergy = 0.0; ///< With the harmonic field of the defects.
  Eigen::VectorXd gradient;
  Eigen::VectorXd defects;
  Eigen::MatrixXd defectGradient; ///< One row per defect.
};

class Objective
{
public:
  Objective(const PointPotential& potential, const Configuration& configuration)
    : Potential(potential)
    , Start(configuration)
    , Unit(potential.GetDomain().Diagonal())
  {
  }

  Configuration At(const Eigen::VectorXd& place) const
  {
    Configuration moved = this->Start;
    for (std::size_t i = 0; i < moved.size(); ++i)
    {
      moved[i].position = this->Unit * place.segment<2>(2 * static_cast<Eigen::Index>(i));
    }
    return moved;
  }

  Eigen::VectorXd StartPlace() const
  {
    Eigen::VectorXd place(2 * static_cast<Eigen::Index>(this->Start.size()));
    for (std::size_t i = 0; i < this->Start.size(); ++i)
    {
      place.segment<2>(2 * static_cast<Eigen::Index>(i)) = this->Start[i].position / this->Unit;
    }
    return place;
  }

  Evaluation Evaluate(const Eigen::VectorXd& place) const
  {
    const RenormalizedEnergyValue value =
      EvaluateRenormalizedEnergy(this->Potential, this->Potential.Solve(this->At(place)));
    Evaluation result;
    result.place = place;
    result.energy = value.singleValuedEnergy;
    result.fullEnergy = value.energy;
    result.gradient = this->Unit *
      Eigen::Map<const Eigen::VectorXd>(value.singleValuedGradient.data(), place.size());
    const auto defects = static_cast<Eigen::Index>(value.holonomyDefect.size());
    result.defects.resize(defects);
    result.defectGradient.resize(defects, place.size());
    for (Eigen::Index k = 0; k < defects; ++k)
    {
      const auto& derivative = value.defectGradient[static_cast<std::size_t>(k)];
      result.defects[k] = value.holonomyDefect[static_cast<std::size_t>(k)];
      result.defectGradient.row(k) =
        this->Unit * Eigen::Map<const Eigen::RowVectorXd>(derivative.data(), place.size());
    }
    return result;
  }

  /// Distance of a singularity to the boundary, in units of the diagonal.
  double Clearance(const Eigen::VectorXd& place, std::size_t i) const
  {
    const Point here = place.segment<2>(2 * static_cast<Eigen::Index>(i));
    return SignedDistance(this->Unit * here, this->Potential.GetDomain()) / this->Unit;
  }

  /// The part of a step that moves no singularity farther than half of the way to the boundary or to
  /// another one.
  double LongestPart(const Eigen::VectorXd& place, const Eigen::VectorXd& step) const
  {
    double part = 1.0;
    for (std::size_t i = 0; i < this->Start.size(); ++i)
    {
      double room = this->Clearance(place, i);
      for (std::size_t j = 0; j < this->Start.size(); ++j)
      {
        room = j == i ? room
                      : std::min(room,
                          (place.segment<2>(2 * static_cast<Eigen::Index>(j)) -
                            place.segment<2>(2 * static_cast<Eigen::Index>(i)))
                            .norm());
      }
      const double length = step.segment<2>(2 * static_cast<Eigen::Index>(i)).norm();
      part = std::min(part, 0.5 * room / std::max(length, 1e-300));
    }
    return part;
  }

  /// Number of the first singularity that is nearer to the boundary than it was and than allowed;
  /// −1 if there is none.
  int TooNear(const Eigen::VectorXd& from, const Eigen::VectorXd& to, double nearest) const
  {
    for (std::size_t i = 0; i < this->Start.size(); ++i)
    {
      const double clearance = this->Clearance(to, i);
      if (clearance < nearest && clearance < this->Clearance(from, i))
      {
        return static_cast<int>(i);
      }
    }
    return -1;
  }

  double GetUnit() const { return this->Unit; }
  const PlanarDomain& GetDomain() const { return this->Potential.GetDomain(); }

private:
  const PointPotential& Potential;
  Configuration Start;
  double Unit;
};

/// A step and the multipliers from the quadratic model, [B Aᵀ; A 0] [p; λ] = −[g; c].
struct QuadraticStep
{
  Eigen::VectorXd step;
  Eigen::VectorXd multipliers;
};

QuadraticStep SolveModel(const Eigen::MatrixXd& hessian, const Evaluation& here)
{
  const Eigen::Index n = here.place.size();
  const Eigen::Index m = here.defects.size();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n + m, n + m);
  matrix.topLeftCorner(n, n) = hessian;
  matrix.bottomLeftCorner(m, n) = here.defectGradient;
  matrix.topRightCorner(n, m) = here.defectGradient.transpose();
  Eigen::VectorXd right(n + m);
  right << -here.gradient, -here.defects;
  if (right.size() == 0)
  {
    return { right, right }; // Eigen does not factor an empty matrix
  }
  // Rank-revealing: no step can repair a defect that no singularity changes.
  const Eigen::VectorXd solution = matrix.fullPivLu().solve(right);
  return { solution.head(n), solution.tail(m) };
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

double LongestMove(const Eigen::VectorXd& step)
{
  double longest = 0.0;
  for (Eigen::Index i = 0; i < step.size(); i += 2)
  {
    longest = std::max(longest, step.segment<2>(i).norm());
  }
  return longest;
}

double LargestEntry(const Eigen::VectorXd& values)
{
  return values.size() == 0 ? 0.0 : values.cwiseAbs().maxCoeff();
}

/// The iteration; `result` gets everything but the configuration. `nearest`, in units of the diagonal:
/// the least distance to the boundary, and that at which opposite signs meet.
Evaluation Iterate(const Objective& objective, const OptimizerOptions& options, double nearest,
  const Progress& progress, OptimizerResult& result)
{
  Evaluation here = objective.Evaluate(objective.StartPlace());
  result.energyBefore = here.fullEnergy;
  Eigen::MatrixXd hessian;
  double moved = 0.0;
  double penalty = 0.0;
  for (;;)
  {
    if (hessian.size() == 0)
    {
      // A first step of about a twentieth of the diagonal; the updates find the curvature.
      hessian = std::max(20.0 * LargestEntry(here.gradient), 1.0) *
        Eigen::MatrixXd::Identity(here.place.size(), here.place.size());
    }
    const QuadraticStep model = SolveModel(hessian, here);
    const Eigen::VectorXd lagrangian =
      here.gradient + here.defectGradient.transpose() * model.multipliers;
    result.history.push_back({ here.fullEnergy, LargestEntry(lagrangian),
      LargestEntry(here.defects), moved * objective.GetUnit() });
    if (LargestEntry(lagrangian) <= options.tolerance &&
      LargestEntry(here.defects) <= options.tolerance)
    {
      result.converged = true;
      result.reason = "The singularities are at a stationary point of the renormalised energy.";
      return here;
    }
    if (result.iterations == options.maximumIterations)
    {
      result.reason = "The iteration stopped after " + std::to_string(result.iterations) +
        " steps before the singularities came to rest; allow more steps.";
      return here;
    }
    try
    {
      progress.Report(
        0.2 + 0.8 * static_cast<double>(result.iterations) / options.maximumIterations);
    }
    catch (const Aborted&)
    {
      result.aborted = true;
      result.reason = "The iteration was aborted; this is the best configuration so far.";
      return here;
    }

    // Line search on the exact penalty function.
    penalty = std::max(penalty, 1.5 * LargestEntry(model.multipliers));
    const double infeasibility = here.defects.lpNorm<1>();
    const double slope = here.gradient.dot(model.step) - penalty * infeasibility;
    double part = objective.LongestPart(here.place, model.step);
    bool accepted = false;
    int blocking = -1;
    int blocked = -1;
    Evaluation next;
    constexpr int MostHalvings = 40; // then the step is lost in the rounding of the places
    for (int halving = 0; halving < MostHalvings && !accepted; ++halving, part *= 0.5)
    {
      const Eigen::VectorXd place = here.place + part * model.step;
      blocking = objective.TooNear(here.place, place, nearest);
      if (blocking >= 0)
      {
        blocked = blocking;
        continue;
      }
      next = objective.Evaluate(place);
      const double gain =
        here.energy + penalty * infeasibility - next.energy - penalty * next.defects.lpNorm<1>();
      const double rounding = 1e-13 * (1.0 + std::abs(here.energy));
      accepted = gain >= -1e-4 * part * slope - rounding;
    }
    // Pressed against the boundary: the step was cut to less than a hundredth of the distance to it.
    if (blocked >= 0 && (!accepted || LongestMove(next.place - here.place) < 0.01 * nearest))
    {
      const Point place = objective.At(here.place)[static_cast<std::size_t>(blocked)].position;
      result.reason = "Singularity " + std::to_string(blocked) +
        " has come nearer to the boundary at " + Describe(place) +
        " than the mesh resolves; make it a singularity of the boundary or refine the mesh.";
      return here;
    }
    if (!accepted)
    {
      result.reason = "No step lowers the renormalised energy any more, though its derivatives are "
                      "not zero; choose a larger tolerance or a finer mesh.";
      return here;
    }
    const Eigen::VectorXd step = next.place - here.place;
    const Eigen::VectorXd change = next.gradient - here.gradient +
      (next.defectGradient - here.defectGradient).transpose() * model.multipliers;
    if (result.iterations == 0 && step.dot(change) > 0.0)
    {
      hessian = (change.squaredNorm() / step.dot(change)) *
        Eigen::MatrixXd::Identity(step.size(), step.size());
    }
    UpdateHessian(hessian, step, change);
    here = next;
    moved = LongestMove(step);
    ++result.iterations;

    const Configuration configuration = objective.At(here.place);
    for (std::size_t i = 0; i < configuration.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        if ((configuration[i].position - configuration[j].position).norm() <
            nearest * objective.GetUnit() &&
          configuration[i].quarterIndex * configuration[j].quarterIndex < 0)
        {
          result.annihilations.push_back({ static_cast<int>(j), static_cast<int>(i) });
          result.reason = "Singularities " + std::to_string(j) + " and " + std::to_string(i) +
            " of opposite sign have met at " + Describe(configuration[i].position) +
            "; replace them by one with the sum of their quarter indices, or by none.";
        }
      }
    }
    if (!result.reason.empty())
    {
      result.history.push_back({ here.fullEnergy, LargestEntry(here.gradient),
        LargestEntry(here.defects), moved * objective.GetUnit() });
      return here;
    }
  }
}
}

OptimizerResult OptimizeSingularities(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options, const Progress& progress)
{
  DrillOptions drill;
  drill.meshSize = options.meshSize;
  const PlanarDomain refined = InsertBoundarySingularities(domain, start);
  const SharedTopology topology =
    ShareTopology(DrillHoles(refined, {}, drill, progress.Part(0.0, 0.1)));
  const PlacedConfiguration placed = PlaceConfiguration(*topology, start, options.corners);
  Alignment alignment =
    AlignWithBoundary(*topology, placed.corners, TotalQuarters(placed.interior));
  RequireConsistent(alignment.count); // before the mesh is factored
  const PointPotential potential(
    std::make_shared<const PotentialSolver>(topology), std::move(alignment));
  progress.Report(0.2);

  OptimizerResult result;
  const Objective objective(potential, placed.interior);
  const Evaluation last = Iterate(objective, options,
    0.5 * ResolveMeshSize(drill, refined) / refined.Diagonal(), progress, result);
  result.energyAfter = last.fullEnergy;
  result.holonomyDefect.assign(last.defects.begin(), last.defects.end());
  // The moved ones back among those on the boundary.
  const Configuration moved = objective.At(last.place);
  result.configuration = start;
  for (std::size_t i = 0; i < placed.rows.size(); ++i)
  {
    result.configuration[placed.rows[i]].position = moved[i].position;
  }
  for (auto& pair : result.annihilations)
  {
    for (int& member : pair)
    {
      member = static_cast<int>(placed.rows[static_cast<std::size_t>(member)]);
    }
  }
  return result;
}
}
