#include "CornerSets.h"

#include "BoundarySymmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// One index for each corner.
using Indices = std::vector<int>;

/// Set of indices with its cost by corners and interior quarters.
struct CostedSet
{
  Indices indices;
  double cost = 0.0;
};

/// Candidate index of a corner, with its energy.
struct Candidate
{
  int index = 0;
  double cost = 0.0;
};

/// Corner with its candidate indices; the first is that of the smallest rotation, or the given one.
struct OpenCorner
{
  Point position = Point::Zero();
  std::vector<Candidate> candidates;
};

void AddCandidate(OpenCorner& corner, int index, double cost)
{
  constexpr int MinimumIndex = -2; // a slit
  constexpr int MaximumIndex = 1;  // quad meshes have no corners of 2
  if (index >= MinimumIndex && index <= MaximumIndex &&
    std::none_of(corner.candidates.begin(), corner.candidates.end(),
      [index](const Candidate& candidate) { return candidate.index == index; }))
  {
    corner.candidates.push_back({ index, cost });
  }
}

std::vector<OpenCorner> OpenCorners(const PlanarDomain& domain, const CornerSetOptions& options)
{
  const ClassificationOptions classification =
    ClassificationBeside(options.given, domain, options.cornerAngle);
  std::vector<OpenCorner> open;
  for (const ClassifiedCorner& corner : ClassifyCorners(domain, classification).corners)
  {
    const auto energy = [&corner](int index) { return CornerEnergy(corner.angle, index); };
    const int decided = corner.overridden ? corner.quarterIndex : corner.conventional;
    open.push_back({ corner.position, { { decided, energy(decided) } } });
    if (corner.overridden)
    {
      continue;
    }
    if (const CornerChoice* choice = FindChoice(options.fieldCorners, corner.position, domain))
    {
      AddCandidate(open.back(), choice->quarterIndex, energy(decided));
    }
    AddCandidate(open.back(), corner.quarterIndex, energy(corner.quarterIndex));
    if (corner.tied)
    {
      const int k = corner.quarterIndex;
      const int other = energy(k + 1) < energy(k - 1) ? k + 1 : k - 1;
      AddCandidate(open.back(), other, energy(other));
    }
  }
  return open;
}

/// Fixes the corners whose alternatives cost most, until the number of combinations is small
/// enough.
void LimitCombinations(std::vector<OpenCorner>& corners)
{
  constexpr double MaximumCombinations = 1 << 12;
  const auto extraCost = [](const OpenCorner& corner)
  {
    double lowest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < corner.candidates.size(); ++i)
    {
      lowest = std::min(lowest, corner.candidates[i].cost);
    }
    return corner.candidates.size() < 2 ? -std::numeric_limits<double>::infinity()
                                        : lowest - corner.candidates[0].cost;
  };
  const auto combinations = [&corners]
  {
    double product = 1.0;
    for (const OpenCorner& corner : corners)
    {
      product *= static_cast<double>(corner.candidates.size());
    }
    return product;
  };
  while (combinations() > MaximumCombinations)
  {
    std::max_element(corners.begin(), corners.end(),
      [&extraCost](const auto& a, const auto& b) { return extraCost(a) < extraCost(b); })
      ->candidates.resize(1);
  }
}

/// Returns all combinations, the cheapest first, in the order of the corners among equals.
std::vector<CostedSet> Combine(const std::vector<OpenCorner>& corners, int required)
{
  const double interior = InteriorQuarterEnergy(InteriorCoefficient::Logarithm);
  std::vector<CostedSet> sets;
  std::vector<std::size_t> selection(corners.size(), 0);
  for (bool more = true; more;)
  {
    CostedSet set;
    int sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Candidate& candidate = corners[i].candidates[selection[i]];
      set.indices.push_back(candidate.index);
      set.cost += candidate.cost;
      sum += set.indices[i];
    }
    set.cost += interior * std::abs(required - sum);
    // Rounded, so that ties are detected.
    set.cost = AngleRounding * std::round(set.cost / AngleRounding);
    sets.push_back(set);
    more = false;
    for (std::size_t i = 0; i < corners.size() && !more; ++i)
    {
      selection[i] = (selection[i] + 1) % corners[i].candidates.size();
      more = selection[i] != 0;
    }
  }
  std::stable_sort(sets.begin(), sets.end(),
    [](const CostedSet& a, const CostedSet& b) { return a.cost < b.cost; });
  return sets;
}

