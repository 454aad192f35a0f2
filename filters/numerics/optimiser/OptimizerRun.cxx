#include "OptimizerRun.h"

#include "Error.h"
#include "OptimizerPairs.h"
#include "OptimizerReport.h"
#include "OptimizerStart.h"

#include <cmath>
#include <numeric>
#include <optional>

namespace crossfield
{
namespace
{
/// Below this a defect may come from the mesh; radians.
constexpr double NotableDefect = 0.01;
}

OptimizerRun::OptimizerRun(
  const PlanarDomain& domain, const OptimizerOptions& options, OptimizerResult& result)
  : Domain(domain)
  , MostIterations(options.maximumIterations)
  , KeepAll(options.keepAll)
  , Result(result)
{
  if (options.clearance < 0.0 || !std::isfinite(options.clearance))
  {
    throw Error(
      "The clearance of the singularities must be positive, or 0 for 1/400 of the diagonal.");
  }
  this->Stages.meshSize = options.meshSize;
  this->Stages.corners = options.corners;
  this->Stages.objective.clearance =
    options.clearance > 0.0 ? options.clearance : CoreRadius(domain);
  this->Stages.objective.sizes = options.sizes;
  this->Iteration.tolerance = options.tolerance;
  this->Iteration.maximumIterations = options.maximumIterations;
}

void OptimizerRun::Start(const Configuration& start, const Progress& progress)
{
  TrackedConfiguration tracked{ start, std::vector<int>(start.size()), {} };
  std::iota(tracked.origins.begin(), tracked.origins.end(), 0);
  const double asked = this->Stages.objective.clearance;
  this->Stages.objective.clearance = ClearStart(this->Domain, asked, tracked.singularities);
  if (this->Stages.objective.clearance < asked)
  {
    this->Say(
      "Two singularities, or one and the boundary, are too near each other for a clearance of " +
      Short(asked) + "; it is " + Short(this->Stages.objective.clearance) + " in this run.");
  }
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    const double way = (tracked.singularities[i].position - start[i].position).norm();
    if (way > 0.0)
    {
      this->Say("Singularity " + std::to_string(i + 1) + " at " + Describe(start[i].position) +
        " was moved by " + Short(way) + " to have the clearance at the start.");
    }
  }
  this->Begin(tracked, progress.Part(0.0, 0.2));
  this->StartsSymmetric = this->Stage.objective->KeepsSymmetry();
  this->Result.energyBefore = this->Here.fullEnergy;
  progress.Report(0.2);
}

OptimizerEnd OptimizerRun::Move(const Progress& progress)
{
  constexpr int MostMeshes = 30; // then W on the present one has to do
  for (int meshes = 1;; ++meshes)
  {
    this->Iteration.watchesMesh = meshes < MostMeshes;
    this->Iteration.changes = [this](const OptimizerPlace& place)
    { return !this->KeepAll && this->Persists(place); };
    const OptimizerEnd end = this->Iteration.Run(*this->Stage.objective, progress, this->Here);
    if (end == OptimizerEnd::Mesh)
    {
      this->Begin(this->Stage.At(this->Here.place), {});
    }
    else if (end == OptimizerEnd::Aborted || end == OptimizerEnd::Limit || !this->Change())
    {
      if (end == OptimizerEnd::Rest && (this->LeaveSaddle() || this->RestoreSymmetry()))
      {
        continue;
      }
      if (end != OptimizerEnd::Change)
      {
        return end;
      }
    }
  }
}

OptimizerEnd OptimizerRun::Even(const Progress& progress)
{
  this->Stages.objective.goal = OptimizerGoal::UniformSizes;
  this->KeepAll = true;
  this->Begin(this->Stage.At(this->Here.place), {});
  this->Result.sizeSpreads = SizeSpreads{ this->Here.sizeSpread, this->Here.sizeSpread };
  this->AddToFront();
  this->Iteration.Restart();
  this->Iteration.maximumIterations = this->Iteration.iterations + this->MostIterations;
  const OptimizerEnd end = this->Move(progress);
  this->AddToFront();
  return end;
}

