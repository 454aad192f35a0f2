#include "OptimizerRun.h"

#include "CurveSymmetry.h"
#include "Error.h"
#include "OptimizerPairs.h"
#include "OptimizerReport.h"
#include "OptimizerStart.h"
#include "OptimizerSymmetry.h"
#include "PoincareHopf.h"

#include <cmath>
#include <numeric>
#include <optional>

namespace crossfield
{
namespace
{
/// Defects below this may be errors of the mesh; radians.
constexpr double NotableDefect = 0.01;
/// Moves below this are rounding errors; relative to the diagonal.
constexpr double NotableMove = 1e-9;
}

OptimizerRun::OptimizerRun(
  const PlanarDomain& domain, const OptimizerOptions& options, OptimizerResult& result)
  : Domain(domain)
  , MaximumIterations(options.maximumIterations)
  , KeepAll(options.keepAll)
  , Result(result)
{
  if (options.clearance < 0.0 || !std::isfinite(options.clearance))
  {
    throw Error(
      "The clearance of the singularities must be positive, or 0 for 1/400 of the diagonal.");
  }
  this->Options.meshSize = options.meshSize;
  this->Options.corners = options.corners;
  this->Options.quadSize = options.quadSize;
  this->Options.objective.clearance =
    options.clearance > 0.0 ? options.clearance : CoreRadius(domain);
  this->Options.objective.clearanceFactors = options.clearanceFactors;
  this->Options.objective.sizes = options.sizes;
  if (options.maximumSolves > 0)
  {
    this->Options.objective.budget = std::make_shared<SolveBudget>(options.maximumSolves);
  }
  this->Iteration.tolerance = options.tolerance;
  this->Iteration.maximumIterations = options.maximumIterations;
}

void OptimizerRun::Start(const Configuration& start, const Progress& progress)
{
  TrackedConfiguration tracked{ start, std::vector<int>(start.size()), {} };
  std::iota(tracked.origins.begin(), tracked.origins.end(), 0);
  const double requested = this->Options.objective.clearance;
  this->EnforceClearances(requested, tracked.singularities);
  if (this->Options.objective.clearance < requested)
  {
    this->AddEvent("Two singularities, or one and the boundary, are too close for a clearance of " +
      FormatShort(requested) + "; this run uses " + FormatShort(this->Options.objective.clearance) +
      ".");
  }
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    const double distance = (tracked.singularities[i].position - start[i].position).norm();
    if (distance > NotableMove * this->Domain.Diagonal())
    {
      this->AddEvent("Singularity " + std::to_string(i + 1) + " at " + Describe(start[i].position) +
        " was moved by " + FormatShort(distance) + " to keep the clearance at the start.");
    }
  }
  this->StartStage(tracked, progress.Part(0.0, 0.2));
  this->StartsSymmetric = this->Stage.objective->KeepsSymmetry();
  this->Result.energyBefore = this->Current.fullEnergy;
  this->DefectBefore = this->Current.defects.lpNorm<Eigen::Infinity>();
  progress.Report(0.2);
}

double OptimizerRun::Objective() const
{
  constexpr double SeenPart = 0.25; // of a quad: less is not seen in a mesh
  const SymmetryGroup group = FindCurveSymmetries(this->Domain);
  const ConfigurationSymmetry symmetry = MatchSymmetry(
    this->Stage.At(this->Current.positions).singularities, group, SeenPart * this->Stage.quadSize);
  return this->Stage.CoreEnergy(this->Current) - WorthOfSymmetries(symmetry.elements, group);
}

