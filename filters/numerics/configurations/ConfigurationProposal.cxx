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
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// The optimiser's result, unless it was aborted.
OptimizerResult Optimize(const PlanarDomain& domain, const ProposedConfiguration& proposal,
  int steps, const Progress& progress)
{
  OptimizerOptions options;
  options.corners = proposal.corners;
  options.maximumIterations = steps;
  options.keepAll = true; // what it was proposed as is what is ranked
  OptimizerResult result = OptimizeSingularities(domain, proposal.singularities, options, progress);
  if (result.aborted)
  {
    throw Aborted();
  }
  return result;
}

/// A few steps of the optimiser and the symmetry of the domain, unless some have to stay where they are, and
/// what the result costs.
void Try(const PlanarDomain& domain, const SymmetryGroup& symmetries,
  const ProposalOptions& options, double coreRadius, const Progress& progress,
  ProposedConfiguration& proposal)
{
  const bool mayMove = options.given.empty() && !options.cancelFlatCorners;
  constexpr int Steps = 8; // most of the way, as a rule
  OptimizerResult trial = Optimize(domain, proposal, mayMove ? Steps : 0, progress.Part(0.0, 0.8));
  proposal.singularities = trial.configuration;
  if (mayMove)
  {
    // The field is read within an edge of its mesh, a seventieth of the diagonal, as a rule.
    const ConfigurationSymmetry symmetry =
      MatchSymmetry(proposal.singularities, symmetries, 0.02 * domain.Diagonal());
    if (!symmetry.IsTrivial())
    {
      symmetry.Project(proposal.singularities);
      trial = Optimize(domain, proposal, 0, progress.Part(0.8, 1.0));
    }
  }
  proposal.renormalized = trial.energyAfter;
  proposal.logarithmCoefficient =
    LogarithmCoefficient(domain, proposal.singularities, proposal.corners, options.cornerAngle);
  proposal.energy = proposal.renormalized - proposal.logarithmCoefficient * std::log(coreRadius);
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

/// Whether cores of this radius overlap: then the energy at it means nothing, and is the lower the nearer they are.
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

/// Whether two configurations are the same within a distance, in whatever order.
bool Same(const Configuration& a, Configuration b, double distance)
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
  for (std::size_t i = 0; i < proposals.size(); ++i)
  {
    const auto part = [&](std::size_t number)
    { return 0.5 + 0.5 * static_cast<double>(number) / static_cast<double>(proposals.size()); };
    Try(domain, symmetries, options, coreRadius, progress.Part(part(i), part(i + 1)), proposals[i]);
  }

  // The best first, each once.
  constexpr double Vanishing = 0.05; // radians; what a few steps leave of a defect that can vanish
  const auto rank = [&domain](const ProposedConfiguration& proposal)
  {
    const bool hopeless =
      proposal.holonomyDefect > Vanishing && TooFewForHolonomy(domain, proposal.singularities);
    return std::make_tuple(proposal.variation, hopeless, proposal.energy);
  };
  std::stable_sort(proposals.begin(), proposals.end(),
    [&rank](const auto& a, const auto& b) { return rank(a) < rank(b); });
  // The others, whatever they are, by their energy alone.
  std::stable_sort(proposals.begin() + 1, proposals.end(),
    [](const auto& a, const auto& b) { return a.energy < b.energy; });
  std::vector<ProposedConfiguration> distinct;
  for (ProposedConfiguration& proposal : proposals)
  {
    if (proposal.variation && CoresOverlap(proposal.singularities, coreRadius))
    {
      continue; // a pair that has all but met
    }
    const bool repeated = std::any_of(distinct.begin(), distinct.end(),
      [&](const ProposedConfiguration& better)
      {
        return Same(better.singularities, proposal.singularities, 0.01 * diagonal) &&
          Same(AsPoints(better.corners), AsPoints(proposal.corners), 0.0);
      });
    if (!repeated)
    {
      // Where given ones go without, so do the others: a radius of 0 could not be drilled.
      if (std::all_of(options.given.begin(), options.given.end(),
            [](const Singularity& given) { return given.radius > 0.0; }))
      {
        GiveRadii(domain, proposal.singularities, options.given.size());
      }
      distinct.push_back(std::move(proposal));
    }
  }
  return distinct;
}
}
