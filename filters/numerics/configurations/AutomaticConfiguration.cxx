#include "AutomaticConfiguration.h"

#include "CurveSymmetry.h"
#include "DrillHoles.h"
#include "Error.h"
#include "HolePattern.h"
#include "LoopGap.h"
#include "MeshBudget.h"
#include "OptimizerReport.h"
#include "OptimizerStage.h"
#include "OptimizerSymmetry.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <sstream>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns a sentence such as "6 singularities were chosen: 5 of quarter index 1, 1 of quarter
/// index -1."
std::string DescribeChoice(const Configuration& configuration)
{
  std::map<int, int> counts;
  for (const Singularity& singularity : configuration)
  {
    ++counts[singularity.quarterIndex];
  }
  std::ostringstream text;
  if (configuration.empty())
  {
    return "The domain needs no singularities.";
  }
  text << configuration.size()
       << (configuration.size() == 1 ? " singularity was chosen" : " singularities were chosen");
  const char* separator = ": ";
  for (auto count = counts.rbegin(); count != counts.rend(); ++count)
  {
    text << separator << count->second << " of quarter index " << count->first;
    separator = ", ";
  }
  text << ".";
  return text.str();
}

std::string DescribeOptimum(const OptimizerResult& optimum)
{
  std::ostringstream text;
  text << "The renormalised energy went from " << optimum.energyBefore << " to "
       << optimum.energyAfter << " in " << optimum.iterations << " steps";
  if (optimum.sizeSpreads)
  {
    text << ", the spread of sizes from " << optimum.sizeSpreads->before << " to "
         << optimum.sizeSpreads->after;
  }
  text << ". " << optimum.reason;
  return text.str();
}

double LargestDefect(const OptimizerResult& optimum)
{
  double largest = 0.0;
  for (const double defect : optimum.holonomyDefect)
  {
    largest = std::max(largest, std::abs(defect));
  }
  return largest;
}

/// Returns whether a run converged with a single-valued H.
bool HasConvergedWithoutDefect(const OptimizerResult& optimum)
{
  return optimum.converged && LargestDefect(optimum) < NoticeableDefect;
}

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

/// Returns the size of the quads for which singularities are chosen, 0 if no quads will be made.
double ResolveQuadSize(const PlanarDomain& domain, const AutomaticOptions& options)
{
  return options.quadSize == 0.0 && options.quadCount > 0
    ? std::sqrt(domain.Area() / options.quadCount)
    : options.quadSize;
}

/// Returns the requested clearance, 0 for the default.
double RequestedClearance(const PlanarDomain& domain, const AutomaticOptions& options)
{
  return options.optimizer.clearance != 0.0 ? options.optimizer.clearance
                                            : ClearanceForQuads(ResolveQuadSize(domain, options));
}

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

