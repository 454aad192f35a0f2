#include "ConfigurationProposal.h"

#include "BoundaryCorners.h"
#include "ConfigurationEnergy.h"
#include "ConfigurationStarts.h"
#include "ConfigurationSymmetry.h"
#include "CornerEnergy.h"
#include "CurveSymmetry.h"
#include "DomainQueries.h"
#include "Parts.h"
#include "PoincareHopf.h"
#include "SingularityOptimizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Improves proposals by a few steps of the optimiser and by the symmetry of the domain, unless
/// given singularities must keep their positions, and computes their energies.
class ProposalEvaluation
{
public:
  ProposalEvaluation(const PlanarDomain& domain, const ProposalOptions& options)
    : Domain(domain)
    , Options(options)
    , Symmetries(FindCurveSymmetries(domain))
    , Radius(ResolveCoreRadius(options.coreRadius, domain))
    , IsFree(options.given.empty() && !options.cancelFlatCorners)
  {
  }

  double GetCoreRadius() const { return this->Radius; }

  /// Meshes the domain for a proposal.
  std::unique_ptr<PreparedOptimization> Prepare(
    const ProposedConfiguration& proposal, const Progress& progress) const
  {
    constexpr int Steps = 8; // usually most of the decrease
    return this->Prepare(proposal, this->IsFree ? Steps : 0, progress);
  }

  /// Returns the objective of a start above which it is not improved: if it would have to lower it
  /// by more than one core energy, 2π, for each of at most 48 singularities to reach the lowest of
  /// the others. Many singularities are slow to improve, and another start has
  /// found their places.
  static double MaximumStart(const ProposedConfiguration& proposal, double lowest)
  {
    constexpr std::size_t ManySingularities = 48;
    return lowest +
      2.0 * Pi * static_cast<double>(std::min(proposal.singularities.size(), ManySingularities));
  }

  /// Evaluates a proposal. Returns the highest objective of the starts of its runs: with a bound that
  /// is not below it, the result would be the same. Throws Aborted.
  double Evaluate(PreparedOptimization& prepared, double maximumStart, const Progress& progress,
    ProposedConfiguration& proposal) const
  {
    double highestStart = prepared.StartObjective();
    OptimizerResult trial = Run(prepared, maximumStart, progress.Part(0.0, 0.8));
    proposal.singularities = trial.configuration;
    if (this->IsFree)
    {
      // The position of a singularity in the field is known to an edge of its mesh, usually a
      // seventieth of the diagonal.
      if (MakeSymmetric(
            this->Domain, this->Symmetries, 0.02 * this->Domain.Diagonal(), proposal.singularities))
      {
        const auto symmetric = this->Prepare(proposal, 0, progress.Part(0.8, 1.0));
        highestStart = std::max(highestStart, symmetric->StartObjective());
        trial = Run(*symmetric, maximumStart, progress.Part(0.8, 1.0));
      }
    }
    proposal.renormalized = trial.energyAfter;
    proposal.logarithmCoefficient = LogarithmCoefficient(
      this->Domain, proposal.singularities, proposal.corners, this->Options.cornerAngle);
    proposal.energy = proposal.renormalized -
      proposal.logarithmCoefficient * std::log(this->Radius) +
      CoreOverlapEnergy(proposal.singularities, this->Radius);
    proposal.objective = trial.objective;
    proposal.sizeSpread = trial.sizeSpread;
    for (const double defect : trial.holonomyDefect)
    {
      proposal.holonomyDefect = std::max(proposal.holonomyDefect, std::abs(defect));
    }
    return highestStart;
  }

private:
  std::unique_ptr<PreparedOptimization> Prepare(
    const ProposedConfiguration& proposal, int steps, const Progress& progress) const
  {
    OptimizerOptions options;
    options.corners = proposal.corners;
    options.maximumIterations = steps;
    options.clearance = proposal.clearance;
    options.keepAll = true; // the configuration is ranked as proposed
    return std::make_unique<PreparedOptimization>(
      this->Domain, proposal.singularities, options, progress);
  }