void OptimizerRun::EnforceClearances(double requested, Configuration& singularities)
{
  constexpr double Reduction = 0.8;
  ObjectiveOptions& objective = this->Options.objective;
  double largest = 1.0;
  for (const std::vector<double>& factors : objective.clearanceFactors)
  {
    largest = std::max(largest, *std::max_element(factors.begin(), factors.end()));
  }
  for (;;)
  {
    objective.clearance =
      EnforceClearance(this->Domain, requested, singularities, objective.clearanceFactors);
    if (objective.clearance >= requested || largest <= 1.0)
    {
      return;
    }
    // Too little space: the factors are reduced before the clearance is.
    largest *= Reduction;
    for (std::vector<double>& factors : objective.clearanceFactors)
    {
      for (double& factor : factors)
      {
        factor = std::max(1.0, Reduction * factor);
      }
    }
  }
}

OptimizerEnd OptimizerRun::Minimise(const Progress& progress)
{
  constexpr int MaximumMeshes = 30; // then the resolution is no longer checked
  for (int meshes = 1;; ++meshes)
  {
    this->Iteration.checksMesh = meshes < MaximumMeshes;
    this->Iteration.stopsForChange = [this](const OptimizerState& state)
    { return !this->KeepAll && this->IsChangeDue(state); };
    const OptimizerEnd end = this->Iteration.Run(*this->Stage.objective, progress, this->Current);
    if (end == OptimizerEnd::MeshTooCoarse)
    {
      this->StartStage(this->Stage.At(this->Current.positions), {});
    }
    else if (end == OptimizerEnd::Aborted || end == OptimizerEnd::IterationLimit ||
      end == OptimizerEnd::BudgetSpent || !this->MakeChange())
    {
      if (end == OptimizerEnd::Converged && (this->LeaveSaddle() || this->RestoreSymmetry()))
      {
        continue;
      }
      if (end != OptimizerEnd::ChangeRequested)
      {
        this->ReturnToSaddle();
        return end;
      }
    }
  }
}

OptimizerEnd OptimizerRun::MakeSizesUniform(const Progress& progress)
{
  this->Options.objective.goal = OptimizerGoal::UniformSizes;
  this->KeepAll = true;
  this->StartStage(this->Stage.At(this->Current.positions), {});
  this->Result.sizeSpreads = SizeSpreads{ this->Current.sizeSpread, this->Current.sizeSpread };
  this->AddToFront();
  this->Iteration.Restart();
  this->Iteration.maximumIterations = this->Iteration.iterations + this->MaximumIterations;
  const OptimizerEnd end = this->Minimise(progress);
  this->AddToFront();
  return end;
}

OptimizerEnd OptimizerRun::AddPairs(int maximumPairs, OptimizerEnd end, const Progress& progress)
{
  // Minimum relative reduction of the spread by a pair, and the spread below which no pair is
  // tried: neither is visible in a mesh.
  constexpr double MinimumGain = 0.15;
  constexpr double UniformSpread = 0.04;
  constexpr double MinimumDefect = 0.2; // crosses do not match by an angle of 0.05
  for (int pair = 0; pair < maximumPairs; ++pair)
  {
    const double defect = this->Current.defects.lpNorm<Eigen::Infinity>();
    if (end == OptimizerEnd::Aborted || end == OptimizerEnd::BudgetSpent ||
      (this->Current.sizeSpread < UniformSpread && defect < MinimumDefect))
    {
      return end;
    }
    const OptimizerStage stage = this->Stage;
    const OptimizerState current = this->Current;
    const OptimizerIteration iteration = this->Iteration;
    const Progress part = progress.Part(
      static_cast<double>(pair) / maximumPairs, static_cast<double>(pair + 1) / maximumPairs);
    std::optional<TrackedConfiguration> extended;
    try
    {
      extended = FindBestPair(this->Domain, stage, current, this->Options, part.Part(0.0, 0.5));
    }
    catch (const Aborted&)
    {
      return OptimizerEnd::Aborted;
    }
    if (!extended)
    {
      return end;
    }
    this->StartStage(*extended, {});
    this->Iteration.Restart();
    this->Iteration.maximumIterations = this->Iteration.iterations + this->MaximumIterations;
    const OptimizerEnd reached = this->Minimise(part.Part(0.5, 1.0));
    const std::string gain = "the spread of sizes from " + FormatShort(current.sizeSpread) +
      " to " + FormatShort(this->Current.sizeSpread);
    const bool reducesDefect =
      defect > MinimumDefect && this->Current.defects.lpNorm<Eigen::Infinity>() < 0.5 * defect;
    if (!reducesDefect && !(this->Current.sizeSpread < (1.0 - MinimumGain) * current.sizeSpread))
    {
      this->AddEvent(
        "A further pair of singularities would change " + gain + " and was not added.");
      this->Stage = stage;
      this->Current = current;
      this->Iteration = iteration;
      return end;
    }
    this->AddEvent("A pair of singularities was added, which changed " + gain + ".");
    this->AddToFront();
    end = reached;
  }
  return end;
}

