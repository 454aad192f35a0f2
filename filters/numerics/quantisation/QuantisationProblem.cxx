#include "QuantisationProblem.h"

#include "Index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <utility>

namespace crossfield
{
bool CountSum::Holds(const std::vector<int>& counts) const
{
  int sum = 0;
  for (const auto& [arc, factor] : this->terms)
  {
    sum += factor * counts[arc];
  }
  return sum >= this->minimum && sum <= this->maximum;
}

bool QuantisationProblem::HoldsSums(const std::vector<int>& counts) const
{
  return std::all_of(this->sums.begin(), this->sums.end(),
    [&counts](const CountSum& sum) { return sum.Holds(counts); });
}

double QuantisationProblem::Cost(std::size_t arc, int count) const
{
  return this->weight[arc] * std::abs(count - this->target[arc]);
}

double QuantisationProblem::Cost(const std::vector<int>& counts) const
{
  double cost = 0.0;
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    cost += this->Cost(a, counts[a]);
  }
  return cost;
}

bool QuantisationProblem::IsFeasible(const std::vector<int>& counts) const
{
  std::vector<int> totals(static_cast<std::size_t>(this->equations), 0);
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    if (counts[a] < this->lower[a])
    {
      return false;
    }
    for (const EquationTerm& term : this->terms[a])
    {
      totals[term.equation] += term.sign * counts[a];
    }
  }
  return this->HoldsSums(counts) &&
    std::all_of(totals.begin(), totals.end(), [](int sum) { return sum == 0; });
}

QuantisationProblem MakeQuantisationProblem(const TMesh& mesh, std::vector<double> target)
{
  QuantisationProblem problem;
  problem.target = std::move(target);
  problem.weight.assign(mesh.arcs.size(), 0.0);
  problem.lower.assign(mesh.arcs.size(), 0);
  problem.terms.resize(mesh.arcs.size());
  for (const TPatch& patch : mesh.patches)
  {
    std::array<double, 4> lengths{};
    for (std::size_t side = 0; side < 4; ++side)
    {
      for (const int half : patch.sides[side])
      {
        lengths[side] += problem.target[half / 2];
      }
    }
    for (std::size_t side = 0; side < 4; ++side)
    {
      const double width = 0.5 * (lengths[(side + 1) % 4] + lengths[(side + 3) % 4]);
      const EquationTerm term = { problem.equations + static_cast<int>(side % 2),
        side < 2 ? 1 : -1 };
      for (const int half : patch.sides[side])
      {
        const auto arc = Index(half / 2);
        problem.weight[arc] += 0.5 * width;
        std::vector<EquationTerm>& terms = problem.terms[arc];
        if (terms.size() == 1 && terms[0].equation == term.equation && terms[0].sign == -term.sign)
        {
          terms.clear();
        }
        else
        {
          terms.push_back(term);
        }
      }
    }
    problem.equations += 2;
  }
  // An arc between patches without width keeps its target count by this weight, far below any other
  // one.
  constexpr double MinimumWeight = 1e-3;
  for (double& weight : problem.weight)
  {
    weight = std::max(weight, MinimumWeight);
  }
  return problem;
}

void BalanceTargets(const TMesh& mesh, QuantisationProblem& problem)
{
  constexpr int MostSweeps = 1000; // enough for strips through dozens of patches
  constexpr double Balanced = 1e-3;
  using Arcs = std::vector<std::size_t>;
  std::vector<std::array<Arcs, 2>> pairs; // of equal counts
  for (const TPatch& patch : mesh.patches)
  {
    for (const std::size_t first : { std::size_t(0), std::size_t(1) })
    {
      pairs.emplace_back();
      for (const std::size_t end : { std::size_t(0), std::size_t(1) })
      {
        for (const int half : patch.sides[first + 2 * end])
        {
          pairs.back()[end].push_back(Index(half / 2));
        }
      }
    }
  }
  for (const CountSum& sum : problem.sums)
  {
    if (sum.minimum == 0 && sum.maximum == 0)
    {
      pairs.emplace_back();
      for (const auto& [arc, factor] : sum.terms)
      {
        pairs.back()[factor > 0 ? 0 : 1].push_back(Index(arc));
      }
    }
  }
  const auto sumOver = [](const Arcs& arcs, const std::vector<double>& values)
  {
    return std::accumulate(arcs.begin(), arcs.end(), 0.0,
      [&values](double sum, std::size_t arc) { return sum + values[arc]; });
  };
  double largest = 2.0 * Balanced;
  for (int sweep = 0; sweep < MostSweeps && largest > Balanced; ++sweep)
  {
    largest = 0.0;
    for (std::size_t i = 0; i < pairs.size(); ++i)
    {
      const std::array<Arcs, 2>& sides = pairs[sweep % 2 == 0 ? i : pairs.size() - 1 - i];
      const std::array<double, 2> sums = { sumOver(sides[0], problem.target),
        sumOver(sides[1], problem.target) };
      if (!(sums[0] > 0.0 && sums[1] > 0.0))
      {
        continue;
      }
      const std::array<double, 2> weights = { sumOver(sides[0], problem.weight),
        sumOver(sides[1], problem.weight) };
      const double ratio = std::log(sums[1] / sums[0]);
      largest = std::max(largest, std::abs(ratio));
      const std::array<double, 2> changes = { std::exp(
                                                ratio * weights[1] / (weights[0] + weights[1])),
        std::exp(-ratio * weights[0] / (weights[0] + weights[1])) };
      for (std::size_t side = 0; side < 2; ++side)
      {
        for (const std::size_t arc : sides[side])
        {
          problem.target[arc] *= changes[side];
        }
      }
    }
  }
}

QuantisationProblem WithSumsAsEquations(QuantisationProblem problem)
{
  const auto isEquation = [&problem](const CountSum& sum)
  {
    return sum.minimum == 0 && sum.maximum == 0 &&
      std::all_of(sum.terms.begin(), sum.terms.end(),
        [&problem](const std::pair<int, int>& term)
        { return std::abs(term.second) == 1 && problem.terms[term.first].size() < 2; });
  };
  std::vector<CountSum> others;
  for (CountSum& sum : problem.sums)
  {
    if (!isEquation(sum))
    {
      others.push_back(std::move(sum));
      continue;
    }
    for (const auto& [arc, sign] : sum.terms)
    {
      problem.terms[arc].push_back({ problem.equations, sign });
    }
    ++problem.equations;
  }
  problem.sums = std::move(others);
  return problem;
}

QuantisationProblem MakeQuantisationProblem(const TMesh& mesh, double size)
{
  std::vector<double> target;
  target.reserve(mesh.arcs.size());
  for (const TArc& arc : mesh.arcs)
  {
    target.push_back(arc.length / size);
  }
  return MakeQuantisationProblem(mesh, std::move(target));
}
}
