#include "ConfigurationStarts.h"

#include "ConfigurationPairs.h"
#include "CornerClassification.h"
#include "CornerSets.h"
#include "DomainQueries.h"
#include "FieldConfiguration.h"
#include "GlobalSearch.h"

#include <cstdlib>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Removes the singularities that correspond to given ones: for each quarter of a given singularity
/// the closest one of the same sign.
void RemoveGiven(const Configuration& given, Configuration& found)
{
  for (const Singularity& singularity : given)
  {
    for (int i = 0; i < std::abs(singularity.quarterIndex); ++i)
    {
      auto nearest = found.end();
      for (auto other = found.begin(); other != found.end(); ++other)
      {
        const auto distance = [&singularity](const Singularity& candidate)
        { return (candidate.position - singularity.position).norm(); };
        if (other->quarterIndex * singularity.quarterIndex > 0 &&
          (nearest == found.end() || distance(*other) < distance(*nearest)))
        {
          nearest = other;
        }
      }
      if (nearest != found.end())
      {
        found.erase(nearest);
      }
    }
  }
}

/// Adds pairs of opposite signs until TooFewForHolonomy is false, or there is no space for more.
void AddPairsForHolonomy(const PlanarDomain& domain, Configuration& configuration)
{
  while (TooFewForHolonomy(domain, configuration) && AddPair(domain, configuration))
  {
  }
}

/// Collects starting configurations.
class StartCollection
{
public:
  StartCollection(const PlanarDomain& domain, const ProposalOptions& options)
    : Domain(domain)
    , Options(options)
  {
  }

  /// Adds a configuration that lacks the given singularities, completed to the required sum.
  void Add(const Configuration& further, const std::vector<CornerChoice>& corners,
    const std::string& origin)
  {
    auto spread = static_cast<const SpreadOptions&>(this->Options);
    spread.corners = corners;
    spread.given.insert(spread.given.end(), further.begin(), further.end());
    ProposedConfiguration proposal;
    proposal.singularities = SpreadConfiguration(this->Domain, spread);
    proposal.corners = corners;
    proposal.origin = origin;
    proposal.variation = corners.size() > this->Options.corners.size();
    this->Add(std::move(proposal));
  }

  /// Adds the configuration of a Ginzburg-Landau field, and the same without pairs.
  void AddField(
    const CoarseField& coarse, const std::vector<CornerChoice>& corners, const std::string& suffix)
  {
    FieldConfigurationOptions reading;
    reading.cornerAngle = this->Options.cornerAngle;
    reading.corners = corners;
    Configuration found = ReadConfiguration(this->Domain, coarse, reading).singularities;
    RemoveGiven(this->Options.given, found);
    this->Add(found, corners, "Ginzburg-Landau field" + suffix);
    const std::size_t all = found.size();
    CancelOpposites(found, std::numeric_limits<double>::infinity());
    if (found.size() < all)
    {
      this->Add(found, corners, "Ginzburg-Landau field without pairs" + suffix);
    }
  }

  /// Adds the best configurations of the search among candidate sites. Returns whether there are any.
  bool AddSearch(const Progress& progress)
  {
    // The minima of the positions may be lower than the sites by this much.
    constexpr double SiteError = 8.0;
    constexpr std::size_t MostStarts = 4;
    constexpr std::size_t ManySingularities = 100; // each start takes long, and they hardly differ
    const std::vector<SearchedConfiguration> found =
      SearchConfigurations(this->Domain, this->Options, progress);
    const std::size_t first = this->Starts.size();
    const bool isLarge = !found.empty() && found[0].singularities.size() > ManySingularities;
    for (const SearchedConfiguration& one : found)
    {
      if (this->Starts.size() < first + (isLarge ? 1 : MostStarts) &&
        one.objective < found.front().objective + SiteError)
      {
        ProposedConfiguration start;
        start.singularities = one.singularities;
        start.corners = this->Options.corners;
        start.origin = "search";
        start.clearance = SiteClearance(this->Domain);
        this->Add(std::move(start));
      }
    }
    return !found.empty();
  }

