#include "ConfigurationProposal.h"

#include "ConfigurationEnergy.h"
#include "ConfigurationStarts.h"
#include "ConfigurationSymmetry.h"
#include "CornerEnergy.h"
#include "DomainQueries.h"
#include "PoincareHopf.h"
#include "SingularityOptimizer.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the result of the optimiser. Throws Aborted if it was aborted.
OptimizerResult Optimize(const PlanarDomain& domain, const ProposedConfiguration& proposal,
  int steps, double maximumStart, const Progress& progress)
{
  OptimizerOptions options;
  options.maximumStart = maximumStart;
  options.corners = proposal.corners;
  options.maximumIterations = steps;
  options.keepAll = true; // the configuration is ranked as proposed
  OptimizerResult result = OptimizeSingularities(domain, proposal.singularities, options, progress);
  if (result.aborted)
  {
    throw Aborted();
  }
  return result;
}

/// Improves a proposal by a few steps of the optimiser and by the symmetry of the domain, unless
/// given singularities must keep their positions, and computes its energies. `lowest`: the lowest
/// energy of the others. A start that would have to lower its energy by more than one core energy,
/// 2π, for each of at most 48 singularities to reach it is not improved.
void Evaluate(const PlanarDomain& domain, const SymmetryGroup& symmetries,
  const ProposalOptions& options, double coreRadius, double lowest, const Progress& progress,
  ProposedConfiguration& proposal)
{
  // Many singularities are slow to improve, and another start has found their places.
  constexpr std::size_t ManySingularities = 48;
  const double maximumStart = lowest +
    2.0 * Pi * static_cast<double>(std::min(proposal.singularities.size(), ManySingularities));

  const bool isFree = options.given.empty() && !options.cancelFlatCorners;
  constexpr int Steps = 8; // usually most of the decrease
  OptimizerResult trial =
    Optimize(domain, proposal, isFree ? Steps : 0, maximumStart, progress.Part(0.0, 0.8));
  proposal.singularities = trial.configuration;
  if (isFree)
  {
    // The position of a singularity in the field is known to an edge of its mesh, usually a
    // seventieth of the diagonal.
    const ConfigurationSymmetry symmetry =
      MatchSymmetry(proposal.singularities, symmetries, 0.02 * domain.Diagonal());
    if (!symmetry.IsTrivial())
    {
      symmetry.Project(proposal.singularities);
      trial = Optimize(domain, proposal, 0, maximumStart, progress.Part(0.8, 1.0));
    }
  }
  proposal.renormalized = trial.energyAfter;
  proposal.logarithmCoefficient =
    LogarithmCoefficient(domain, proposal.singularities, proposal.corners, options.cornerAngle);
  proposal.energy = proposal.renormalized - proposal.logarithmCoefficient * std::log(coreRadius) +
    CoreOverlapEnergy(proposal.singularities, coreRadius);
  proposal.sizeSpread = trial.sizeSpread;
  for (const double defect : trial.holonomyDefect)
  {
    proposal.holonomyDefect = std::max(proposal.holonomyDefect, std::abs(defect));
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
  const double coreRadius = ResolveCoreRadius(options.coreRadius, domain);
  const SymmetryGroup symmetries = FindSymmetries(domain);
  double lowest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < proposals.size(); ++i)
  {
    const auto part = [&](std::size_t number)
    { return 0.5 + 0.5 * static_cast<double>(number) / static_cast<double>(proposals.size()); };
    Evaluate(domain, symmetries, options, coreRadius, lowest, progress.Part(part(i), part(i + 1)),
      proposals[i]);
    lowest = proposals[i].variation ? lowest : std::min(lowest, proposals[i].energy);
  }

  // Radians; a defect that can vanish is below this after a few steps.
  constexpr double DefectTolerance = 0.05;
  const auto rank = [&domain](const ProposedConfiguration& proposal)
  {
    const bool unreachable = proposal.holonomyDefect > DefectTolerance &&
      TooFewForHolonomy(domain, proposal.singularities);
    return std::make_tuple(proposal.variation, unreachable, proposal.energy);
  };
  std::stable_sort(proposals.begin(), proposals.end(),
    [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
  // All others are sorted by energy alone.
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
