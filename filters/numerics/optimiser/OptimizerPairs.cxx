#include "OptimizerPairs.h"

#include "OptimizerIteration.h"
#include "PairSearch.h"

#include <limits>

namespace crossfield
{
namespace
{
double ScoreOf(const OptimizerPlace& place)
{
  return 0.5 * place.sizeSpread * place.sizeSpread + 0.25 * place.defects.squaredNorm();
}

void Add(TrackedConfiguration& tracked, const Point& place, int quarterIndex)
{
  tracked.singularities.push_back({ place, quarterIndex, 0.0 });
  tracked.origins.push_back(AddedOrigin);
}
}

std::optional<TrackedConfiguration> FindBestPair(const PlanarDomain& domain,
  const OptimizerStage& stage, const OptimizerPlace& here, const StageOptions& options,
  const Progress& progress)
{
  constexpr int TrialSteps = 40;
  const PointPotential& potential = *stage.potential;
  PairSearchOptions search;
  // Where the barrier ends, which begins at the clearance.
  search.count = 10;
  search.clearance = 2.0 * options.objective.clearance;
  const std::vector<SingularityPair> pairs =
    FindPairs(potential, *stage.objective->Evenness(), stage.objective->At(here.place), search);
  std::optional<TrackedConfiguration> best;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    progress.Report(static_cast<double>(i) / static_cast<double>(pairs.size()));
    TrackedConfiguration tracked = stage.At(here.place);
    Add(tracked, pairs[i].positive, 1);
    Add(tracked, pairs[i].negative, -1);
    const OptimizerStage trial = MakeStage(domain, tracked, options);
    OptimizerPlace place = trial.objective->Evaluate(trial.objective->Start());
    OptimizerIteration iteration;
    iteration.maximumIterations = TrialSteps;
    iteration.watchesMesh = false;
    iteration.Run(*trial.objective, {}, place);
    if (ScoreOf(place) < least)
    {
      least = ScoreOf(place);
      best = trial.At(place.place);
    }
  }
  return best;
}
}