  static OptimizerResult Run(
    PreparedOptimization& prepared, double maximumStart, const Progress& progress)
  {
    OptimizerResult result = prepared.Run(maximumStart, progress);
    if (result.aborted)
    {
      throw Aborted();
    }
    return result;
  }

  const PlanarDomain& Domain;
  const ProposalOptions& Options;
  SymmetryGroup Symmetries;
  double Radius;
  bool IsFree;
};

/// Evaluates proposals in their order; the lowest objective so far bounds the starts of the next ones.
/// With several threads, as many proposals are prepared at the same time, and those that seem to be
/// below the bound are evaluated ahead. If the bound turns out to be lower than the start of one,
/// it is evaluated again, so the result is the same with any number of threads.
void EvaluateAll(const ProposalEvaluation& evaluation, const Progress& progress,
  std::vector<ProposedConfiguration>& proposals)
{
  const auto width = static_cast<std::size_t>(ThreadsOfParts());
  double lowest = std::numeric_limits<double>::infinity();
  const auto partOf = [&](std::size_t i)
  {
    const auto count = static_cast<double>(proposals.size());
    return progress.Part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count);
  };
  for (std::size_t begin = 0; begin < proposals.size(); begin += width)
  {
    const std::size_t count = std::min(width, proposals.size() - begin);
    std::vector<std::unique_ptr<PreparedOptimization>> prepared(count);
    ForParts(count,
      [&](std::size_t i)
      {
        prepared[i] = evaluation.Prepare(
          proposals[begin + i], count == 1 ? partOf(begin).Part(0.0, 0.8) : Progress());
      });

    // Those that are below the bound if the others do not improve.
    struct Ahead
    {
      ProposedConfiguration proposal;
      double highestStart = 0.0;
    };
    std::vector<std::optional<Ahead>> ahead(count);
    std::vector<std::size_t> members;
    double expected = lowest;
    for (std::size_t i = 0; i < count && count > 1; ++i)
    {
      const ProposedConfiguration& proposal = proposals[begin + i];
      const double start = prepared[i]->StartObjective();
      if (start <= ProposalEvaluation::MaximumStart(proposal, expected))
      {
        members.push_back(i);
      }
      expected = proposal.variation ? expected : std::min(expected, start);
    }
    ForParts(members.size(),
      [&](std::size_t part)
      {
        const std::size_t i = members[part];
        Ahead result{ proposals[begin + i] };
        result.highestStart = evaluation.Evaluate(*prepared[i],
          ProposalEvaluation::MaximumStart(result.proposal, lowest), {}, result.proposal);
        ahead[i] = std::move(result);
      });

    for (std::size_t i = 0; i < count; ++i)
    {
      ProposedConfiguration& proposal = proposals[begin + i];
      const Progress part = partOf(begin + i);
      const double bound = ProposalEvaluation::MaximumStart(proposal, lowest);
      if (ahead[i] && ahead[i]->highestStart <= bound)
      {
        proposal = std::move(ahead[i]->proposal);
      }
      else
      {
        if (ahead[i])
        {
          prepared[i] = evaluation.Prepare(proposal, part.Part(0.0, 0.8));
        }
        evaluation.Evaluate(*prepared[i], bound, part, proposal);
      }
      prepared[i].reset();
      lowest = proposal.variation ? lowest : std::min(lowest, proposal.objective);
      part.Report(1.0);
    }
  }
}

Configuration AsPoints(const std::vector<CornerChoice>& corners)
{
  Configuration points;
  for (const CornerChoice& corner : corners)
  {
    points.push_back({ corner.position, corner.quarterIndex, 0.0 });
  }
  return points;
}

/// Returns whether cores of a radius overlap: the energy at that radius is then meaningless, and
/// decreases as they approach each other.
bool CoresOverlap(const Configuration& configuration, double radius)
{
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      if ((configuration[i].position - configuration[j].position).norm() < 2.0 * radius)
      {
        return true;
      }
    }
  }
  return false;
}

