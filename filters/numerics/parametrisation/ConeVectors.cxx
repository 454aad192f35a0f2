#include "ConeVectors.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the transition that applies the second one after the first.
SeamTransition After(const SeamTransition& first, const SeamTransition& second)
{
  return { (first.rotation + second.rotation) % 4,
    TurnByQuarters(first.translation, second.rotation) + second.translation };
}

/// Returns a vector turned by quarters into the first quadrant.
Point InFirstQuadrant(Point vector)
{
  while (!(vector.x() > 0.0 && vector.y() >= 0.0))
  {
    vector = TurnedLeft(vector);
  }
  return vector;
}

/// Gives each triangle to the nearest cone, by the distance of its centre in the unfolded map.
class ConeCells
{
public:
  explicit ConeCells(const SeamlessMap& map)
    : Map(map)
    , Owner(map.corners.size(), -1)
    , Unfolding(map.corners.size())
    , Rounding(Same * map.Extent())
  {
    const MeshTopology& topology = *map.topology;
    std::vector<int> coneAt(static_cast<std::size_t>(topology.VertexCount()), -1);
    for (std::size_t c = 0; c < map.cones.size(); ++c)
    {
      coneAt[map.cones[c].vertex] = static_cast<int>(c);
    }
    for (int t = 0; t < topology.TriangleCount(); ++t)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        const int cone = coneAt[topology.mesh.triangles[t][corner]];
        if (cone >= 0)
        {
          this->Offer(t, cone, { 0, -map.At(t, corner) });
        }
      }
    }
    this->Grow();
  }

  /// Returns the vectors between cones whose triangles share an edge.
  std::vector<Point> Vectors() const
  {
    std::map<std::pair<int, int>, std::vector<Point>> found;
    for (int t = 0; t < this->Map.topology->TriangleCount(); ++t)
    {
      for (int side = 0; side < 3; ++side)
      {
        const int other = this->Map.topology->Neighbour(t, side);
        if (other > t)
        {
          const Point from = this->Map.Across(t, side)(this->OriginIn(t));
          this->Add(
            this->OriginIn(other) - from, found[std::minmax(this->Owner[t], this->Owner[other])]);
        }
      }
    }
    std::vector<Point> all;
    for (const auto& [cones, vectors] : found)
    {
      all.insert(all.end(), vectors.begin(), vectors.end());
    }
    return all;
  }

private:
  /// A triangle with a cone that it may belong to.
  struct Claim
  {
    double distance;
    int triangle;
    int cone;
    SeamTransition unfolding; ///< From the chart of the triangle to one with the cone at 0.

    bool operator<(const Claim& other) const // the priority queue has the greatest on top
    {
      return std::tie(other.distance, other.triangle, other.cone) <
        std::tie(this->distance, this->triangle, this->cone);
    }
  };

  void Offer(int triangle, int cone, const SeamTransition& unfolding)
  {
    const Point centre =
      (this->Map.At(triangle, 0) + this->Map.At(triangle, 1) + this->Map.At(triangle, 2)) / 3.0;
    this->Claims.push({ unfolding(centre).norm(), triangle, cone, unfolding });
  }

  void Grow()
  {
    while (!this->Claims.empty())
    {
      const Claim claim = this->Claims.top();
      this->Claims.pop();
      if (this->Owner[claim.triangle] >= 0)
      {
        continue;
      }
      this->Owner[claim.triangle] = claim.cone;
      this->Unfolding[claim.triangle] = claim.unfolding;
      for (int side = 0; side < 3; ++side)
      {
        const int next = this->Map.topology->Neighbour(claim.triangle, side);
        if (next >= 0 && this->Owner[next] < 0)
        {
          this->Offer(next, claim.cone,
            After(this->Map.Across(claim.triangle, side).Inverse(), claim.unfolding));
        }
      }
    }
  }

  /// Returns the place of the owner of a triangle in its chart.
  Point OriginIn(int triangle) const { return this->Unfolding[triangle].Inverse()(Point::Zero()); }

  /// Adds a vector to a list unless it is there.
  void Add(const Point& vector, std::vector<Point>& list) const
  {
    if (!(vector.norm() > this->Rounding)) // of two triangles of the same unfolding
    {
      return;
    }
    const Point turned = InFirstQuadrant(vector);
    const auto isSame = [&](const Point& known)
    { return (known - turned).norm() <= this->Rounding; };
    if (std::none_of(list.begin(), list.end(), isSame))
    {
      list.push_back(turned);
    }
  }

  /// Differences of equal vectors, relative to the extent: above rounding, far below the distances of cones.
  static constexpr double Same = 1e-6;

  const SeamlessMap& Map;
  std::vector<int> Owner; ///< Cone of each triangle.
  std::vector<SeamTransition> Unfolding;
  const double Rounding;
  std::priority_queue<Claim> Claims;
};
}

std::vector<Point> VectorsBetweenCones(const SeamlessMap& map)
{
  return map.cones.empty() ? std::vector<Point>() : ConeCells(map).Vectors();
}
}
