#include "WindowSearch.h"

#include "BidirectedFlow.h"
#include "Index.h"
#include "Separation.h"
#include "Subproblem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Neighbouring patches of a T-mesh in breadth-first order from the first one, and their arcs.
struct Window
{
  std::vector<int> patches;
  std::vector<int> arcs;
};

class Windows
{
public:
  explicit Windows(const TMesh& mesh)
    : Mesh(mesh)
  {
    for (const TPatch& patch : mesh.patches)
    {
      std::vector<int> arcs;
      for (const auto& side : patch.sides)
      {
        for (const int half : side)
        {
          arcs.push_back(half / 2);
        }
      }
      this->ArcsOf.push_back(std::move(arcs));
    }
  }

  /// Returns the window around a patch, of at least `size` arcs if there are as many.
  Window Around(int patch, std::size_t size) const
  {
    std::vector<char> seen(this->Mesh.patches.size(), 0);
    std::vector<char> taken(this->Mesh.arcs.size(), 0);
    Window window;
    window.patches = { patch };
    seen[patch] = 1;
    std::size_t next = 0;
    for (; next < window.patches.size() && window.arcs.size() < size; ++next)
    {
      for (const int arc : this->ArcsOf[window.patches[next]])
      {
        if (taken[arc] == 0)
        {
          taken[arc] = 1;
          window.arcs.push_back(arc);
        }
        for (const int half : { 2 * arc, 2 * arc + 1 })
        {
          const int other = this->Mesh.halfEdges[half].patch;
          if (other >= 0 && seen[other] == 0)
          {
            seen[other] = 1;
            window.patches.push_back(other);
          }
        }
      }
    }
    window.patches.resize(next);
    return window;
  }

  /// Returns windows that cover the domain. Each is around the patch with the highest excess cost,
  /// above that of the nearest integers, among those that are not in the first quarter of an
  /// earlier window.
  std::vector<Window> Cover(
    const QuantisationProblem& problem, const std::vector<int>& counts, std::size_t size) const
  {
    std::vector<double> excess;
    for (const std::vector<int>& arcs : this->ArcsOf)
    {
      excess.push_back(std::accumulate(arcs.begin(), arcs.end(), 0.0,
        [&](double sum, int arc)
        {
          const auto nearest = static_cast<int>(std::lround(problem.target[arc]));
          return sum + problem.Cost(Index(arc), counts[arc]) - problem.Cost(Index(arc), nearest);
        }));
    }
    std::vector<int> order(this->ArcsOf.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(
      order.begin(), order.end(), [&](int a, int b) { return excess[a] > excess[b]; });
    std::vector<char> covered(order.size(), 0);
    std::vector<Window> windows;
    for (const int patch : order)
    {
      if (covered[patch] == 0)
      {
        windows.push_back(this->Around(patch, size));
        const std::vector<int>& patches = windows.back().patches;
        for (std::size_t i = 0; i < (patches.size() + 3) / 4; ++i)
        {
          covered[patches[i]] = 1;
        }
      }
    }
    return windows;
  }

private:
  const TMesh& Mesh;
  std::vector<std::vector<int>> ArcsOf; ///< Per patch.
};

/// Rebalances all counts by one flow in which no arc loses its last edge. The result is dropped if
/// points coincide in it, which can happen beside a patch of zero width, or a prescribed sum fails.
void Rebalance(const TMesh& mesh, const QuantisationProblem& problem, EdgeCounts& best)
{
  QuantisationProblem kept = problem;
  std::transform(best.counts.begin(), best.counts.end(), problem.lower.begin(), kept.lower.begin(),
    [](int count, int lower) { return std::max(lower, std::min(count, 1)); });
  EdgeCounts found = SolveBidirectedFlow(kept);
  if (best.IsImprovedBy(found) && problem.HoldsSums(found.counts) &&
    FindViolations(mesh, found.counts).empty())
  {
    ReplaceIfCheaper(best, std::move(found));
  }
}
}

void ImproveInWindows(const TMesh& mesh, const QuantisationProblem& problem, std::size_t largest,
  EdgeCounts& best, std::vector<SeparationRow>& rows)
{
  const Windows windows(mesh);
  // Few windows need more.
  constexpr int MaximumNodes = 50;
  // A window of 100 arcs takes a millisecond, one of 200 takes ten; larger ones find no more than
  // the full problem does. Small windows come first, as they are cheaper. Windows of more than a
  // third of all arcs are skipped, because the full problem covers them.
  constexpr std::array<std::size_t, 5> sizes = { 60, 100, 100, 200, 200 };
  for (const std::size_t size : sizes)
  {
    if (size > largest || 3 * size > problem.Count())
    {
      break;
    }
    for (const Window& window : windows.Cover(problem, best.counts, size))
    {
      ReplaceIfCheaper(
        best, SolveSubproblem(mesh, problem, window.arcs, { MaximumNodes }, best, rows));
    }
    Rebalance(mesh, problem, best);
  }
}
}
