#pragma once

#include "TMesh.h"

namespace crossfield
{
/// A node on a separatrix or on a boundary loop.
struct TMeshStop
{
  double at = 0.0; ///< Length along the separatrix, the boundary edge or the loop.
  int node = 0;
  int forward = 0;  ///< Slot at the node of the direction along the path.
  int backward = 0; ///< Slot at the node of the direction against it.
  int side = 0;     ///< 1 or 3 where another separatrix ends from the left or from the right.
};

/// The nodes of a T-mesh, and their stops on separatrices and boundary edges.
class TMeshStops
{
public:
  TMeshStops(const SeamlessMap& map, const TraceGraph& graph);

  const std::vector<TNode>& GetNodes() const { return this->Nodes; }
  /// Returns the number of nodes where two separatrices end on a third from opposite sides.
  int CrossingCount() const { return this->Crossings; }
  /// Returns the node to which a node was joined, or the node itself.
  int Joined(int node) const { return this->Same[node]; }
  /// Returns the slot at Joined(node) of a slot at `node`.
  int JoinedSlot(int node, int slot) const
  {
    const int shift = this->Shift[node];
    return shift == 0 ? slot : (slot + shift) % 4;
  }

  /// Returns the stops on separatrix i, or on two that meet head-on, from start to end; none for
  /// the second of those.
  std::vector<TMeshStop> OnSeparatrix(std::size_t i) const;
  /// The stops on an entry of mesh.boundary, in its direction.
  const std::vector<TMeshStop>& OnEdge(int position) const { return this->OnBoundary[position]; }

  /// Returns the entry of mesh.boundary that starts at a vertex.
  int PositionAt(int vertex) const { return this->Positions[vertex]; }

private:
  int AddNode(const TNode& node);
  /// Adds a node on an entry of mesh.boundary, at coordinates w of its chart.
  int AddBoundaryNode(int position, const Point& w, const SpacePoint& place);
  /// Returns the length along an entry of mesh.boundary of coordinates w of its chart.
  double AlongEdge(int position, const Point& w) const;
  void AddCones();
  void AddStart(std::size_t i);
  void AddEnd(std::size_t i);
  /// Adds the node of two separatrices that both continue.
  void AddTie(const SeparatrixTie& tie);
  /// Returns the node where separatrix i ends, which AddEnd added; −1 where it meets another
  /// head-on.
  int EndNode(std::size_t i) const;
  /// Joins the nodes of separatrices that end at one point of another one from opposite sides. This
  /// is exact where the two would have met head-on, as those do that follow a boundary without
  /// corners.
  void JoinCrossings(const std::vector<TMeshStop>& stops);

  const SeamlessMap& Map;
  const MeshTopology& Topology;
  const LineWalk Walk;
  const std::vector<TracedSeparatrix>& Lines;
  std::vector<TNode> Nodes;
  std::vector<std::vector<TMeshStop>> OnLines;    ///< Per separatrix, in the order of addition.
  std::vector<std::vector<TMeshStop>> OnBoundary; ///< Per entry of mesh.boundary.
  std::vector<int> Positions;                     ///< See PositionAt.
  std::vector<int> Same;                          ///< See Joined.
  std::vector<int> Shift;                         ///< Slot at the joined node of slot 0.
  int Crossings = 0;
};
}