  /// Adds the first start with two singularities merged, and with an additional pair.
  void AddVariations()
  {
    const ProposedConfiguration first = this->Starts.front();
    ProposedConfiguration merged = first;
    merged.variation = true;
    if (MergeNearest(this->Domain, merged.singularities))
    {
      merged.origin += ", two merged";
      this->Starts.push_back(std::move(merged));
    }
    ProposedConfiguration pair = first;
    pair.variation = true;
    if (AddPair(this->Domain, pair.singularities))
    {
      pair.origin += ", additional pair";
      this->Starts.push_back(std::move(pair));
    }
  }

  std::vector<ProposedConfiguration> Release() { return std::move(this->Starts); }

private:
  /// Adds a start, and if it has too few singularities another one with pairs.
  void Add(ProposedConfiguration start)
  {
    this->Starts.push_back(start);
    if (TooFewForHolonomy(this->Domain, start.singularities))
    {
      AddPairsForHolonomy(this->Domain, start.singularities);
      start.origin += ", pairs for holonomy";
      this->Starts.push_back(std::move(start));
    }
  }

  const PlanarDomain& Domain;
  const ProposalOptions& Options;
  std::vector<ProposedConfiguration> Starts;
};

/// Returns the corners that are given, and those for which the classifier chooses another index
/// than the smallest rotation.
std::vector<CornerChoice> ClassifiedChoices(
  const PlanarDomain& domain, const ProposalOptions& options)
{
  ClassificationOptions classification =
    ClassificationBeside(options.corners, domain, options.cornerAngle);
  classification.splitHalves = true;
  std::vector<CornerChoice> choices = options.corners;
  for (const ClassifiedCorner& corner : ClassifyCorners(domain, classification).corners)
  {
    if (!corner.overridden && corner.quarterIndex != corner.conventional)
    {
      choices.push_back({ corner.position, corner.quarterIndex });
    }
  }
  return choices;
}
}

std::vector<ProposedConfiguration> FindStarts(
  const PlanarDomain& domain, const ProposalOptions& options, const Progress& progress)
{
  StartCollection collection(domain, options);
  if (!options.cancelFlatCorners)
  {
    const bool isSearched = options.given.empty() && collection.AddSearch(progress.Part(0.0, 0.5));
    if (isSearched && !options.chooseCorners && !options.variations)
    {
      return collection.Release();
    }
    const FieldConfigurationOptions reading{ options.cornerAngle, options.corners };
    const CoarseField coarse = SolveCoarseField(domain, reading, progress.Part(0.5, 1.0));
    collection.AddField(coarse, options.corners, "");
    if (options.chooseCorners)
    {
      std::vector<CornerChoice> fieldCorners = options.corners;
      for (const CornerChoice& corner : ReadConfiguration(domain, coarse, reading).otherCorners)
      {
        if (FindChoice(options.corners, corner.position, domain) == nullptr)
        {
          fieldCorners.push_back(corner);
        }
      }
      if (fieldCorners.size() > options.corners.size())
      {
        collection.AddField(coarse, fieldCorners, ", corners of the field");
      }
      const std::vector<CornerChoice> cheapest = ClassifiedChoices(domain, options);
      if (cheapest.size() > options.corners.size())
      {
        collection.AddField(coarse, cheapest, ", cheapest corners");
      }
      CornerSetOptions sets;
      sets.cornerAngle = options.cornerAngle;
      sets.given = options.corners;
      sets.fieldCorners = fieldCorners;
      sets.known = { fieldCorners, cheapest };
      for (const std::vector<CornerChoice>& corners : FindCornerSets(domain, sets))
      {
        collection.AddField(coarse, corners, ", other corners");
      }
    }
  }
  collection.Add({}, options.corners, "spread");
  if (options.variations)
  {
    collection.AddVariations();
  }
  return collection.Release();
}
}
