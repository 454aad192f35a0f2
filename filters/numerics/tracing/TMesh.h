#pragma once

#include "TraceGraph.h"

namespace crossfield
{
enum class NodeKind
{
  Singularity,
  Corner,      ///< Corner of the boundary with a nonzero quarter index.
  OnBoundary,  ///< End of a separatrix on the boundary, or start of an extra one.
  OnSeparatrix ///< End of a separatrix on another one.
};

struct TNode
{
  NodeKind kind = NodeKind::Singularity;
  int cone = -1;    ///< Index in SeamlessMap::cones of a singularity or corner; else −1.
  int quarters = 4; ///< Angle around it, on the boundary the interior angle, in quarter turns.
  SpacePoint place = SpacePoint::Zero(); ///< Position in the domain.
  bool isFixed = false;                  ///< Quads must have a point exactly here (TMeshSplit.h).

  /// Returns whether the node must not coincide with another one of this kind.
  bool IsDistinct() const { return this->cone >= 0 || this->isFixed; }
};

/// One direction of an arc, with its patch on the left.
struct THalfEdge
{
  int node = 0;   ///< Node where it starts.
  int slot = 0;   ///< Direction at the node: quarter turns counter-clockwise from the node's first.
  int next = -1;  ///< Next half-edge around the patch.
  int patch = -1; ///< Patch on its left; −1 outside the domain.
};

/// The part of an arc in the chart of one triangle.
struct ChartPiece
{
  int triangle = 0;
  int direction = 0; ///< Direction of half-edge 2a: i^direction in the chart.
  Point from = Point::Zero();
  Point to = Point::Zero();
  int position = -1; ///< Entry of mesh.boundary for an arc on the boundary; else −1.
};

/// A straight path between two consecutive nodes. Half-edges 2a and 2a + 1 are its two directions.
struct TArc
{
  double length = 0.0; ///< Length in the map.
  bool onBoundary = false;
  int separatrix = -1; ///< Separatrix of an interior arc; the first of two that met head-on.
  int loop = -1;       ///< Loop in MeshTopology::loops of an arc on the boundary.
  std::vector<ChartPiece> pieces;   ///< Its path in the map, along half-edge 2a; never empty.
  std::vector<SpacePoint> polyline; ///< Its path in the domain, along half-edge 2a, ends included.
};

/// A rectangle in the map. Side i + 1 follows side i counter-clockwise; sides 0 and 2 are opposite.
struct TPatch
{
  std::array<std::vector<int>, 4> sides; ///< Half-edges in order around the patch.
};

/// The T-mesh of the separatrices of a seamless map (docs/method.md §13.2): plain data. A side of a
/// patch has several arcs where nodes are located on it (T-junctions).
struct TMesh
{
  std::vector<TNode> nodes;
  std::vector<THalfEdge> halfEdges;
  std::vector<TArc> arcs;
  std::vector<TPatch> patches;
  int separatrixCount = 0;   ///< Number of separatrices.
  int extraSeparatrices = 0; ///< Number of those that start on a boundary loop.
  int headOn = 0;            ///< Pairs of separatrices that meet head-on.
  int crossings = 0;         ///< Nodes where two separatrices end on a third from opposite sides.
  int ties = 0;              ///< Nodes at which two separatrices pass through each other.
  double longest = 0.0;      ///< Length of the longest separatrix in the map.

  /// Returns the opposite direction of a half-edge.
  static int Twin(int halfEdge) { return halfEdge ^ 1; }
  /// Returns the length in the map of a side of a patch.
  double SideLength(const TPatch& patch, std::size_t side) const;
  /// Returns the largest difference between the lengths of opposite sides of a patch.
  double Mismatch() const;
};
}
