#include "ArcFlow.h"

#include "Error.h"

#define LEMON_ONLY_TEMPLATES
#include <lemon/network_simplex.h>
#include <lemon/smart_graph.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
namespace
{
using Graph = lemon::SmartDigraph;
using Amount = long long;
using Simplex = lemon::NetworkSimplex<Graph, Amount, Amount>;

/// One of the parallel edges that the convex cost of an arc is made of.
struct FlowEdge
{
  Graph::Arc arc;
  std::size_t variable;
  Amount lower;
  Amount upper;
  Amount cost;
};

/// The double cover of the rows, and one ground for the boundary.
class DoubleCover
{
public:
  DoubleCover(
    const ArcProblem& problem, const std::vector<int>& lower, const std::vector<int>& upper)
    : Problem(problem)
    , Ground(2 * problem.rows)
  {
    for (int i = 0; i <= this->Ground; ++i)
    {
      this->Nodes.addNode();
    }
    const double largest = *std::max_element(problem.weight.begin(), problem.weight.end());
    // Costs are integers: six digits of the largest weight, far below what the wanted lengths are worth.
    this->CostScale = 1e6 / largest;
    for (std::size_t a = 0; a < problem.Count(); ++a)
    {
      if (!problem.terms[a].empty())
      {
        this->AddVariable(a, lower[a], upper[a]);
      }
    }
  }

  bool Solve(std::vector<int>& doubled)
  {
    Simplex simplex(this->Nodes);
    Graph::ArcMap<Amount> lower(this->Nodes);
    Graph::ArcMap<Amount> upper(this->Nodes);
    Graph::ArcMap<Amount> cost(this->Nodes);
    for (const FlowEdge& edge : this->Edges)
    {
      lower[edge.arc] = edge.lower;
      upper[edge.arc] = edge.upper;
      cost[edge.arc] = edge.cost;
    }
    simplex.lowerMap(lower).upperMap(upper).costMap(cost);
    if (this->Edges.empty())
    {
      return true;
    }
    if (simplex.run() != Simplex::OPTIMAL)
    {
      return false;
    }
    for (const FlowEdge& edge : this->Edges)
    {
      doubled[edge.variable] += static_cast<int>(simplex.flow(edge.arc));
    }
    return true;
  }

private:
  Graph::Node NodeOf(int row, bool plus) { return Graph::nodeFromId(2 * row + (plus ? 0 : 1)); }

  /// From where to where the first copy of a variable flows; the second one runs between the others.
  std::pair<Graph::Node, Graph::Node> WayOf(const std::vector<ArcTerm>& terms, bool first)
  {
    const ArcTerm& one = terms[0];
    // At a node of the + cover + leaves and − arrives; at one of the − cover the other way round.
    const Graph::Node from = first ? NodeOf(one.row, one.sign > 0) : NodeOf(one.row, one.sign < 0);
    Graph::Node to = Graph::nodeFromId(this->Ground);
    if (terms.size() == 2)
    {
      const ArcTerm& two = terms[1];
      to = first ? NodeOf(two.row, two.sign < 0) : NodeOf(two.row, two.sign > 0);
    }
    return first ? std::make_pair(from, to) : std::make_pair(to, from);
  }

  void AddVariable(std::size_t a, int lower, int upper)
  {
    const double wanted = this->Problem.wanted[a];
    const auto below = static_cast<Amount>(std::floor(wanted));
    const double fraction = wanted - static_cast<double>(below);
    const double weight = this->CostScale * this->Problem.weight[a];
    const Amount least = lower;
    const Amount most = upper < 0 ? std::numeric_limits<Amount>::max() : upper;
    const Amount unbounded = std::numeric_limits<Amount>::max();
    // Slopes −w up to ⌊ℓ⌋, w (1 − 2f) in the next unit, w beyond; the bounds cut pieces off.
    const Amount knee = std::clamp(below, least, most);
    const Amount second = std::clamp(below + 1, least, most);
    for (const bool first : { true, false })
    {
      const auto [from, to] = this->WayOf(this->Problem.terms[a], first);
      const auto add = [&, from = from, to = to](Amount low, Amount high, double slope)
      {
        if (high > 0)
        {
          this->Edges.push_back(
            { this->Nodes.addArc(from, to), a, low, high, std::llround(slope) });
        }
      };
      add(least, knee, -weight);
      add(0, second - knee, weight * (1.0 - 2.0 * fraction));
      add(0, most == unbounded ? unbounded : most - second, weight);
    }
  }

