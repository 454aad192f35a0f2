#include "RepeatedEdges.h"

#include "ArcPoints.h"
#include "Index.h"
#include "UnionFind.h"

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
/// Classes of the edges of arcs: edges on opposite sides of a patch of zero width are the same edge.
class EdgeClasses
{
public:
  EdgeClasses(const TMesh& mesh, const std::vector<int>& counts)
    : Counts(counts)
    , First(Starts(counts))
    , Classes(Index(this->First.back()))
  {
    const ArcPoints points(mesh, counts);
    for (const TPatch& patch : mesh.patches)
    {
      for (const std::size_t side : { 0, 1 })
      {
        if (points.SideCount(patch, side) == 0)
        {
          this->Join(patch.sides[side + 1], patch.sides[(side + 3) % 4]);
        }
      }
    }
  }

  /// Returns the class of the only edge of an arc.
  int ClassOf(std::size_t arc) { return this->Classes.Find(this->First[arc]); }

private:
  static std::vector<int> Starts(const std::vector<int>& counts)
  {
    std::vector<int> starts = { 0 };
    for (const int count : counts)
    {
      starts.push_back(starts.back() + count);
    }
    return starts;
  }

  std::vector<int> EdgesAlong(const std::vector<int>& side) const
  {
    std::vector<int> edges;
    for (const int half : side)
    {
      const int count = this->Counts[Index(half / 2)];
      for (int j = 0; j < count; ++j)
      {
        edges.push_back(this->First[Index(half / 2)] + (half % 2 == 0 ? j : count - 1 - j));
      }
    }
    return edges;
  }

  void Join(const std::vector<int>& side, const std::vector<int>& opposite)
  {
    const std::vector<int> one = this->EdgesAlong(side);
    const std::vector<int> other = this->EdgesAlong(opposite);
    for (std::size_t i = 0; i < one.size(); ++i)
    {
      this->Classes.Join(one[i], other[one.size() - 1 - i]);
    }
  }

  const std::vector<int>& Counts;
  const std::vector<int> First; ///< First edge of each arc, and the number of edges.
  UnionFind Classes;
};
}

std::vector<std::size_t> FindRepeatedEdges(const TMesh& mesh, const std::vector<int>& counts)
{
  const ArcPoints points(mesh, counts);
  UnionFind places(Index(points.Count()));
  for (const PointLink& link : points.Links())
  {
    places.Join(link.from, link.to);
  }
  EdgeClasses edges(mesh, counts);
  std::map<std::pair<int, int>, int> edgeBetween;
  std::vector<std::size_t> repeated;
  for (std::size_t a = 0; a < counts.size(); ++a)
  {
    if (counts[a] == 1)
    {
      const auto half = static_cast<int>(2 * a);
      const auto ends =
        std::minmax({ places.Find(points.At(half, 0)), places.Find(points.At(half, 1)) });
      if (edgeBetween.emplace(ends, edges.ClassOf(a)).first->second != edges.ClassOf(a))
      {
        repeated.push_back(a);
      }
    }
  }
  return repeated;
}
}