/// Returns whether two configurations are equal within a distance, in any order.
bool AreEqual(const Configuration& a, Configuration b, double distance)
{
  for (const Singularity& singularity : a)
  {
    const auto match = std::find_if(b.begin(), b.end(),
      [&](const Singularity& other)
      {
        return other.quarterIndex == singularity.quarterIndex &&
          (other.position - singularity.position).norm() <= distance;
      });
    if (match == b.end())
    {
      return false;
    }
    b.erase(match);
  }
  return b.empty();
}
}

bool MakeSymmetric(const PlanarDomain& domain, const SymmetryGroup& symmetries, double distance,
  Configuration& singularities)
{
  const ConfigurationSymmetry symmetry = MatchSymmetry(singularities, symmetries, distance);
  if (symmetry.IsTrivial())
  {
    return false;
  }
  Configuration moved = singularities;
  symmetry.Project(moved);
  const double reach = BoundaryReach * domain.Diagonal();
  for (std::size_t i = 0; i < moved.size(); ++i)
  {
    const double before = SignedDistance(singularities[i].position, domain);
    const double after = SignedDistance(moved[i].position, domain);
    if (before > reach ? after <= reach : std::abs(after) > reach)
    {
      return false;
    }
  }
  singularities = std::move(moved);
  return true;
}

double LogarithmCoefficient(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners, double cornerAngle)
{
  double coefficient = 0.0;
  for (const Singularity& singularity : configuration)
  {
    coefficient += Pi * singularity.quarterIndex * singularity.quarterIndex;
  }
  for (const CountedCorner& corner :
    CountQuarters(domain.loops, TotalQuarters(configuration), cornerAngle, corners).corners)
  {
    coefficient += 16.0 * CornerEnergy(corner.angle, corner.quarterIndex);
  }
  return coefficient;
}

std::vector<ProposedConfiguration> ProposeConfigurations(
  const PlanarDomain& domain, const ProposalOptions& options, const Progress& progress)
{
  RequireInside(domain, options.given);
  std::vector<ProposedConfiguration> proposals =
    FindStarts(domain, options, progress.Part(0.0, 0.5));
  const double diagonal = domain.Diagonal();
  const ProposalEvaluation evaluation(domain, options);
  const double coreRadius = evaluation.GetCoreRadius();
  EvaluateAll(evaluation, progress.Part(0.5, 1.0), proposals);

  // Radians; a defect that can vanish is below this after a few steps.
  constexpr double DefectTolerance = 0.05;
  const auto rank = [&domain](const ProposedConfiguration& proposal)
  {
    const bool unreachable = proposal.holonomyDefect > DefectTolerance &&
      TooFewForHolonomy(domain, proposal.singularities);
    return std::make_tuple(proposal.variation, unreachable, proposal.objective);
  };
  std::stable_sort(proposals.begin(), proposals.end(),
    [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
  // All others are sorted by their energy alone, as people compare them.
  std::stable_sort(proposals.begin() + 1, proposals.end(),
    [](const auto& a, const auto& b) { return a.energy < b.energy; });
  std::vector<ProposedConfiguration> distinct;
  for (ProposedConfiguration& proposal : proposals)
  {
    if (proposal.variation && CoresOverlap(proposal.singularities, coreRadius))
    {
      continue; // a pair that has almost met
    }
    const bool repeated = std::any_of(distinct.begin(), distinct.end(),
      [&](const ProposedConfiguration& better)
      {
        return AreEqual(better.singularities, proposal.singularities, 0.01 * diagonal) &&
          AreEqual(AsPoints(better.corners), AsPoints(proposal.corners), 0.0);
      });
    if (!repeated)
    {
      // Without radii of given singularities, the others have none either: a radius of 0 could not
      // be drilled.
      if (std::all_of(options.given.begin(), options.given.end(),
            [](const Singularity& given) { return given.radius > 0.0; }))
      {
        AssignRadii(domain, proposal.singularities, options.given.size());
      }
      distinct.push_back(std::move(proposal));
    }
  }
  return distinct;
}
}
