#include "CornerSets.h"

#include "BoundarySymmetry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
/// An index for every corner.
using Indices = std::vector<int>;

/// A set, and what it costs by the count of corners and interior quarters.
struct CostedSet
{
  Indices indices;
  double cost = 0.0;
};

/// An index of a corner and its energy.
struct Option
{
  int index = 0;
  double cost = 0.0;
};

/// A corner, and the indices that it may have; the first is that of the smallest rotation, or given.
struct OpenCorner
{
  Point position = Point::Zero();
  std::vector<Option> options;
};

void AddOnce(OpenCorner& corner, int index, double cost)
{
  constexpr int LeastIndex = -2; // a slit
  constexpr int MostIndex = 1;   // quad meshes have no corners of 2
  if (index >= LeastIndex && index <= MostIndex &&
    std::none_of(corner.options.begin(), corner.options.end(),
      [index](const Option& option) { return option.index == index; }))
  {
    corner.options.push_back({ index, cost });
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
    if (const CornerChoice* seen = FindChoice(options.ofField, corner.position, domain))
    {
      AddOnce(open.back(), seen->quarterIndex, energy(decided));
    }
    AddOnce(open.back(), corner.quarterIndex, energy(corner.quarterIndex));
    if (corner.tied)
    {
      const int k = corner.quarterIndex;
      const int other = energy(k + 1) < energy(k - 1) ? k + 1 : k - 1;
      AddOnce(open.back(), other, energy(other));
    }
  }
  return open;
}

/// Decides the corners whose other indices cost most, until there are few enough combinations.
void Limit(std::vector<OpenCorner>& corners)
{
  constexpr double MostCombinations = 1 << 12;
  const auto extra = [](const OpenCorner& corner)
  {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < corner.options.size(); ++i)
    {
      least = std::min(least, corner.options[i].cost);
    }
    return corner.options.size() < 2 ? -std::numeric_limits<double>::infinity()
                                     : least - corner.options[0].cost;
  };
  const auto combinations = [&corners]
  {
    double product = 1.0;
    for (const OpenCorner& corner : corners)
    {
      product *= static_cast<double>(corner.options.size());
    }
    return product;
  };
  while (combinations() > MostCombinations)
  {
    std::max_element(corners.begin(), corners.end(),
      [&extra](const auto& a, const auto& b) { return extra(a) < extra(b); })
      ->options.resize(1);
  }
}

/// All combinations, the cheapest first, and in the order of the corners among equals.
std::vector<CostedSet> Combine(const std::vector<OpenCorner>& corners, int wanted)
{
  const double interior = InteriorQuarterEnergy(InteriorCoefficient::Logarithm);
  std::vector<CostedSet> sets;
  std::vector<std::size_t> digits(corners.size(), 0);
  for (bool more = true; more;)
  {
    CostedSet set;
    int sum = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Option& option = corners[i].options[digits[i]];
      set.indices.push_back(option.index);
      set.cost += option.cost;
      sum += set.indices[i];
    }
    set.cost += interior * std::abs(wanted - sum);
    set.cost = AngleRounding * std::round(set.cost / AngleRounding); // ties are ties
    sets.push_back(set);
    more = false;
    for (std::size_t i = 0; i < corners.size() && !more; ++i)
    {
      digits[i] = (digits[i] + 1) % corners[i].options.size();
      more = digits[i] != 0;
    }
  }
  std::stable_sort(sets.begin(), sets.end(),
    [](const CostedSet& a, const CostedSet& b) { return a.cost < b.cost; });
  return sets;
}

/// Of each symmetry the numbers of the corners that it takes those of a domain to.
std::vector<std::vector<std::size_t>> ImagesOf(
  const PlanarDomain& domain, const std::vector<OpenCorner>& corners)
{
  std::vector<std::vector<std::size_t>> images;
  for (const Isometry& map : FindSymmetries(domain).Elements())
  {
    images.emplace_back();
    for (const OpenCorner& corner : corners)
    {
      const Point place = map(corner.position);
      const auto nearest = std::min_element(corners.begin(), corners.end(),
        [&place](const auto& a, const auto& b)
        { return (a.position - place).squaredNorm() < (b.position - place).squaredNorm(); });
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
  const double reach = BoundaryReach * domain.Diagonal();
  const auto found = std::find_if(choices.begin(), choices.end(),
    [&](const CornerChoice& choice) { return (choice.position - vertex).norm() <= reach; });
  return found == choices.end() ? nullptr : &*found;
}

ClassificationOptions ClassificationBeside(
  const std::vector<CornerChoice>& given, const PlanarDomain& domain, double cornerAngle)
{
  ClassificationOptions classification;
  classification.cornerAngle = cornerAngle;
  for (const Corner& corner : FindCorners(domain.loops, cornerAngle))
  {
    // The classifier gives an override to the nearest corner, and chosen vertices may be none.
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
  Limit(corners);
  const std::vector<CostedSet> sets = Combine(corners, 4 * domain.EulerCharacteristic());
  const double most =
    sets.front().cost + InteriorQuarterEnergy(InteriorCoefficient::Logarithm) + AngleRounding;
  const auto images = ImagesOf(domain, corners);
  std::vector<Indices> kept;
  for (const std::vector<CornerChoice>& known : options.known)
  {
    kept.emplace_back();
    for (const OpenCorner& corner : corners)
    {
      const CornerChoice* choice = FindChoice(known, corner.position, domain);
      kept.back().push_back(choice ? choice->quarterIndex : corner.options[0].index);
    }
  }
  std::vector<std::vector<CornerChoice>> result;
  for (const CostedSet& set : sets)
  {
    if (result.size() == options.count || set.cost > most)
    {
      break;
    }
    if (std::any_of(kept.begin(), kept.end(),
          [&](const Indices& other) { return AreSymmetric(set.indices, other, images); }))
    {
      continue;
    }
    kept.push_back(set.indices);
    std::vector<CornerChoice> choices = options.given;
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      if (set.indices[i] != corners[i].options[0].index)
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
