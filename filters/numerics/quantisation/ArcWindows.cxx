#include "ArcWindows.h"

#include "ArcImprovement.h"
#include "Index.h"
#include "Separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Some faces of a T-mesh, the nearest to the first of them first, and their arcs.
struct Window
{
  std::vector<int> faces;
  std::vector<int> arcs;
};

class Windows
{
public:
  explicit Windows(const TMesh& mesh)
    : Mesh(mesh)
  {
    for (const TPatch& face : mesh.patches)
    {
      std::vector<int> arcs;
      for (const auto& side : face.sides)
      {
        for (const int half : side)
        {
          arcs.push_back(half / 2);
        }
      }
      this->ArcsOf.push_back(std::move(arcs));
    }
  }

  /// With at least `size` arcs, or all that there are.
  Window Around(int face, std::size_t size) const
  {
    std::vector<char> seen(this->Mesh.patches.size(), 0);
    std::vector<char> taken(this->Mesh.arcs.size(), 0);
    Window window;
    window.faces = { face };
    seen[Index(face)] = 1;
    std::size_t next = 0;
    for (; next < window.faces.size() && window.arcs.size() < size; ++next)
    {
      for (const int arc : this->ArcsOf[Index(window.faces[next])])
      {
        if (taken[Index(arc)] == 0)
        {
          taken[Index(arc)] = 1;
          window.arcs.push_back(arc);
        }
        for (const int half : { 2 * arc, 2 * arc + 1 })
        {
          const int other = this->Mesh.halfEdges[Index(half)].patch;
          if (other >= 0 && seen[Index(other)] == 0)
          {
            seen[Index(other)] = 1;
            window.faces.push_back(other);
          }
        }
      }
    }
    window.faces.resize(next);
    return window;
  }

  /// Windows that cover the domain: each is around the face with the highest cost, beyond that of the nearest integers, of those
  /// that are not in the nearer half of an earlier one.
  std::vector<Window> Cover(
    const ArcProblem& problem, const std::vector<int>& counts, std::size_t size) const
  {
    std::vector<double> excess;
    for (const std::vector<int>& arcs : this->ArcsOf)
    {
      excess.push_back(std::accumulate(arcs.begin(), arcs.end(), 0.0,
        [&](double sum, int arc)
        {
          const auto nearest = static_cast<int>(std::lround(problem.wanted[Index(arc)]));
          return sum + problem.Cost(Index(arc), counts[Index(arc)]) -
            problem.Cost(Index(arc), nearest);
        }));
    }
    std::vector<int> order(this->ArcsOf.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(),
      [&](int a, int b) { return excess[Index(a)] > excess[Index(b)]; });
    std::vector<char> covered(order.size(), 0);
    std::vector<Window> windows;
    for (const int face : order)
    {
      if (covered[Index(face)] == 0)
      {
        windows.push_back(this->Around(face, size));
        const std::vector<int>& faces = windows.back().faces;
        for (std::size_t i = 0; i < (faces.size() + 3) / 4; ++i)
        {
          covered[Index(faces[i])] = 1;
        }
      }
    }
    return windows;
  }

private:
  const TMesh& Mesh;
  std::vector<std::vector<int>> ArcsOf;
};

/// The optimum in which no arc loses its last edge, where that joins nothing: beside a face of no width other points may meet.
void Rebalance(const TMesh& mesh, const ArcProblem& problem, IntegerCounts& best)
{
  ArcProblem kept = problem;
  std::transform(best.counts.begin(), best.counts.end(), kept.lower.begin(),
    [](int count) { return std::min(count, 1); });
  IntegerCounts found = SolveArcFlow(kept);
  if (found.cost < best.cost - CostRounding(best.cost) &&
    FindViolations(mesh, found.counts).empty())
  {
    best.counts = std::move(found.counts);
    best.cost = found.cost;
  }
}
}

void ImproveInWindows(const TMesh& mesh, const ArcProblem& problem, std::size_t largest,
  IntegerCounts& best, std::vector<ArcRow>& rows, const Progress& progress)
{
  const Windows windows(mesh);
  // Few windows need more.
  constexpr int MostNodes = 50;
  // A window of 100 arcs takes a millisecond, one of 200 ten; larger ones find no more than the whole problem does. What small ones
  // improve is not left to large ones, and what is more than a third of everything to the whole problem.
  constexpr std::array<std::size_t, 5> sizes = { 60, 100, 100, 200, 200 };
  for (std::size_t pass = 0; pass < sizes.size(); ++pass)
  {
    if (sizes[pass] > largest || 3 * sizes[pass] > problem.Count())
    {
      break;
    }
    for (const Window& window : windows.Cover(problem, best.counts, sizes[pass]))
    {
      progress.Report(static_cast<double>(pass) / static_cast<double>(sizes.size()));
      ImproveCounts(mesh, problem, window.arcs, MostNodes, best, rows);
    }
    Rebalance(mesh, problem, best);
  }
}
}
