#include "CornerClassification.h"

#include "DomainQueries.h"
#include "Error.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace crossfield
{
namespace
{
/// Returns the threshold of the quarter index at price λ per quarter: the integer k between
/// Threshold − 1 and Threshold minimises e(α, k) − λk.
double Threshold(double angle, double price)
{
  return 2.5 - 2.0 * angle / Pi + 4.0 * angle * price / (Pi * Pi);
}

int SmallestMinimiser(double angle, double price)
{
  return static_cast<int>(std::ceil(Threshold(angle, price) - 1.0 - TieRounding));
}

int LargestMinimiser(double angle, double price)
{
  return static_cast<int>(std::floor(Threshold(angle, price) + TieRounding));
}

/// Returns the rounding error of the cost of a quarter at a corner, which is an angle divided by
/// the corner angle.
double CostRounding(const Corner& corner)
{
  return Pi * TieRounding / corner.angle;
}

/// Assignment problem, with one array entry per corner.
class Assignment
{
public:
  Assignment(const std::vector<ClassifiedCorner>& corners, int required, double interior)
    : Corners(corners)
    , Required(required)
    , Interior(interior)
  {
  }

  int Sum(const std::vector<int>& indices) const
  {
    int sum = 0;
    for (int index : indices)
    {
      sum += index;
    }
    return sum;
  }

  ScenarioCost Cost(const std::vector<int>& indices) const
  {
    ScenarioCost cost;
    cost.sum = this->Sum(indices);
    cost.energy = this->Interior * std::abs(this->Required - cost.sum);
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      cost.energy += CornerEnergy(this->Corners[i].angle, indices[i]);
    }
    return cost;
  }

  /// Returns the indices given by a rule that considers one corner at a time.
  template <class Rule>
  std::vector<int> ApplyRule(Rule rule) const
  {
    std::vector<int> indices;
    for (const ClassifiedCorner& corner : this->Corners)
    {
      indices.push_back(corner.overridden ? corner.quarterIndex : rule(corner.angle));
    }
    return indices;
  }

  /// Raises the cheapest corners one by one until the sum is reached or the next quarter costs more
  /// than `limit`.
  void Raise(std::vector<int>& indices, double limit) const
  {
    for (int sum = this->Sum(indices); sum < this->Required; ++sum)
    {
      const std::size_t cheapest = this->Cheapest(indices, +1);
      if (cheapest == indices.size() ||
        this->StepCost(indices, cheapest, +1) > limit + CostRounding(this->Corners[cheapest]))
      {
        return;
      }
      ++indices[cheapest];
    }
  }

  /// Lowers the cheapest corners one by one until the sum is reached.
  void Lower(std::vector<int>& indices) const
  {
    for (int sum = this->Sum(indices); sum > this->Required; --sum)
    {
      const std::size_t cheapest = this->Cheapest(indices, -1);
      if (cheapest == indices.size())
      {
        return;
      }
      --indices[cheapest];
    }
  }

  /// Returns whether no move of a single quarter between a corner and the interior decreases the
  /// energy.
  bool Balanced(const std::vector<int>& indices) const
  {
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      const double slack = this->Interior + CostRounding(this->Corners[i]);
      if (!this->Corners[i].overridden &&
        (this->StepCost(indices, i, +1) < -slack || this->StepCost(indices, i, -1) < -slack))
      {
        return false;
      }
    }
    return this->Sum(indices) == this->Required;
  }

  /// Returns which corners have another index in some other assignment of the same energy. The
  /// minimisers of such a sum are connected by single steps and exchanges (they form an M♮-convex
  /// set).
  std::vector<bool> Ties(const std::vector<int>& indices) const
  {
    std::vector<bool> tied(indices.size(), false);
    const int missing = this->Required - this->Sum(indices);
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      for (int step : { +1, -1 })
      {
        if (this->Corners[i].overridden)
        {
          continue;
        }
        const double cost = this->StepCost(indices, i, step);
        const double rounding = CostRounding(this->Corners[i]);
        const double saved = this->Interior * (std::abs(missing) - std::abs(missing - step));
        tied[i] = tied[i] || std::abs(cost - saved) <= rounding;
        for (std::size_t j = 0; j < indices.size(); ++j)
        {
          if (j != i && !this->Corners[j].overridden &&
            std::abs(cost + this->StepCost(indices, j, -step)) <=
              rounding + CostRounding(this->Corners[j]))
          {
            tied[i] = true;
            tied[j] = true;
          }
        }
      }
    }
    return tied;
  }

