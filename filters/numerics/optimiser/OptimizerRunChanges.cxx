// Changes made by a run between minimisations: breaking and restoring symmetries, and changing the
// configuration.
#include "OptimizerRun.h"

#include "BoundaryAbsorption.h"
#include "CurveSymmetry.h"
#include "Error.h"
#include "OptimizerCurvature.h"
#include "OptimizerReport.h"
#include "OptimizerSymmetry.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Number of absorptions in succession that did not lower the energy, after which no more are
/// tried: they are tried in the order of what they promise.
constexpr int MaximumFailures = 3;
/// Maximum number of moves along the boundary; each is several clearances long, and no more are
/// needed around a leading edge.
constexpr int MaximumBoundaryMoves = 10;
}

bool OptimizerRun::LeaveSaddle()
{
  if (!this->Stage.objective->KeepsSymmetry())
  {
    return false;
  }
  const auto free =
    std::make_shared<const OptimizerObjective>(this->Stage.objective->WithoutSymmetry());
  const auto direction = FindDescent(*this->Stage.objective, *free, this->Current.positions);
  if (!direction)
  {
    return false;
  }
  Eigen::VectorXd step = 0.5 * free->Clearance() * *direction;
  step *= free->LargestFraction(this->Current.positions, step);
  while (!std::isfinite(free->EvaluateBarrier(this->Current.positions + step).energy))
  {
    step *= 0.5; // the barrier is finite at a step of zero
  }
  this->Saddle = SymmetricStop{ this->Stage, this->Current };
  this->Current = free->Evaluate(this->Current.positions + step);
  this->Stage.objective = free;
  this->Options.objective.keepSymmetry = false;
  this->Iteration.Restart();
  return true;
}

void OptimizerRun::ReturnToSaddle()
{
  // W contains π log(1/ρ) for a singularity of index ±1 with core radius ρ: a gain of 0.15 π for
  // each is what sizes near it that differ by 15 % make. That is less than symmetric quads are
  // worth.
  constexpr double SmallGain = 0.15 * Pi;
  if (!this->Saddle)
  {
    return;
  }
  const auto count = static_cast<double>(this->Current.positions.size() / 2);
  const double gain = this->Saddle->current.energy - this->Current.energy;
  const double worth = WorthOfSymmetries(this->Saddle->stage.objective->CountSymmetries());
  if (gain > std::max(SmallGain * count, worth))
  {
    this->AddEvent(
      "The singularities no longer follow a symmetry of the domain, which kept them at a saddle "
      "point of the objective.");
  }
  else
  {
    this->Stage = this->Saddle->stage;
    this->Current = this->Saddle->current;
    this->Options.objective.keepSymmetry = true;
    this->AddEvent("Positions without the symmetry of the domain would lower the objective by " +
      FormatShort(gain) + " only; the symmetric ones are used.");
  }
  this->Saddle.reset();
}

bool OptimizerRun::RestoreSymmetry()
{
  if (!this->StartsSymmetric || !this->Options.objective.keepSymmetry || !this->Changed ||
    this->SymmetryTried || this->Stage.objective->KeepsSymmetry())
  {
    return false;
  }
  this->SymmetryTried = true;
  Configuration interior = this->Stage.objective->At(this->Current.positions);
  const ConfigurationSymmetry symmetry =
    MatchWithBoundary(*this->Stage.potential, FindCurveSymmetries(this->Domain), interior,
      this->Options.objective.clearance, this->Stage.objective->SymmetryTest());
  if (symmetry.IsTrivial())
  {
    return false;
  }
  symmetry.Project(interior);
  TrackedConfiguration tracked = this->Stage.At(this->Current.positions);
  for (std::size_t i = 0; i < interior.size(); ++i)
  {
    tracked.singularities[this->Stage.placed.rows[i]].position = interior[i].position;
  }
  this->StartStage(tracked, {});
  this->Iteration.Restart();
  return true;
}

bool OptimizerRun::IsChangeDue(const OptimizerState& state)
{
  constexpr int RequiredSteps = 5;
  // relative to the clearance: a singularity that still moves along the boundary has not arrived
  constexpr double StillTolerance = 0.2;
  bool isStill = this->PreviousPositions.size() == state.positions.size();
  for (const std::size_t i : StoppedSingularities(this->Stage, state))
  {
    const Eigen::Index row = 2 * static_cast<Eigen::Index>(i);
    isStill = isStill &&
      (state.positions - this->PreviousPositions).segment<2>(row).norm() <
        StillTolerance * this->Stage.objective->Clearance();
  }
  this->PreviousPositions = state.positions;
  const bool isDue = isStill &&
    (FindAnnihilation(this->Stage, state) ||
      (this->FailedAbsorptions < MaximumFailures &&
        IsAbsorptionDue(this->Stage, state, this->Rejected, this->Targets)));
  this->StepsDue = isDue ? this->StepsDue + 1 : 0;
  return this->StepsDue >= RequiredSteps;
}

bool OptimizerRun::MakeChange()
{
  this->StepsDue = 0;
  bool several = true;
  while (!this->KeepAll && !this->Options.objective.budget->IsSpent())
  {
    auto change = FindAnnihilation(this->Stage, this->Current);
    change = change || this->FailedAbsorptions == MaximumFailures
      ? change
      : FindAbsorption(this->Stage, this->Current, this->Rejected, this->Targets, several);
    change = change ? change : FindRelease(this->Stage, this->Current, this->Rejected);
    change = change || this->BoundaryMoves == MaximumBoundaryMoves
      ? change
      : FindBoundaryMoves(this->Stage, this->Current, this->Rejected);
    if (!change)
    {
      return false;
    }
    if (this->TryChange(*change))
    {
      for (const std::string& event : change->events)
      {
        this->AddEvent(event);
      }
      this->Changed = true;
      this->Saddle.reset(); // of another configuration
      this->FailedAbsorptions = 0;
      this->BoundaryMoves += change->key.compare(0, 5, "along") == 0 ? 1 : 0;
      if (change->annihilates)
      {
        this->Result.annihilations.push_back(change->pair);
      }
      return true;
    }
    if (change->several)
    {
      several = false; // one of them may still lower the energy
      continue;
    }
    this->Rejected.insert(change->key);
    this->FailedAbsorptions += change->key.compare(0, 3, "in ") == 0 ? 1 : 0;
  }
  return false;
}

bool OptimizerRun::TryChange(const ConfigurationChange& change)
{
  constexpr int TrialSteps = 30;
  const OptimizerStage stage = this->Stage;
  const OptimizerState current = this->Current;
  const OptimizerIteration iteration = this->Iteration;
  const BoundaryTargets targets = this->Targets;
  const double before = stage.CoreEnergy(current);
  try
  {
    this->StartStage(change.tracked, {});
    this->Iteration.Restart();
    if (change.annihilates || this->Stage.CoreEnergy(this->Current) < before)
    {
      return true;
    }
    this->Iteration.stopsForChange = nullptr;
    this->Iteration.checksMesh = false;
    this->Iteration.maximumIterations =
      std::min(iteration.maximumIterations, iteration.iterations + TrialSteps);
    this->Iteration.Run(*this->Stage.objective, {}, this->Current);
    this->Iteration.maximumIterations = iteration.maximumIterations;
    if (this->Stage.CoreEnergy(this->Current) < before)
    {
      return true;
    }
  }
  catch (const Error&)
  {
    // The changed configuration does not exist; the previous one is restored.
  }
  this->Stage = stage;
  this->Current = current;
  this->Iteration = iteration;
  this->Targets = targets;
  return false;
}
}
