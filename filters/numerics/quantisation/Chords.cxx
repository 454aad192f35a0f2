#include "Chords.h"

#include "ArcPoints.h"
#include "BranchAndCut.h"
#include "Index.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the best positive numbers that hold the prescribed sums, found within a number of nodes;
/// none if there are none.
std::vector<int> Solve(const QuantisationProblem& problem)
{
  constexpr int MaximumNodes = 300;
  std::vector<int> all(problem.Count());
  std::iota(all.begin(), all.end(), 0);
  const auto search = [&](const std::vector<int>& start)
  {
    BranchAndCut tree(problem, all, start);
    for (const int chord : all)
    {
      tree.AddRow({ { { chord, 1 } }, 1 });
    }
    return tree
      .Solve({ MaximumNodes }, [](const std::vector<int>&) { return std::vector<SeparationRow>(); })
      .counts;
  };
  const std::vector<int> first = search({});
  return first.empty() ? first : search(first);
}
}

Chords::Chords(const TMesh& mesh, std::vector<int> coarse)
  : Coarse(std::move(coarse))
{
  std::vector<int> first = { 0 };
  for (const int count : this->Coarse)
  {
    first.push_back(first.back() + count);
  }
  const auto along = [&](const TPatch& patch, std::size_t side)
  {
    std::vector<int> edges;
    for (const int half : patch.sides[side])
    {
      const int count = this->Coarse[half / 2];
      for (int j = 0; j < count; ++j)
      {
        edges.push_back(first[half / 2] + (half % 2 == 0 ? j : count - 1 - j));
      }
    }
    return edges;
  };
  UnionFind classes(Index(first.back()));
  for (const TPatch& patch : mesh.patches)
  {
    for (const std::size_t side : { std::size_t(0), std::size_t(1) })
    {
      const std::vector<int> one = along(patch, side);
      const std::vector<int> other = along(patch, side + 2);
      for (std::size_t j = 0; j < one.size(); ++j)
      {
        classes.Join(one[j], other[one.size() - 1 - j]);
      }
    }
  }
  std::vector<int> number(Index(first.back()), -1);
  for (std::size_t a = 0; a < this->Coarse.size(); ++a)
  {
    this->OfArc.emplace_back();
    for (int edge = first[a]; edge < first[a + 1]; ++edge)
    {
      int& chord = number[classes.Find(edge)];
      chord = chord < 0 ? this->Total++ : chord;
      this->OfArc.back().push_back(chord);
    }
  }
}

std::vector<int> Chords::Numbers(const QuantisationProblem& problem) const
{
  std::vector<double> target(Index(this->Total), 0.0);
  std::vector<double> weight(Index(this->Total), 0.0);
  for (std::size_t a = 0; a < this->OfArc.size(); ++a)
  {
    for (const int chord : this->OfArc[a])
    {
      target[chord] += problem.weight[a] * problem.target[a] / this->Coarse[a];
      weight[chord] += problem.weight[a];
    }
  }
  QuantisationProblem ofChords;
  std::vector<int> numbers;
  for (std::size_t chord = 0; chord < target.size(); ++chord)
  {
    ofChords.target.push_back(target[chord] / weight[chord]);
    numbers.push_back(std::max(1, static_cast<int>(std::lround(ofChords.target.back()))));
  }
  if (problem.sums.empty())
  {
    return numbers;
  }
  ofChords.weight = weight;
  ofChords.lower.assign(numbers.size(), 1);
  ofChords.terms.resize(numbers.size());
  for (const CountSum& sum : problem.sums)
  {
    std::map<int, int> factors;
    for (const auto& [arc, factor] : sum.terms)
    {
      for (const int chord : this->OfArc[arc])
      {
        factors[chord] += factor;
      }
    }
    ofChords.sums.push_back(
      { { factors.begin(), factors.end() }, sum.minimum, sum.maximum, sum.name });
  }
  return Solve(ofChords);
}

std::vector<int> Chords::Refine(const QuantisationProblem& problem) const
{
  const std::vector<int> numbers = this->Numbers(problem);
  std::vector<int> counts;
  for (std::size_t a = 0; a < this->OfArc.size() && !numbers.empty(); ++a)
  {
    int count = 0;
    for (const int chord : this->OfArc[a])
    {
      count += numbers[chord];
    }
    counts.push_back(count);
  }
  return counts;
}
}