  const ArcProblem& Problem;
  const int Ground;
  Graph Nodes;
  double CostScale = 1.0;
  std::vector<FlowEdge> Edges;
};

/// What is left to search.
struct Branch
{
  std::vector<int> lower;
  std::vector<int> upper;
};

std::vector<int> Halve(std::vector<int> doubled)
{
  for (int& count : doubled)
  {
    count /= 2;
  }
  return doubled;
}

/// The optimum of an ArcProblem over half-integers, which is that over the reals.
struct RelaxedCounts
{
  bool feasible = false;
  std::vector<int> doubled; ///< 2 n_a.
  double cost = 0.0;
};

/// One minimum cost flow in the double cover (docs/method.md §14.2). `upper` −1 stands for no bound.
RelaxedCounts SolveRelaxedCounts(
  const ArcProblem& problem, const std::vector<int>& lower, const std::vector<int>& upper)
{
  RelaxedCounts result;
  result.doubled.assign(problem.Count(), 0);
  if (problem.Count() == 0)
  {
    result.feasible = true;
    return result;
  }
  result.feasible = DoubleCover(problem, lower, upper).Solve(result.doubled);
  for (std::size_t a = 0; a < problem.Count(); ++a)
  {
    if (problem.terms[a].empty())
    {
      const int most = upper[a] < 0 ? std::numeric_limits<int>::max() : upper[a];
      result.doubled[a] =
        2 * std::clamp(static_cast<int>(std::lround(problem.wanted[a])), lower[a], most);
    }
    const int half = result.doubled[a] / 2;
    result.cost += 0.5 * (problem.Cost(a, half) + problem.Cost(a, result.doubled[a] - half));
  }
  return result;
}
}

IntegerCounts SolveArcFlow(const ArcProblem& problem)
{
  IntegerCounts best;
  // In all cases tried a few suffice; each costs milliseconds at hundreds of arcs.
  constexpr int MostFlows = 200;
  std::vector<Branch> open = { { problem.lower, std::vector<int>(problem.Count(), -1) } };
  std::vector<int> fallback;
  while (!open.empty() && best.flows < MostFlows)
  {
    Branch branch = std::move(open.back());
    open.pop_back();
    const RelaxedCounts relaxed = SolveRelaxedCounts(problem, branch.lower, branch.upper);
    if (++best.flows == 1)
    {
      if (!relaxed.feasible)
      {
        throw Error("No numbers of quads fit the lines; use a finer mesh.");
      }
      best.bound = relaxed.cost;
      fallback = relaxed.doubled;
    }
    const double rounding = 1e-9 * (1.0 + best.bound);
    if (!relaxed.feasible || (!best.counts.empty() && relaxed.cost >= best.cost - rounding))
    {
      continue;
    }
    const auto odd = std::find_if(
      relaxed.doubled.begin(), relaxed.doubled.end(), [](int twice) { return twice % 2 == 1; });
    if (odd == relaxed.doubled.end())
    {
      best.counts = Halve(relaxed.doubled);
      best.cost = relaxed.cost;
      continue;
    }
    const auto arc = static_cast<std::size_t>(odd - relaxed.doubled.begin());
    Branch less = branch;
    less.upper[arc] = *odd / 2;
    open.push_back(std::move(less));
    branch.lower[arc] = *odd / 2 + 1;
    open.push_back(std::move(branch)); // first, as more is always possible
  }
  best.optimal = open.empty();
  if (best.counts.empty())
  {
    // Twice a solution solves the equations; lower bounds hold all the more.
    best.counts = fallback;
    best.cost = problem.Cost(fallback);
  }
  return best;
}
}
