// What a run does besides moving: it leaves symmetries, comes back to them, and changes what singularities are.
#include "OptimizerRun.h"

#include "Error.h"
#include "OptimizerCurvature.h"
#include "OptimizerSymmetry.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Moves along the boundary; each is a few clearances long, and a nose has no room for more.
constexpr int MostSlides = 10;
}

bool OptimizerRun::LeaveSaddle()
{
  if (!this->Stage.objective->KeepsSymmetry())
  {
    return false;
  }
  const auto free =
    std::make_shared<const OptimizerObjective>(this->Stage.objective->WithoutSymmetry());
  const auto direction = FindDescent(*this->Stage.objective, *free, this->Here.place);
  if (!direction)
  {
    return false;
  }
  Eigen::VectorXd step = 0.5 * free->Clearance() * *direction;
  step *= free->LongestPart(this->Here.place, step);
  while (!std::isfinite(free->EvaluateBarrier(this->Here.place + step).energy))
  {
    step *= 0.5; // at zero it is finite
  }
  this->Here = free->Evaluate(this->Here.place + step);
  this->Stage.objective = free;
  this->Stages.objective.keepSymmetry = false;
  this->Iteration.Restart();
  this->Say("The singularities left a symmetry of the domain, which kept them at a saddle of "
            "what is minimised.");
  return true;
}

bool OptimizerRun::RestoreSymmetry()
{
  if (!this->StartsSymmetric || !this->Stages.objective.keepSymmetry || !this->Changed ||
    this->Restored || this->Stage.objective->KeepsSymmetry())
  {
    return false;
  }
  this->Restored = true;
  Configuration interior = this->Stage.objective->At(this->Here.place);
  const ConfigurationSymmetry symmetry =
    MatchWithBoundary(*this->Stage.potential, FindSymmetries(this->Domain), interior,
      this->Stages.objective.clearance, this->Stage.objective->SymmetryTest());
  if (symmetry.IsTrivial())
  {
    return false;
  }
  symmetry.Project(interior);
  TrackedConfiguration tracked = this->Stage.At(this->Here.place);
  for (std::size_t i = 0; i < interior.size(); ++i)
  {
    tracked.singularities[this->Stage.placed.rows[i]].position = interior[i].position;
  }
  this->Begin(tracked, {});
  this->Iteration.Restart();
  return true;
}

bool OptimizerRun::Persists(const OptimizerPlace& place)
{
  constexpr int Steps = 5;
  constexpr double Still =
    0.2; // of the clearance: one that glides along the boundary is not there yet
  bool still = this->Last.size() == place.place.size();
  for (const std::size_t i : HeldSingularities(this->Stage, place))
  {
    const Eigen::Index row = 2 * static_cast<Eigen::Index>(i);
    still = still &&
      (place.place - this->Last).segment<2>(row).norm() <
        Still * this->Stage.objective->Clearance();
  }
  this->Last = place.place;
  const bool wanted =
    FindMeeting(this->Stage, place) || FindPressed(this->Stage, place, this->Refused);
  this->Wanted = wanted && still ? this->Wanted + 1 : 0;
  return this->Wanted >= Steps;
}

bool OptimizerRun::Change()
{
  this->Wanted = 0;
  while (!this->KeepAll)
  {
    auto change = FindMeeting(this->Stage, this->Here);
    change = change ? change : FindPressed(this->Stage, this->Here, this->Refused);
    change = change ? change : FindLoose(this->Stage, this->Here, this->Refused);
    change = change || this->Slides == MostSlides
      ? change
      : FindSlide(this->Stage, this->Here, this->Refused);
    if (!change)
    {
      return false;
    }
    if (this->Try(*change))
    {
      this->Say(change->event);
      this->Changed = true;
      this->Slides += change->key.compare(0, 5, "along") == 0 ? 1 : 0;
      if (change->meets)
      {
        this->Result.annihilations.push_back(change->pair);
      }
      return true;
    }
    this->Refused.insert(change->key);
  }
  return false;
}

bool OptimizerRun::Try(const ConfigurationChange& change)
{
  constexpr int TrialSteps = 30;
  const OptimizerStage stage = this->Stage;
  const OptimizerPlace here = this->Here;
  const OptimizerIteration iteration = this->Iteration;
  const double before = stage.CoreEnergy(here);
  try
  {
    this->Begin(change.tracked, {});
    this->Iteration.Restart();
    if (change.meets || this->Stage.CoreEnergy(this->Here) < before)
    {
      return true;
    }
    this->Iteration.changes = nullptr;
    this->Iteration.watchesMesh = false;
    this->Iteration.maximumIterations =
      std::min(iteration.maximumIterations, iteration.iterations + TrialSteps);
    this->Iteration.Run(*this->Stage.objective, {}, this->Here);
    this->Iteration.maximumIterations = iteration.maximumIterations;
    if (this->Stage.CoreEnergy(this->Here) < before)
    {
      return true;
    }
  }
  catch (const Error&)
  {
    // Such a configuration cannot exist: it stays what it was.
  }
  this->Stage = stage;
  this->Here = here;
  this->Iteration = iteration;
  return false;
}
}
