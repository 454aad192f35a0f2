#include "FitToQuads.h"

#include "CurveSymmetry.h"
#include "Error.h"
#include "HolePattern.h"
#include "ImposedSymmetry.h"
#include "OptimizerReport.h"
#include "PoincareHopf.h"
#include "QuadClearance.h"

#include <algorithm>
#include <map>

namespace crossfield
{
namespace
{
/// Sets the clearance for quads, larger at holes unless a clearance or factors are requested.
void SetClearance(const PlanarDomain& domain, const AutomaticOptions& options, double quadsAtHoles,
  OptimizerOptions& run)
{
  run.clearance = RequestedClearance(domain, options);
  run.clearanceFactors = options.optimizer.clearanceFactors;
  if (options.optimizer.clearance == 0.0 && run.clearanceFactors.empty())
  {
    run.clearanceFactors = ClearanceAtHoles(domain, ResolveQuadSize(domain, options), quadsAtHoles);
  }
}

/// Returns whether two configurations for the same domain differ in a number of indices.
bool DifferInCounts(const Configuration& one, const Configuration& other)
{
  const auto counts = [](const Configuration& configuration)
  {
    std::map<int, int> found;
    for (const Singularity& singularity : configuration)
    {
      ++found[singularity.quarterIndex];
    }
    return found;
  };
  return counts(one) != counts(other);
}
}

double RequestedClearance(const PlanarDomain& domain, const AutomaticOptions& options)
{
  return options.optimizer.clearance != 0.0 ? options.optimizer.clearance
                                            : ClearanceForQuads(ResolveQuadSize(domain, options));
}

bool FitToQuads(const PlanarDomain& domain, const AutomaticOptions& options, double quadsAtHoles,
  bool movesForSizes, const Progress& progress, AutomaticConfiguration& result)
{
  OptimizerOptions fit = options.optimizer;
  fit.corners = result.corners;
  SetClearance(domain, options, quadsAtHoles, fit);
  fit.keepAll = true;
  fit.maximumSolves = options.maximumSolves / 2;
  const bool isUneven = fit.sizes.sizing == Sizing::Conformal && movesForSizes &&
    result.optimum.sizeSpread > options.acceptedSpread;
  if (isUneven)
  {
    fit.sizes.sizing = Sizing::Uniform;
  }
  const std::size_t before = result.optimum.solves;
  result.optimum =
    OptimizeSingularities(domain, result.singularities, fit, progress.Part(0.0, 0.7));
  const std::optional<std::size_t> left = SolvesLeft(fit.maximumSolves, result.optimum.solves);
  result.optimum.solves += before;
  result.singularities = result.optimum.configuration;
  AddEvents(result);
  if (options.proposal.given.empty() && !result.optimum.aborted && left)
  {
    fit.maximumSolves = *left;
    ImposeSymmetry(domain, fit, ResolveQuadSize(domain, options), progress.Part(0.7, 1.0), result);
  }
  if (fit.sizes.sizing != Sizing::Field && fit.pairs == 0 &&
    result.optimum.sizeSpread > options.acceptedSpread)
  {
    result.events.push_back(
      "Sizes are far from uniform: the standard deviation of their logarithm is " +
      FormatShort(result.optimum.sizeSpread) +
      "; pairs of singularities (Pairs, --pairs) may make them more uniform.");
  }
  if (options.proposal.given.empty())
  {
    // The energy is flat within a quarter of a quad, and the error of the mesh decides on which
    // side of the symmetric position its minimum is.
    MakeSymmetric(domain, FindCurveSymmetries(domain), 0.25 * ResolveQuadSize(domain, options),
      result.singularities);
  }
  return isUneven;
}

void FitOthers(const PlanarDomain& domain, const AutomaticOptions& options,
  const std::vector<ProposedConfiguration>& starts, const AutomaticConfiguration& minimum,
  bool isUneven, const Progress& progress, AutomaticConfiguration& best)
{
  // A minimum with a higher objective by more has hardly ever a better mesh.
  constexpr double LargestRise = 12.0;
  struct Candidate
  {
    AutomaticConfiguration configuration;
    double quadsAtHoles = UsualQuadsAtHoles;
    bool movesForSizes = false;
  };
  std::vector<Candidate> candidates;
  if (isUneven)
  {
    candidates.push_back({ minimum });
  }
  if (options.optimizer.clearance == 0.0 && !FindRoundHoles(domain).empty())
  {
    // Distances with which there are fewer blocks, or better shapes, in some parts.
    candidates.push_back({ minimum, 0.0, true });
    candidates.push_back({ minimum, 2.5, true });
  }
  int rank = 0;
  std::vector<ProposedConfiguration> sorted = starts;
  std::stable_sort(sorted.begin(), sorted.end(),
    [](const auto& a, const auto& b) { return a.objective < b.objective; });
  for (const ProposedConfiguration& start : sorted)
  {
    const bool isNew = DifferInCounts(start.singularities, minimum.singularities) &&
      std::none_of(candidates.begin(), candidates.end(),
        [&](const Candidate& other)
        { return !DifferInCounts(start.singularities, other.configuration.singularities); });
    if (isNew && start.objective < minimum.optimum.objective + LargestRise &&
      start.holonomyDefect < NoticeableDefect)
    {
      AutomaticConfiguration other;
      other.singularities = start.singularities;
      other.corners = start.corners;
      other.optimum.sizeSpread = start.sizeSpread;
      other.events = { DescribeChoice(other.singularities) + " Start: " + start.origin + "." };
      other.rank = ++rank;
      candidates.push_back({ std::move(other) });
    }
  }
  candidates.erase(candidates.begin() +
      static_cast<std::ptrdiff_t>(std::min(candidates.size(), options.configurations - 1)),
    candidates.end());
  // One that takes longer than the best is not worth it.
  AutomaticOptions limited = options;
  limited.maximumSolves = options.maximumSolves / 4;
  const double seen = 0.05 * ResolveQuadSize(domain, options);
  std::vector<AutomaticConfiguration>& others = best.others;
  const auto isSame = [&](const AutomaticConfiguration& one, const AutomaticConfiguration& other)
  {
    return std::equal(one.singularities.begin(), one.singularities.end(),
      other.singularities.begin(), other.singularities.end(),
      [&](const Singularity& a, const Singularity& b)
      { return a.quarterIndex == b.quarterIndex && (a.position - b.position).norm() < seen; });
  };
  for (Candidate& candidate : candidates)
  {
    AutomaticConfiguration& other = candidate.configuration;
    try
    {
      FitToQuads(domain, limited, candidate.quadsAtHoles, candidate.movesForSizes, progress, other);
      if (!isSame(other, best) &&
        std::none_of(others.begin(), others.end(),
          [&](const AutomaticConfiguration& known) { return isSame(known, other); }))
      {
        others.push_back(std::move(other));
      }
    }
    catch (const Error& error)
    {
      // It does not exist with this clearance; the best one does.
      best.events.push_back(std::string("Another configuration was not used: ") + error.what());
    }
  }
}
}