OptimizerEnd OptimizerRun::AddPairs(int most, OptimizerEnd end, const Progress& progress)
{
  // A pair has to bring so much; nobody sees less, or what is left of unevenness below the second.
  constexpr double LeastGain = 0.15;
  constexpr double EvenEnough = 0.04;
  constexpr double LeastDefect = 0.2; // by which crosses miss by 0.05
  for (int pair = 0; pair < most; ++pair)
  {
    const double defect = this->Here.defects.lpNorm<Eigen::Infinity>();
    if (end == OptimizerEnd::Aborted ||
      (this->Here.sizeSpread < EvenEnough && defect < LeastDefect))
    {
      return end;
    }
    const OptimizerStage stage = this->Stage;
    const OptimizerPlace here = this->Here;
    const OptimizerIteration iteration = this->Iteration;
    const Progress part =
      progress.Part(static_cast<double>(pair) / most, static_cast<double>(pair + 1) / most);
    std::optional<TrackedConfiguration> with;
    try
    {
      with = FindBestPair(this->Domain, stage, here, this->Stages, part.Part(0.0, 0.5));
    }
    catch (const Aborted&)
    {
      return OptimizerEnd::Aborted;
    }
    if (!with)
    {
      return end;
    }
    this->Begin(*with, {});
    this->Iteration.Restart();
    this->Iteration.maximumIterations = this->Iteration.iterations + this->MostIterations;
    const OptimizerEnd reached = this->Move(part.Part(0.5, 1.0));
    const std::string gain =
      "the spread of sizes from " + Short(here.sizeSpread) + " to " + Short(this->Here.sizeSpread);
    const bool mends =
      defect > LeastDefect && this->Here.defects.lpNorm<Eigen::Infinity>() < 0.5 * defect;
    if (!mends && !(this->Here.sizeSpread < (1.0 - LeastGain) * here.sizeSpread))
    {
      this->Say("A further pair of singularities would change " + gain + ", and was left out.");
      this->Stage = stage;
      this->Here = here;
      this->Iteration = iteration;
      return end;
    }
    this->Say("A pair of singularities was added, which changed " + gain + ".");
    this->AddToFront();
    end = reached;
  }
  return end;
}

void OptimizerRun::AddToFront()
{
  FrontPoint point;
  point.singularities = static_cast<int>(this->Stage.tracked.singularities.size());
  point.sizeSpread = this->Here.sizeSpread;
  point.energy = this->Here.fullEnergy;
  point.holonomyDefect = this->Here.defects.lpNorm<Eigen::Infinity>();
  this->Result.front.push_back(point);
}

void OptimizerRun::Finish(OptimizerEnd end)
{
  const TrackedConfiguration last = this->Stage.At(this->Here.place);
  OptimizerResult& result = this->Result;
  result.configuration = last.singularities;
  result.energyAfter = this->Here.fullEnergy;
  if (result.sizeSpreads)
  {
    result.sizeSpreads->after = this->Here.sizeSpread;
  }
  result.holonomyDefect.assign(this->Here.defects.begin(), this->Here.defects.end());
  const PointPotential& potential = *this->Stage.potential;
  result.sizeSpread = SizeUniformity(potential).SpreadOf(
    potential, potential.Solve(this->Stage.objective->At(this->Here.place)));
  result.iterations = this->Iteration.iterations;
  result.history = this->Iteration.history;
  result.converged = end == OptimizerEnd::Rest;
  result.aborted = end == OptimizerEnd::Aborted;
  result.reason =
    ReasonOf(end, this->Stages.objective, this->Stage.objective->Count(), result.iterations);
  for (const std::size_t i : HeldSingularities(this->Stage, this->Here))
  {
    this->Say("The clearance holds " + last.Name(this->Stage.placed.rows[i]) + " at " +
      Describe(last.singularities[this->Stage.placed.rows[i]].position) +
      "; it would go nearer to the boundary.");
  }
  if (this->Iteration.unreachableDefect > NotableDefect)
  {
    this->Say("A holonomy defect of " + Short(this->Iteration.unreachableDefect) +
      " remains that no singularity inside can change; add two of opposite sign.");
  }
  if (!this->Changed && this->Stages.objective.goal == OptimizerGoal::Energy &&
    result.energyAfter > result.energyBefore + 1e-3 * (1.0 + std::abs(result.energyBefore)))
  {
    this->Say("The holonomy defects were removed at the price of a renormalised energy of " +
      Short(result.energyAfter) + " instead of " + Short(result.energyBefore) + ".");
  }
  for (const std::string& event : ShrinkRadii(this->Domain, result.configuration))
  {
    this->Say(event);
  }
}

void OptimizerRun::Begin(const TrackedConfiguration& tracked, const Progress& progress)
{
  this->Stage = MakeStage(this->Domain, tracked, this->Stages, progress);
  this->Here = this->Stage.objective->Evaluate(this->Stage.objective->Start());
}
}
