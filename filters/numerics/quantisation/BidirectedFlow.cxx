#include "BidirectedFlow.h"

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

/// One of the parallel edges that make up the convex cost of an arc.
struct FlowEdge
{
  Graph::Arc arc;
  std::size_t variable;
  Amount lower;
  Amount upper;
  Amount cost;
};

/// The minimum cost flow in the double cover of the equations, with one ground node for the
/// boundary (docs/method.md §14.2).
class DoubleCover
{
public:
  DoubleCover(const QuantisationProblem& problem, const std::vector<int>& lower,
    const std::vector<int>& upper)
    : Problem(problem)
    , Ground(2 * problem.equations)
  {
    for (int i = 0; i <= this->Ground; ++i)
    {
      this->Nodes.addNode();
    }
    const double largest = *std::max_element(problem.weight.begin(), problem.weight.end());
    // Costs are integers: six digits of the largest weight, far finer than the target counts are
    // meaningful.
    this->CostScale = 1e6 / largest;
    for (std::size_t a = 0; a < problem.Count(); ++a)
    {
      if (!problem.terms[a].empty())
      {
        this->AddVariable(a, lower[a], upper[a]);
      }
    }
  }

  /// Adds the flow on both copies of each arc, twice its relaxed count, to `doubled`. Returns false
  /// if there is none.
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
  Graph::Node NodeOf(int equation, bool plus)
  {
    return Graph::nodeFromId(2 * equation + (plus ? 0 : 1));
  }

  /// Returns the source and target of the first or the second copy of an arc.
  std::pair<Graph::Node, Graph::Node> EndsOf(const std::vector<EquationTerm>& terms, bool first)
  {
    const EquationTerm& one = terms[0];
    // At a node of the + sheet, a + term leaves and a − term arrives; at a node of the − sheet it
    // is the reverse.
    const Graph::Node from =
      first ? NodeOf(one.equation, one.sign > 0) : NodeOf(one.equation, one.sign < 0);
    Graph::Node to = Graph::nodeFromId(this->Ground);
    if (terms.size() == 2)
    {
      const EquationTerm& two = terms[1];
      to = first ? NodeOf(two.equation, two.sign < 0) : NodeOf(two.equation, two.sign > 0);
    }
    return first ? std::make_pair(from, to) : std::make_pair(to, from);
  }

  void AddVariable(std::size_t a, int lower, int upper)
  {
    const double target = this->Problem.target[a];
    const auto below = static_cast<Amount>(std::floor(target));
    const double fraction = target - static_cast<double>(below);
    const double weight = this->CostScale * this->Problem.weight[a];
    const Amount minimum = lower;
    const Amount maximum = upper < 0 ? std::numeric_limits<Amount>::max() : upper;
    const Amount unbounded = std::numeric_limits<Amount>::max();
    // Slopes −w up to ⌊ℓ⌋, w (1 − 2f) in the next unit, w beyond, clipped to the bounds.
    const Amount knee = std::clamp(below, minimum, maximum);
    const Amount second = std::clamp(below + 1, minimum, maximum);
    for (const bool first : { true, false })
    {
      const auto [from, to] = this->EndsOf(this->Problem.terms[a], first);
      const auto add = [&, from = from, to = to](Amount low, Amount high, double slope)
      {
        if (high > 0)
        {
          this->Edges.push_back(
            { this->Nodes.addArc(from, to), a, low, high, std::llround(slope) });
        }
      };
      add(minimum, knee, -weight);
      add(0, second - knee, weight * (1.0 - 2.0 * fraction));
      add(0, maximum == unbounded ? unbounded : maximum - second, weight);
    }
  }

  const QuantisationProblem& Problem;
  const int Ground;
  Graph Nodes;
  double CostScale = 1.0;
  std::vector<FlowEdge> Edges;
};

/// An open node of branch and bound: bounds of all arcs; −1 in `upper` stands for no bound.
struct Branch
{
  double cost = 0.0; ///< Of the relaxation that it is a part of.
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

/// The optimum over the half-integers, which is that over the reals.
struct RelaxedCounts
{
  bool feasible = false;
  std::vector<int> doubled; ///< 2 n_a.
  double cost = 0.0;
};

/// Solves the relaxation by one minimum cost flow in the double cover.
RelaxedCounts SolveRelaxedCounts(
  const QuantisationProblem& problem, const std::vector<int>& lower, const std::vector<int>& upper)
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
      const int maximum = upper[a] < 0 ? std::numeric_limits<int>::max() : upper[a];
      result.doubled[a] =
        2 * std::clamp(static_cast<int>(std::lround(problem.target[a])), lower[a], maximum);
    }
    const int half = result.doubled[a] / 2;
    result.cost += 0.5 * (problem.Cost(a, half) + problem.Cost(a, result.doubled[a] - half));
  }
  return result;
}
}

EdgeCounts SolveBidirectedFlow(const QuantisationProblem& problem, int maximumFlows)
{
  EdgeCounts best;
  std::vector<Branch> open = { { 0.0, problem.lower, std::vector<int>(problem.Count(), -1) } };
  std::vector<int> fallback;
  while (!open.empty() && best.nodes < maximumFlows)
  {
    // The lowest cost, and of equal ones the last. If the last one were searched first, counts could
    // rise without end, where an odd number goes around a domain with many equal parts.
    const auto lowest = std::min_element(
      open.rbegin(), open.rend(), [](const Branch& a, const Branch& b) { return a.cost < b.cost; });
    Branch branch = std::move(*lowest);
    open.erase(std::next(lowest).base());
    if (!best.counts.empty() && branch.cost >= best.cost - CostRounding(best.bound))
    {
      open.clear(); // no other one is lower
      break;
    }
    const RelaxedCounts relaxed = SolveRelaxedCounts(problem, branch.lower, branch.upper);
    if (++best.nodes == 1)
    {
      if (!relaxed.feasible)
      {
        return best;
      }
      best.bound = relaxed.cost;
      fallback = relaxed.doubled;
    }
    if (!relaxed.feasible ||
      (!best.counts.empty() && relaxed.cost >= best.cost - CostRounding(best.bound)))
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
    branch.cost = relaxed.cost;
    Branch down = branch;
    down.upper[arc] = *odd / 2;
    open.push_back(std::move(down));
    branch.lower[arc] = *odd / 2 + 1;
    open.push_back(std::move(branch));
  }
  best.optimal = open.empty();
  if (best.counts.empty())
  {
    // Doubled counts also satisfy the equations and the lower bounds.
    best.counts = fallback;
    best.cost = problem.Cost(fallback);
  }
  if (best.optimal)
  {
    best.bound = best.cost;
  }
  return best;
}
}
