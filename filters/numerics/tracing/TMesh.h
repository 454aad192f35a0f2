#pragma once

#include "TraceGraph.h"

namespace crossfield
{
enum class NodeKind
{
  Singularity,
  Corner,     ///< Of the boundary, with a quarter index.
  OnBoundary, ///< A line ends there, or an extra one starts.
  OnLine      ///< A line ends at another one.
};

struct TNode
{
  NodeKind kind = NodeKind::Singularity;
  int cone = -1;    ///< In SeamlessMap::cones, of singularities and corners.
  int quarters = 4; ///< The angle around it, in quarter turns; at the boundary that inside.
  Point place = Point::Zero(); ///< In the plane.
};

/// One direction of an arc, with its face on the left.
struct THalfEdge
{
  int node = 0;  ///< Where it starts.
  int slot = 0;  ///< Its direction there: quarter turns, counter-clockwise from the node's first.
  int next = -1; ///< Around the face.
  int face = -1; ///< −1 outside of the domain.
};

/// The part of an arc in the chart of one triangle.
struct ChartPiece
{
  int triangle = 0;
  int direction = 0; ///< Along half-edge 2a, i^direction in the chart.
  Point from = Point::Zero();
  Point to = Point::Zero();
  int position = -1; ///< Of boundary ones, the entry of mesh.boundary.
};

/// A straight way between two nodes. Half-edges 2a and 2a + 1 are its two directions.
struct TArc
{
  double length = 0.0; ///< In the map.
  bool onBoundary = false;
  int line = -1; ///< Of interior ones, in TraceGraph::lines; the first of two that met head-on.
  int loop = -1; ///< Of boundary ones, the loop in MeshTopology::loops.
  std::vector<ChartPiece> pieces; ///< In the map, along half-edge 2a; never empty.
  std::vector<Point> polyline;    ///< In the plane, along half-edge 2a, ends included.
};

/// A rectangle of the map. Side i + 1 follows side i counter-clockwise; sides 0 and 2 are opposite.
struct TPatch
{
  std::array<std::vector<int>, 4> sides; ///< Half-edges, in order around the face.
};

/// The T-mesh of the lines of a flat map (docs/method.md §13.2): plain data. Where a node lies in the middle of a
/// side of a face, the side has several arcs.
struct TMesh
{
  std::vector<TNode> nodes;
  std::vector<THalfEdge> halfEdges;
  std::vector<TArc> arcs;
  std::vector<TPatch> faces;
  int lineCount = 0;
  int extraLines = 0;
  int headOn = 0;
  int crossings = 0;    ///< Nodes where lines end at one point of a third from both sides.
  double longest = 0.0; ///< Line, in the map.

  static int Twin(int halfEdge) { return halfEdge ^ 1; }
  double SideLength(const TPatch& face, std::size_t side) const;
  /// Largest difference of the lengths of opposite sides.
  double Mismatch() const;
};
}