/// Adds the events of the last run.
void AddEvents(AutomaticConfiguration& result)
{
  const OptimizerResult& optimum = result.optimum;
  result.events.insert(result.events.end(), optimum.events.begin(), optimum.events.end());
  result.events.push_back(DescribeOptimum(optimum));
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

/// If singularities have more symmetries of the domain after moves of at most `distance`, continues
/// from there, within the solves that `options` leave, and uses the result if it has more
/// symmetries and its energy is higher by less than these are worth.
void ImposeSymmetry(const PlanarDomain& domain, const OptimizerOptions& options, double distance,
  const Progress& progress, AutomaticConfiguration& result)
{
  const SymmetryGroup group = FindCurveSymmetries(domain);
  const auto count = [&](const Configuration& singularities, double reach)
  { return MatchSymmetry(singularities, group, reach).elements.size(); };
  const double exact = SymmetryReach * domain.Diagonal();
  const std::size_t before = count(result.singularities, exact);
  Configuration symmetric = result.singularities;
  if (count(symmetric, distance) <= before || !MakeSymmetric(domain, group, distance, symmetric))
  {
    return;
  }
  OptimizerResult tried = OptimizeSingularities(domain, symmetric, options, progress);
  tried.solves += result.optimum.solves;
  result.optimum.solves = tried.solves;
  result.optimum.aborted = tried.aborted;
  const std::size_t after = count(tried.configuration, exact);
  if (tried.aborted || after <= before) // they may be a saddle
  {
    return;
  }
  // Sizes that differ by so much more are not seen in a mesh.
  constexpr double SameSpread = 0.02;
  const double rise = tried.coreEnergy - result.optimum.coreEnergy;
  const bool isBetter =
    HasConvergedWithoutDefect(tried) >= HasConvergedWithoutDefect(result.optimum) &&
    tried.sizeSpread <= result.optimum.sizeSpread + SameSpread &&
    rise < WorthOfSymmetries(after) - WorthOfSymmetries(before);
  std::ostringstream text;
  text << "Positions with " << after << " instead of " << before
       << " symmetries of the domain, counting the identity, " << (isBetter ? "are" : "were not")
       << " used: their energy is " << FormatNumber(std::abs(rise), 3)
       << (rise < 0.0 ? " lower" : " higher") << ", their spread of sizes "
       << FormatNumber(tried.sizeSpread, 3) << " instead of "
       << FormatNumber(result.optimum.sizeSpread, 3) << ".";
  result.events.push_back(text.str());
  if (isBetter)
  {
    result.optimum = std::move(tried);
    result.singularities = result.optimum.configuration;
    AddEvents(result);
  }
}

/// Returns a limit of solves less those that were made, 0 for any number; none if it is reached.
std::optional<std::size_t> SolvesLeft(std::size_t limit, std::size_t made)
{
  return limit == 0 ? std::optional<std::size_t>(0)
    : made < limit  ? std::optional<std::size_t>(limit - made)
                    : std::nullopt;
}

/// Continues the optimisation from the minimum of the energy with the clearance for quads, towards
/// the target sizes if there are any, or towards uniform sizes if the sizes are far from uniform
/// and `movesForSizes`. Returns whether it was for the latter.
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

/// Fits other configurations to quads: `minimum`, which is the best one before it was fitted, in
/// other ways, and starts with other numbers of singularities.
std::vector<AutomaticConfiguration> FitOthers(const PlanarDomain& domain,
  const AutomaticOptions& options, const std::vector<ProposedConfiguration>& starts,
  const AutomaticConfiguration& minimum, const AutomaticConfiguration& best, bool isUneven,
  const Progress& progress)
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
  std::vector<AutomaticConfiguration> others;
  const auto isSame = [&](const AutomaticConfiguration& one, const AutomaticConfiguration& other)
  {
    return std::equal(one.singularities.begin(), one.singularities.end(),
      other.singularities.begin(), other.singularities.end(),
      [&](const Singularity& a, const Singularity& b)
      { return a.quarterIndex == b.quarterIndex && (a.position - b.position).norm() < seen; });
  };
  for (auto& [other, quadsAtHoles, movesForSizes] : candidates)
  {
    try
    {
      FitToQuads(domain, limited, quadsAtHoles, movesForSizes, progress, other);
      if (!isSame(other, best) &&
        std::none_of(others.begin(), others.end(),
          [&](const AutomaticConfiguration& known) { return isSame(known, other); }))
      {
        others.push_back(std::move(other));
      }
    }
    catch (const Error&)
    {
      // It does not exist with this clearance; the best one does.
    }
  }
  return others;
}
}

double ClearanceForQuads(double quadSize)
{
  // The meshes of the gallery have their best shapes at 0.7 to 1.
  return 0.7 * quadSize;
}

ClearanceFactors ClearanceAtHoles(const PlanarDomain& domain, double quadSize, double quads)
{
  const double least = ClearanceForQuads(quadSize);
  ClearanceFactors factors;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    const double distance =
      l == 0 ? 0.0 : std::min(quads * quadSize, 0.5 * GapAround(domain, l) - quadSize);
    factors.emplace_back(domain.loops[l].size(), std::max(1.0, distance / least));
  }
  return factors;
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
      best.others =
        FitOthers(domain, options, starts, unfitted, best, isUneven, progress.Part(0.95, 1.0));
    }
  }
  return best;
}
}