void OptimizerRun::AddToFront()
{
  FrontPoint point;
  point.singularities = static_cast<int>(this->Stage.tracked.singularities.size());
  point.sizeSpread = this->Current.sizeSpread;
  point.energy = this->Current.fullEnergy;
  point.holonomyDefect = this->Current.defects.lpNorm<Eigen::Infinity>();
  this->Result.front.push_back(point);
}

void OptimizerRun::WriteResult(OptimizerEnd end)
{
  const TrackedConfiguration last = this->Stage.At(this->Current.positions);
  OptimizerResult& result = this->Result;
  result.configuration = last.singularities;
  result.energyAfter = this->Current.fullEnergy;
  result.coreEnergy = this->Stage.CoreEnergy(this->Current);
  result.objective = this->Objective();
  if (result.sizeSpreads)
  {
    result.sizeSpreads->after = this->Current.sizeSpread;
  }
  result.holonomyDefect.assign(this->Current.defects.begin(), this->Current.defects.end());
  const PointPotential& potential = *this->Stage.potential;
  result.sizeSpread = SizeUniformity(potential).SpreadOf(
    potential, potential.Solve(this->Stage.objective->At(this->Current.positions)));
  result.iterations = this->Iteration.iterations;
  result.solves = this->Options.objective.budget->GetSpent();
  result.history = this->Iteration.history;
  result.converged = end == OptimizerEnd::Converged;
  result.aborted = end == OptimizerEnd::Aborted;
  result.reason = EndReason(end, this->Options.objective, this->Stage.objective->Count(),
    HeldSingularities(this->Current), result.iterations);
  for (const std::size_t i : StoppedSingularities(this->Stage, this->Current))
  {
    this->AddEvent("The clearance stops " + last.Name(this->Stage.placed.rows[i]) + " at " +
      Describe(last.singularities[this->Stage.placed.rows[i]].position) +
      "; without it, the singularity would move closer to the boundary.");
  }
  if (this->Iteration.unreachableDefect > NotableDefect)
  {
    this->AddEvent("A holonomy defect of " + CrossAngle(this->Iteration.unreachableDefect) +
      " of the crosses remains that no interior singularity can change; add two singularities of "
      "opposite sign.");
  }
  if (!this->Changed && this->DefectBefore > NotableDefect &&
    this->Options.objective.goal == OptimizerGoal::Energy &&
    result.energyAfter > result.energyBefore + 1e-3 * (1.0 + std::abs(result.energyBefore)))
  {
    this->AddEvent("Removing the holonomy defects raised the renormalised energy from " +
      FormatShort(result.energyBefore) + " to " + FormatShort(result.energyAfter) + ".");
  }
  for (const std::string& event : ShrinkRadii(this->Domain, result.configuration))
  {
    this->AddEvent(event);
  }
}

void OptimizerRun::StartStage(const TrackedConfiguration& tracked, const Progress& progress)
{
  this->Stage = MakeStage(this->Domain, tracked, this->Options, progress);
  this->Targets = {};
  this->Current = this->Stage.objective->Evaluate(this->Stage.objective->Start());
}
}
