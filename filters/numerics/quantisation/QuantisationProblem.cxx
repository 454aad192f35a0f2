#include "QuantisationProblem.h"

#include "Index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
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
  const auto sumOver = [](const std::vector<int>& side, const std::vector<double>& values)
  {
    double sum = 0.0;
    for (const int half : side)
    {
      sum += values[Index(half / 2)];
    }
    return sum;
  };
  double largest = 2.0 * Balanced;
  for (int sweep = 0; sweep < MostSweeps && largest > Balanced; ++sweep)
  {
    largest = 0.0;
    for (std::size_t i = 0; i < mesh.patches.size(); ++i)
    {
      const std::size_t p = sweep % 2 == 0 ? i : mesh.patches.size() - 1 - i;
      for (const std::size_t first : { std::size_t(0), std::size_t(1) })
      {
        const std::array<const std::vector<int>*, 2> sides = { &mesh.patches[p].sides[first],
          &mesh.patches[p].sides[first + 2] };
        std::array<double, 2> sums{};
        std::array<double, 2> weights{};
        for (std::size_t side = 0; side < 2; ++side)
        {
          sums[side] = sumOver(*sides[side], problem.target);
          weights[side] = sumOver(*sides[side], problem.weight);
        }
        if (!(sums[0] > 0.0 && sums[1] > 0.0))
        {
          continue;
        }
        const double ratio = std::log(sums[1] / sums[0]);
        largest = std::max(largest, std::abs(ratio));
        const std::array<double, 2> changes = { std::exp(
                                                  ratio * weights[1] / (weights[0] + weights[1])),
          std::exp(-ratio * weights[0] / (weights[0] + weights[1])) };
        for (std::size_t side = 0; side < 2; ++side)
        {
          for (const int half : *sides[side])
          {
            problem.target[Index(half / 2)] *= changes[side];
          }
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
