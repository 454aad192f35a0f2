#include "ConfigurationStarts.h"

#include "ConfigurationPairs.h"
#include "CornerClassification.h"
#include "CornerSets.h"
#include "FieldConfiguration.h"

#include <cstdlib>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Takes from a configuration what stands for given singularities: for every quarter of theirs the
/// nearest one of its sign.
void TakeGiven(const Configuration& given, Configuration& seen)
{
  for (const Singularity& singularity : given)
  {
    for (int i = 0; i < std::abs(singularity.quarterIndex); ++i)
    {
      auto nearest = seen.end();
      for (auto other = seen.begin(); other != seen.end(); ++other)
      {
        const auto apart = [&singularity](const Singularity& candidate)
        { return (candidate.position - singularity.position).norm(); };
        if (other->quarterIndex * singularity.quarterIndex > 0 &&
          (nearest == seen.end() || apart(*other) < apart(*nearest)))
        {
          nearest = other;
        }
      }
      if (nearest != seen.end())
      {
        seen.erase(nearest);
      }
    }
  }
}

/// Adds pairs of opposite signs until TooFewForHolonomy is false, or there is no room for more.
void AddForHolonomy(const PlanarDomain& domain, Configuration& configuration)
{
  while (TooFewForHolonomy(domain, configuration) && AddPair(domain, configuration))
  {
  }
}

/// Collects starts that differ.
class Collection
{
public:
  Collection(const PlanarDomain& domain, const ProposalOptions& options)
    : Domain(domain)
    , Options(options)
  {
  }

  /// Adds a configuration without the given ones, completed by what it lacks.
  void Add(
    const Configuration& more, const std::vector<CornerChoice>& corners, const std::string& origin)
  {
    auto spread = static_cast<const SpreadOptions&>(this->Options);
    spread.corners = corners;
    spread.given.insert(spread.given.end(), more.begin(), more.end());
    ProposedConfiguration proposal;
    proposal.singularities = SpreadConfiguration(this->Domain, spread);
    proposal.corners = corners;
    proposal.origin = origin;
    proposal.variation = corners.size() > this->Options.corners.size();
    this->Starts.push_back(proposal);
    if (TooFewForHolonomy(this->Domain, proposal.singularities))
    {
      AddForHolonomy(this->Domain, proposal.singularities);
      proposal.origin += ", pairs for holonomy";
      this->Starts.push_back(std::move(proposal));
    }
  }

  /// What a Ginzburg-Landau field shows, and the same without pairs.
  void AddField(
    const CoarseField& coarse, const std::vector<CornerChoice>& corners, const std::string& suffix)
  {
    FieldConfigurationOptions reading;
    reading.cornerAngle = this->Options.cornerAngle;
    reading.corners = corners;
    Configuration seen = ReadConfiguration(this->Domain, coarse, reading).singularities;
    TakeGiven(this->Options.given, seen);
    this->Add(seen, corners, "Ginzburg-Landau field" + suffix);
    const std::size_t all = seen.size();
    CancelOpposites(seen, std::numeric_limits<double>::infinity());
    if (seen.size() < all)
    {
      this->Add(seen, corners, "Ginzburg-Landau field without pairs" + suffix);
    }
  }

  /// The first one with two merged, and with a pair more.
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
      pair.origin += ", a pair more";
      this->Starts.push_back(std::move(pair));
    }
  }

  std::vector<ProposedConfiguration> Take() { return std::move(this->Starts); }

private:
  const PlanarDomain& Domain;
  const ProposalOptions& Options;
  std::vector<ProposedConfiguration> Starts;
};

/// The chosen corners of a classification, beside those already chosen.
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
  Collection collection(domain, options);
  if (!options.cancelFlatCorners)
  {
    const FieldConfigurationOptions reading{ options.cornerAngle, options.corners };
    const CoarseField coarse = SolveCoarseField(domain, reading, progress);
    collection.AddField(coarse, options.corners, "");
    if (options.chooseCorners)
    {
      std::vector<CornerChoice> ofField = options.corners;
      for (const CornerChoice& corner : ReadConfiguration(domain, coarse, reading).otherCorners)
      {
        if (FindChoice(options.corners, corner.position, domain) == nullptr)
        {
          ofField.push_back(corner);
        }
      }
      if (ofField.size() > options.corners.size())
      {
        collection.AddField(coarse, ofField, ", its corners");
      }
      const std::vector<CornerChoice> cheapest = ClassifiedChoices(domain, options);
      if (cheapest.size() > options.corners.size())
      {
        collection.AddField(coarse, cheapest, ", cheapest corners");
      }
      CornerSetOptions sets;
      sets.cornerAngle = options.cornerAngle;
      sets.given = options.corners;
      sets.ofField = ofField;
      sets.known = { ofField, cheapest };
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
  return collection.Take();
}
}