private:
  double StepCost(const std::vector<int>& indices, std::size_t i, int step) const
  {
    return step > 0 ? NextQuarterCost(this->Corners[i].angle, indices[i])
                    : -NextQuarterCost(this->Corners[i].angle, indices[i] - 1);
  }

  /// Returns the corner where a step costs the minimum, or the number of corners when no step is possible: of equal
  /// ones the first whose index is then nearest to that of a smooth boundary.
  std::size_t Cheapest(const std::vector<int>& indices, int step) const
  {
    std::size_t best = indices.size();
    for (std::size_t i = 0; i < indices.size(); ++i)
    {
      if (this->Corners[i].overridden)
      {
        continue;
      }
      if (best == indices.size())
      {
        best = i;
        continue;
      }
      const double saved = this->StepCost(indices, best, step) - this->StepCost(indices, i, step);
      const double rounding = CostRounding(this->Corners[i]);
      const bool isSmoother = std::abs(indices[i] + step) < std::abs(indices[best] + step);
      if (saved > rounding || (saved >= -rounding && isSmoother))
      {
        best = i;
      }
    }
    return best;
  }

  const std::vector<ClassifiedCorner>& Corners;
  int Required;
  double Interior;
};

void Override(std::vector<ClassifiedCorner>& corners, const std::vector<CornerChoice>& overrides)
{
  for (const CornerChoice& choice : overrides)
  {
    if (corners.empty())
    {
      throw Error("A quarter index was given for a corner but the domain has no corners; lower the "
                  "corner angle or leave the index out.");
    }
    const auto nearest = std::min_element(corners.begin(), corners.end(),
      [&choice](const Corner& a, const Corner& b)
      {
        return (a.position - choice.position).squaredNorm() <
          (b.position - choice.position).squaredNorm();
      });
    nearest->quarterIndex = choice.quarterIndex;
    nearest->overridden = true;
  }
}

void Split(const PlanarDomain& domain, CornerClassification& result)
{
  for (ClassifiedCorner& corner : result.corners)
  {
    if (corner.quarterIndex == 2 && !corner.overridden)
    {
      corner.quarterIndex = 1;
      Singularity singularity;
      singularity.position = corner.position +
        0.25 * DistanceAlongRay(domain, corner.position, corner.inward) * corner.inward;
      result.split.push_back(singularity);
    }
  }
}
}

const char* ScenarioName(Scenario scenario)
{
  switch (scenario)
  {
  case Scenario::Scarce:
    return "scarce";
  case Scenario::Excess:
    return "excess";
  default:
    return "balanced";
  }
}

CornerClassification ClassifyCorners(
  const PlanarDomain& domain, const ClassificationOptions& options)
{
  CornerClassification result;
  for (const Corner& corner : FindCorners(domain.loops, options.cornerAngle))
  {
    result.corners.emplace_back();
    static_cast<Corner&>(result.corners.back()) = corner;
  }
  Override(result.corners, options.overrides);
  const int required = 4 * domain.EulerCharacteristic();
  const double interior = InteriorQuarterEnergy(options.coefficient);
  const Assignment problem(result.corners, required, interior);

  // 1. Evaluate the three scenarios.
  const std::vector<int> scarce =
    problem.ApplyRule([&](double angle) { return SmallestMinimiser(angle, interior); });
  const std::vector<int> excess =
    problem.ApplyRule([&](double angle) { return LargestMinimiser(angle, -interior); });
  std::vector<int> balanced =
    problem.ApplyRule([](double angle) { return SmallestMinimiser(angle, 0.0); });
  problem.Raise(balanced, std::numeric_limits<double>::infinity());
  problem.Lower(balanced);
  auto& costs = result.scenarios;
  costs = { problem.Cost(scarce), problem.Cost(balanced), problem.Cost(excess) };
  costs[0].feasible = costs[0].sum <= required;
  costs[1].feasible = problem.Balanced(balanced);
  costs[2].feasible = costs[2].sum >= required;

  // 2. Find the exact minimum.
  std::vector<int> best =
    problem.ApplyRule([&](double angle) { return SmallestMinimiser(angle, -interior); });
  problem.Raise(best, interior);
  const int sum = problem.Sum(best);
  result.scenario = sum < required ? Scenario::Scarce
    : sum > required               ? Scenario::Excess
                                   : Scenario::Balanced;
  const std::vector<bool> tied = problem.Ties(best);

  // 3. Fill in the corners.
  for (std::size_t i = 0; i < result.corners.size(); ++i)
  {
    ClassifiedCorner& corner = result.corners[i];
    corner.quarterIndex = best[i];
    corner.scarce = scarce[i];
    corner.balanced = balanced[i];
    corner.excess = excess[i];
    corner.conventional = SmallestRotationIndex(corner.Turning());
    corner.tied = tied[i];
  }
  if (options.splitHalves)
  {
    Split(domain, result);
  }
  result.interiorQuarters = required;
  for (ClassifiedCorner& corner : result.corners)
  {
    corner.energy = CornerEnergy(corner.angle, corner.quarterIndex);
    result.energy += corner.energy;
    result.interiorQuarters -= corner.quarterIndex;
  }
  const auto split = static_cast<int>(result.split.size());
  result.energy += interior * (split + std::abs(result.interiorQuarters - split));
  return result;
}
}