/// Returns for each symmetry the numbers of the images of the corners.
std::vector<std::vector<std::size_t>> ImagesOf(
  const PlanarDomain& domain, const std::vector<OpenCorner>& corners)
{
  std::vector<std::vector<std::size_t>> images;
  for (const Isometry& map : FindSymmetries(domain).Elements())
  {
    images.emplace_back();
    for (const OpenCorner& corner : corners)
    {
      const Point image = map(corner.position);
      const auto nearest = std::min_element(corners.begin(), corners.end(),
        [&image](const auto& a, const auto& b)
        { return (a.position - image).squaredNorm() < (b.position - image).squaredNorm(); });
      images.back().push_back(static_cast<std::size_t>(nearest - corners.begin()));
    }
  }
  return images;
}

bool AreSymmetric(
  const Indices& a, const Indices& b, const std::vector<std::vector<std::size_t>>& images)
{
  return std::any_of(images.begin(), images.end(),
    [&](const std::vector<std::size_t>& image)
    {
      for (std::size_t i = 0; i < a.size(); ++i)
      {
        if (a[i] != b[image[i]])
        {
          return false;
        }
      }
      return true;
    });
}
}

const CornerChoice* FindChoice(
  const std::vector<CornerChoice>& choices, const Point& vertex, const PlanarDomain& domain)
{
  const double tolerance = BoundaryReach * domain.Diagonal();
  const auto found = std::find_if(choices.begin(), choices.end(),
    [&](const CornerChoice& choice) { return (choice.position - vertex).norm() <= tolerance; });
  return found == choices.end() ? nullptr : &*found;
}

ClassificationOptions ClassificationBeside(
  const std::vector<CornerChoice>& given, const PlanarDomain& domain, double cornerAngle)
{
  ClassificationOptions classification;
  classification.cornerAngle = cornerAngle;
  for (const Corner& corner : FindCorners(domain.loops, cornerAngle))
  {
    // The classifier assigns an override to the nearest corner, and chosen vertices need not be
    // corners.
    if (const CornerChoice* choice = FindChoice(given, corner.position, domain))
    {
      classification.overrides.push_back(*choice);
    }
  }
  return classification;
}

std::vector<std::vector<CornerChoice>> FindCornerSets(
  const PlanarDomain& domain, const CornerSetOptions& options)
{
  std::vector<OpenCorner> corners = OpenCorners(domain, options);
  LimitCombinations(corners);
  const std::vector<CostedSet> sets = Combine(corners, 4 * domain.EulerCharacteristic());
  const double maximumCost =
    sets.front().cost + InteriorQuarterEnergy(InteriorCoefficient::Logarithm) + AngleRounding;
  const auto images = ImagesOf(domain, corners);
  std::vector<Indices> excluded;
  for (const std::vector<CornerChoice>& known : options.known)
  {
    excluded.emplace_back();
    for (const OpenCorner& corner : corners)
    {
      const CornerChoice* choice = FindChoice(known, corner.position, domain);
      excluded.back().push_back(choice ? choice->quarterIndex : corner.candidates[0].index);
    }
  }
  std::vector<std::vector<CornerChoice>> result;
  for (const CostedSet& set : sets)
  {
    if (result.size() == options.count || set.cost > maximumCost)
    {
      break;
    }
    if (std::any_of(excluded.begin(), excluded.end(),
          [&](const Indices& other) { return AreSymmetric(set.indices, other, images); }))
    {
      continue;
    }
    excluded.push_back(set.indices);
    std::vector<CornerChoice> choices = options.given;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (set.indices[i] != corners[i].candidates[0].index)
      {
        choices.push_back({ corners[i].position, set.indices[i] });
      }
    }
    if (choices.size() > options.given.size())
    {
      result.push_back(choices);
    }
  }
  return result;
}
}
