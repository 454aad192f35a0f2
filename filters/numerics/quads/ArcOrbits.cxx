#include "ArcOrbits.h"

#include "TMeshSymmetry.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns whether targets of arcs and of their images are similar: different prescribed sizes are
/// not.
bool KeepsTargets(const std::vector<double>& target, const std::vector<int>& images)
{
  // Where the triangles are not symmetric, such as under rotations alone, targets differ by less.
  constexpr double Edges = 0.5;
  constexpr double Part = 0.1;
  for (std::size_t a = 0; a < images.size(); ++a)
  {
    const double image = target[images[a]];
    if (std::abs(target[a] - image) > Edges + Part * std::max(target[a], image))
    {
      return false;
    }
  }
  return true;
}

/// Returns the terms of a sum in the order of arcs, with all signs changed if the first one is
/// negative.
std::vector<std::pair<int, int>> Ordered(std::vector<std::pair<int, int>> terms)
{
  std::sort(terms.begin(), terms.end());
  if (!terms.empty() && terms.front().second < 0)
  {
    for (auto& [arc, factor] : terms)
    {
      factor = -factor;
    }
  }
  return terms;
}

/// Returns whether a symmetry maps every sum to one with the same bounds.
bool KeepsSums(const std::vector<CountSum>& sums, const std::vector<int>& images)
{
  return std::all_of(sums.begin(), sums.end(),
    [&](const CountSum& sum)
    {
      std::vector<std::pair<int, int>> terms = sum.terms;
      for (auto& [arc, factor] : terms)
      {
        arc = images[arc];
      }
      terms = Ordered(std::move(terms));
      return std::any_of(sums.begin(), sums.end(),
        [&](const CountSum& other)
        {
          return other.minimum == sum.minimum && other.maximum == sum.maximum &&
            Ordered(other.terms) == terms;
        });
    });
}
}

ArcOrbits::ArcOrbits(const TMesh& mesh, const std::vector<Isometry>& symmetries,
  const QuantisationProblem& problem, double reach)
{
  // Every arc begins as its own orbit, represented by its first arc.
  std::vector<int> first(mesh.arcs.size());
  std::iota(first.begin(), first.end(), 0);
  const auto representative = [&first](int arc)
  {
    while (first[arc] != arc)
    {
      arc = first[arc];
    }
    return arc;
  };
  for (std::size_t s = 1; s < symmetries.size(); ++s) // the identity comes first
  {
    const std::vector<int> images = FindArcImages(mesh, symmetries[s], reach);
    if (images.empty() || !KeepsTargets(problem.target, images) || !KeepsSums(problem.sums, images))
    {
      continue;
    }
    ++this->Symmetries;
    for (std::size_t a = 0; a < images.size(); ++a)
    {
      const std::pair<int, int> both =
        std::minmax({ representative(static_cast<int>(a)), representative(images[a]) });
      first[both.second] = both.first;
    }
  }
  std::vector<std::vector<int>> orbits(mesh.arcs.size());
  for (int arc = 0; arc < static_cast<int>(first.size()); ++arc)
  {
    orbits[representative(arc)].push_back(arc);
  }
  std::copy_if(orbits.begin(), orbits.end(), std::back_inserter(this->Orbits),
    [](const std::vector<int>& orbit) { return orbit.size() > 1; });
}

void ArcOrbits::Equate(QuantisationProblem& problem) const
{
  for (const std::vector<int>& orbit : this->Orbits)
  {
    for (std::vector<double>* const values : { &problem.target, &problem.weight })
    {
      const double sum = std::accumulate(orbit.begin(), orbit.end(), 0.0,
        [values](double total, int arc) { return total + (*values)[arc]; });
      for (const int arc : orbit)
      {
        (*values)[arc] = sum / static_cast<double>(orbit.size());
      }
    }
    for (std::size_t i = 1; i < orbit.size(); ++i)
    {
      problem.sums.push_back(
        { { { orbit[i - 1], 1 }, { orbit[i], -1 } }, 0, 0, "the symmetry of the domain" });
    }
  }
}
}
