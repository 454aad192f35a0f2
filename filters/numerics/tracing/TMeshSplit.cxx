#include "TMeshSplit.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace crossfield
{
namespace
{
class Splitter
{
public:
  Splitter(const SeamlessMap& map, TMesh& mesh)
    : Topology(*map.topology)
    , Mesh(mesh)
    , ArcAt(map.topology->mesh.boundary.size(), -1)
  {
    for (int arc = 0; arc < static_cast<int>(mesh.arcs.size()); ++arc)
    {
      this->SetArc(arc);
    }
  }

  void Split(int position)
  {
    const auto [vertex, next] = this->Topology.BoundaryAt(position).vertices;
    const SpacePoint place = this->Topology.PositionOf(vertex);
    // far above the rounding of places on separatrices, far below any detail
    const double rounding = 1e-9 * (this->Topology.PositionOf(next) - place).norm();
    const int arc = this->ArcAt[position];
    for (const int half : { 2 * arc, 2 * arc + 1 })
    {
      TNode& node = this->Mesh.nodes[this->Mesh.halfEdges[half].node];
      if ((node.place - place).norm() <= rounding)
      {
        node.isFixed = true;
        node.place = place;
        return;
      }
    }
    this->Divide(arc, this->PieceAt(arc, position), vertex);
  }

private:
  /// Returns the distance of the start of an arc from the vertex where its first boundary entry starts.
  double DistanceFromVertex(int arc) const
  {
    const int position = this->Mesh.arcs[arc].pieces.front().position;
    const SpacePoint vertex =
      this->Topology.PositionOf(this->Topology.BoundaryAt(position).vertices[0]);
    return (this->Mesh.nodes[this->Mesh.halfEdges[2 * arc].node].place - vertex).norm();
  }

  /// Notes the arc that each boundary entry starts on. That of the entry on which the arc itself
  /// starts is another one, unless the arc starts at the vertex. Of several that start on one entry
  /// it is the first.
  void SetArc(int arc)
  {
    const std::vector<ChartPiece>& pieces = this->Mesh.arcs[arc].pieces;
    if (!this->Mesh.arcs[arc].onBoundary)
    {
      return;
    }
    int& ofFirst = this->ArcAt[pieces.front().position];
    if (ofFirst < 0 ||
      (this->Mesh.arcs[ofFirst].pieces.front().position == pieces.front().position &&
        this->DistanceFromVertex(arc) < this->DistanceFromVertex(ofFirst)))
    {
      ofFirst = arc;
    }
    for (std::size_t i = 1; i < pieces.size(); ++i)
    {
      this->ArcAt[pieces[i].position] = arc;
    }
  }

  /// Returns the piece of an arc that begins where a boundary entry does. An arc once around a loop
  /// may end on the entry on which it begins.
  std::size_t PieceAt(int arc, int position) const
  {
    const std::vector<ChartPiece>& pieces = this->Mesh.arcs[arc].pieces;
    for (std::size_t i = pieces.size(); i-- > 1;)
    {
      if (pieces[i].position == position)
      {
        return i;
      }
    }
    return 0;
  }

  /// Divides an arc before one of its pieces, at a vertex of the boundary.
  void Divide(int arc, std::size_t first, int vertex)
  {
    const auto second = static_cast<int>(this->Mesh.arcs.size());
    const auto node = static_cast<int>(this->Mesh.nodes.size());
    const SpacePoint place = this->Topology.PositionOf(vertex);
    TNode added;
    added.kind = NodeKind::OnBoundary;
    added.quarters = 2;
    added.place = place;
    added.isFixed = true;
    this->Mesh.nodes.push_back(added);

    TArc& before = this->Mesh.arcs[arc];
    TArc after;
    after.onBoundary = true;
    after.loop = before.loop;
    after.pieces.assign(
      before.pieces.begin() + static_cast<std::ptrdiff_t>(first), before.pieces.end());
    before.pieces.resize(first);
    const auto lengthOf = [](const std::vector<ChartPiece>& pieces)
    {
      double length = 0.0;
      for (const ChartPiece& piece : pieces)
      {
        length += (piece.to - piece.from).norm();
      }
      return length;
    };
    after.length = lengthOf(after.pieces);
    before.length = lengthOf(before.pieces);
    const auto at = std::min_element(before.polyline.begin(), before.polyline.end(),
      [&place](const SpacePoint& a, const SpacePoint& b)
      { return (a - place).squaredNorm() < (b - place).squaredNorm(); });
    after.polyline.assign(at, before.polyline.end());
    after.polyline.front() = place;
    before.polyline.erase(at + 1, before.polyline.end());
    before.polyline.back() = place;
    this->Mesh.arcs.push_back(std::move(after));
    this->AddHalfEdges(arc, node);
    for (const ChartPiece& piece : this->Mesh.arcs[second].pieces)
    {
      this->ArcAt[piece.position] = second;
    }
  }

  /// Adds the half-edges of the last arc, which follows `arc` after `node`.
  void AddHalfEdges(int arc, int node)
  {
    const auto forward = static_cast<int>(this->Mesh.halfEdges.size());
    THalfEdge& along = this->Mesh.halfEdges[2 * arc];
    THalfEdge& back = this->Mesh.halfEdges[2 * arc + 1];
    const THalfEdge next = { node, 0, along.next, along.patch };
    const THalfEdge nextBack = back;
    const int patch = along.patch;
    along.next = forward;
    back.node = node;
    back.slot = 2;
    this->Mesh.halfEdges.push_back(next);
    this->Mesh.halfEdges.push_back(nextBack);
    for (std::vector<int>& side : this->Mesh.patches[patch].sides)
    {
      const auto found = std::find(side.begin(), side.end(), 2 * arc);
      if (found != side.end())
      {
        side.insert(found + 1, forward);
        return;
      }
    }
  }

  const MeshTopology& Topology;
  TMesh& Mesh;
  std::vector<int> ArcAt; ///< Arc that contains the start of every entry of mesh.boundary.
};
}

void SplitBoundaryArcs(const SeamlessMap& map, const std::vector<int>& positions, TMesh& mesh)
{
  Splitter splitter(map, mesh);
  for (const int position : positions)
  {
    splitter.Split(position);
  }
}
}
