#include "OptimizerPairs.h"

#include "OptimizerIteration.h"
#include "PairSearch.h"

#include <limits>

namespace crossfield
{
namespace
{
double ScoreOf(const OptimizerState& state)
{
  return 0.5 * state.sizeSpread * state.sizeSpread + 0.25 * state.defects.squaredNorm();
}

void AddSingularity(TrackedConfiguration& tracked, const Point& position, int quarterIndex)
{
  tracked.singularities.push_back({ position, quarterIndex, 0.0 });
  tracked.origins.push_back(AddedOrigin);
}
}

std::optional<TrackedConfiguration> FindBestPair(const PlanarDomain& domain,
  const OptimizerStage& stage, const OptimizerState& current, const StageOptions& options,
  const Progress& progress)
{
  constexpr int TrialSteps = 40;
  const PointPotential& potential = *stage.potential;
  PairSearchOptions search;
  // The range of the barrier, which begins at the clearance.
  search.count = 10;
  search.clearance = 2.0 * options.objective.clearance;
  const std::vector<SingularityPair> pairs = FindPairs(
    potential, *stage.objective->Uniformity(), stage.objective->At(current.positions), search);
  std::optional<TrackedConfiguration> best;
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    progress.Report(static_cast<double>(i) / static_cast<double>(pairs.size()));
    TrackedConfiguration tracked = stage.At(current.positions);
    AddSingularity(tracked, pairs[i].positive, 1);
    AddSingularity(tracked, pairs[i].negative, -1);
    const OptimizerStage trial = MakeStage(domain, tracked, options);
    OptimizerState state = trial.objective->Evaluate(trial.objective->Start());
    OptimizerIteration iteration;
    iteration.maximumIterations = TrialSteps;
    iteration.checksMesh = false;
    iteration.Run(*trial.objective, {}, state);
    if (ScoreOf(state) < lowest)
    {
      lowest = ScoreOf(state);
      best = trial.At(state.positions);
    }
  }
  return best;
}
}
