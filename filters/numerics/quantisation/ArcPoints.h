#pragma once

#include "TMesh.h"
#include "UnionFind.h"

namespace crossfield
{
/// Two points that coincide because an arc has no edges, or a patch zero width.
struct PointLink
{
  int from = 0;
  int to = 0;
  int arc = -1;   ///< −1 if it is a patch.
  int patch = -1; ///< −1 if it is an arc.
  int side = 0;   ///< The first of the two sides of the patch that have no edges.
};

/// The points on the arcs of a T-mesh with edge counts (docs/method.md §14.3): the nodes, then n_a
/// − 1 in the interior of every arc.
class ArcPoints
{
public:
  ArcPoints(const TMesh& mesh, const std::vector<int>& counts);

  int Count() const { return this->Total; }
  /// Returns the number of edges along a half-edge.
  int CountOf(int halfEdge) const { return this->Counts[halfEdge / 2]; }
  /// Returns the j-th point along a half-edge, 0 ≤ j ≤ n_a.
  int At(int halfEdge, int j) const;
  /// Returns the points along a side of a patch, one more than it has edges.
  std::vector<int> AlongSide(const TPatch& patch, std::size_t side) const;
  /// Returns the number of edges along a side of a patch.
  int SideCount(const TPatch& patch, std::size_t side) const;
  /// Returns the pairs of points that coincide.
  std::vector<PointLink> Links() const;

private:
  const TMesh& Mesh;
  const std::vector<int>& Counts;
  std::vector<int> Offsets; ///< Number of the first interior point of every arc.
  int Total = 0;
};
}
