#pragma once

#include "TMesh.h"

namespace crossfield
{
/// Joins numbers into classes.
class UnionFind
{
public:
  explicit UnionFind(std::size_t count);
  int Find(int i);
  void Join(int i, int j) { this->Parent[static_cast<std::size_t>(this->Find(i))] = this->Find(j); }

private:
  std::vector<int> Parent;
};

/// Two points that are one because an arc, or a face, has no width.
struct PointLink
{
  int from = 0;
  int to = 0;
  int arc = -1;
  int face = -1;
  int side = 0; ///< Of the face, the first of the two sides that have no width.
};

/// The points that a T-mesh with counts has on its arcs (docs/method.md §14.3): its nodes, then n_a − 1 inside of
/// every arc.
class ArcPoints
{
public:
  ArcPoints(const TMesh& mesh, const std::vector<int>& counts);

  int Count() const { return this->Total; }
  /// Edges along a half-edge.
  int CountOf(int halfEdge) const { return this->Counts[static_cast<std::size_t>(halfEdge / 2)]; }
  /// The j-th point along a half-edge, 0 to n_a.
  int At(int halfEdge, int j) const;
  /// The points along a side of a face, one more than it has edges.
  std::vector<int> AlongSide(const TPatch& face, std::size_t side) const;
  int SideCount(const TPatch& face, std::size_t side) const;
  std::vector<PointLink> Links() const;

private:
  const TMesh& Mesh;
  const std::vector<int>& Counts;
  std::vector<int> Offsets; ///< Of the first point inside of every arc.
  int Total = 0;
};
}
