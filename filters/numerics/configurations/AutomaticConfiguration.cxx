#include "AutomaticConfiguration.h"

#include "DrillHoles.h"
#include "FitToQuads.h"
#include "ImposedSymmetry.h"
#include "MeshBudget.h"
#include "OptimizerStage.h"
#include "PoincareHopf.h"
#include "QuadClearance.h"
#include "SizedChoice.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
bool IsBetter(const OptimizerResult& one, const OptimizerResult& other)
{
  if (HasConvergedWithoutDefect(one) != HasConvergedWithoutDefect(other))
  {
    return HasConvergedWithoutDefect(one);
  }
  // Smaller defects may be artefacts of the mesh.
  const double defect = std::max(LargestDefect(one), NoticeableDefect);
  const double otherDefect = std::max(LargestDefect(other), NoticeableDefect);
  return std::make_tuple(defect, one.objective) < std::make_tuple(otherDefect, other.objective);
}

/// Returns whether a start has a lower objective than a minimum, by more than the error of the meshes:
/// the start that was best may have had a defect, which cost energy to remove. A start with a
/// defect promises nothing.
bool PromisesMore(const ProposedConfiguration& start, const OptimizerResult& minimum)
{
  constexpr double MeshError = 1e-2;
  return start.holonomyDefect < NoticeableDefect &&
    start.objective < minimum.objective - MeshError * (1.0 + std::abs(minimum.objective));
}

/// Returns whether a start is so far above the objective of a result that its own run would use up the
/// solves before it reaches it: by more than one core energy, 2π, for each singularity.
bool IsFarAbove(const ProposedConfiguration& start, const OptimizerResult& result)
{
  return start.objective >
    result.objective + 2.0 * Pi * static_cast<double>(start.singularities.size());
}

AutomaticConfiguration Optimize(const PlanarDomain& domain, const ProposedConfiguration& start,
  const AutomaticOptions& options, const Progress& progress)
{
  Configuration singularities = start.singularities;
  for (std::size_t i = options.proposal.given.size(); i < singularities.size(); ++i)
  {
    singularities[i].radius = 0.0; // radii of the start may not fit after a move
  }
  OptimizerOptions optimizerOptions = options.optimizer;
  optimizerOptions.corners = start.corners;
  AutomaticConfiguration result;
  result.optimum = OptimizeSingularities(domain, singularities, optimizerOptions, progress);
  result.singularities = result.optimum.configuration;
  result.corners = start.corners;
  result.events = { DescribeChoice(result.singularities) + " Start: " + start.origin + "." };
  AddEvents(result);
  return result;
}
}

void CapCorners(const PlanarDomain& domain, AutomaticOptions& options)
{
  std::vector<CornerChoice>& corners = options.proposal.corners;
  std::vector<CornerChoice> capped =
    CapCorners(CountQuarters(domain.loops, 0, options.proposal.cornerAngle, corners), corners);
  options.optimizer.keepAll |= capped.size() > corners.size();
  corners = std::move(capped);
}

AutomaticConfiguration ChooseConfiguration(
  const PlanarDomain& domain, const AutomaticOptions& options, const Progress& progress)
{
  // Checked before the proposal, which is slow on a boundary with very many segments.
  DrillOptions drillOptions;
  drillOptions.meshSize = options.optimizer.meshSize;
  RequireMemoryForMesh(domain, {}, ResolveMeshSize(drillOptions, domain), drillOptions.gradation);

  if (options.optimizer.sizes.sizing == Sizing::Field && options.proposal.given.empty())
  {
    if (std::optional<AutomaticConfiguration> sized = ChooseForSizes(domain, options, progress))
    {
      return std::move(*sized);
    }
  }

  // The energy alone decides which singularities there are, while they may move close to the
  // boundary. The clearance for quads and the target sizes apply afterwards.
  const double clearance = RequestedClearance(domain, options);
  const bool fits = clearance > CoreRadius(domain) ||
    options.optimizer.sizes.sizing != Sizing::Conformal || options.optimizer.pairs > 0 ||
    !options.optimizer.clearanceFactors.empty();
  AutomaticOptions minimum = options;
  minimum.optimizer.clearance = fits ? 0.0 : clearance;
  minimum.optimizer.clearanceFactors = {};
  if (fits)
  {
    // The run that follows converges to the tolerance.
    constexpr double DecidingTolerance = 1e-3;
    minimum.optimizer.tolerance = std::max(DecidingTolerance, options.optimizer.tolerance);
  }
  minimum.optimizer.quadSize = ResolveQuadSize(domain, options);
  minimum.optimizer.sizes = {};
  minimum.optimizer.pairs = 0;

  ProposalOptions proposal = options.proposal;
  proposal.quadSize = minimum.optimizer.quadSize;
  const std::vector<ProposedConfiguration> starts =
    ProposeConfigurations(domain, proposal, progress.Part(0.0, 0.4));
  AutomaticConfiguration best;
  std::size_t solves = 0;
  for (std::size_t i = 0; i < starts.size(); ++i)
  {
    if (i > 0 &&
      (HasConvergedWithoutDefect(best.optimum) ? !PromisesMore(starts[i], best.optimum)
                                               : IsFarAbove(starts[i], best.optimum)))
    {
      continue;
    }
    if (options.maximumSolves > 0)
    {
      if (solves >= options.maximumSolves)
      {
        best.events.push_back(std::to_string(starts.size() - i) +
          " other starts were not tried, because the search had used its " +
          std::to_string(options.maximumSolves) + " solves.");
        break;
      }
      minimum.optimizer.maximumSolves = options.maximumSolves - solves;
    }
    const double share = (fits ? 0.4 : 0.6) / static_cast<double>(starts.size());
    const double begin = 0.4 + share * static_cast<double>(i);
    AutomaticOptions run = minimum;
    if (starts[i].clearance > 0.0)
    {
      run.optimizer.keepAll = true;
      run.optimizer.clearance = clearance > 0.0 ? clearance : starts[i].clearance;
    }
    AutomaticConfiguration tried =
      Optimize(domain, starts[i], run, progress.Part(begin, begin + share));
    solves += tried.optimum.solves;
    if (i == 0 || IsBetter(tried.optimum, best.optimum))
    {
      best = std::move(tried);
    }
    if (best.optimum.aborted)
    {
      break;
    }
  }
  best.optimum.solves = solves;
  const std::optional<std::size_t> left = SolvesLeft(options.maximumSolves, solves);
  // The search of starts with a clearance has imposed symmetries.
  if (options.proposal.given.empty() && !best.optimum.aborted && left &&
    starts.front().clearance == 0.0)
  {
    // Enough to turn four singularities in a disk by an eighth of a turn.
    constexpr double LargestMove = 0.1;
    OptimizerOptions run = minimum.optimizer;
    run.corners = best.corners;
    run.maximumSolves = *left;
    ImposeSymmetry(
      domain, run, LargestMove * domain.Diagonal(), progress.Part(0.8, fits ? 0.85 : 1.0), best);
  }
  if (fits && !best.optimum.aborted)
  {
    const AutomaticConfiguration unfitted = best;
    const bool isUneven =
      FitToQuads(domain, options, UsualQuadsAtHoles, true, progress.Part(0.85, 0.95), best);
    // The more there are, the less configurations differ, and the longer each takes.
    constexpr std::size_t ManySingularities = 60;
    if (options.configurations > 1 && !best.optimum.aborted &&
      best.singularities.size() <= ManySingularities)
    {
      FitOthers(domain, options, starts, unfitted, isUneven, progress.Part(0.95, 1.0), best);
    }
  }
  return best;
}
}
