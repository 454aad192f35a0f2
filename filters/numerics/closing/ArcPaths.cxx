#include "ArcPaths.h"

#include "Index.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Half-edges with an odd number are directed against their separatrix.
bool LeadsToStart(int halfEdge)
{
  return halfEdge % 2 == 1;
}
}

ArcPaths::ArcPaths(const SeamlessMap& map, const TMesh& tMesh)
  : Map(map)
  , Mesh(tMesh)
  , BySlot(tMesh.nodes.size())
{
  for (int h = 0; h < static_cast<int>(tMesh.halfEdges.size()); ++h)
  {
    const THalfEdge& half = tMesh.halfEdges[h];
    std::vector<int>& slots = this->BySlot[half.node];
    slots.resize(std::max(slots.size(), Index(half.slot) + 1), -1);
    slots[half.slot] = h;
  }
}

int ArcPaths::At(int node, int slot) const
{
  const TNode& at = this->Mesh.nodes[node];
  const bool closed = at.kind == NodeKind::Singularity || at.kind == NodeKind::OnSeparatrix;
  const int wrapped = closed ? (slot + at.quarters) % at.quarters : slot;
  const std::vector<int>& slots = this->BySlot[node];
  return wrapped >= 0 && Index(wrapped) < slots.size() ? slots[wrapped] : -1;
}

void ArcPaths::Append(
  int halfEdge, const std::complex<double>& direction, std::vector<ArcPath::Piece>& pieces) const
{
  const std::vector<ChartPiece>& ofArc = this->Mesh.arcs[halfEdge / 2].pieces;
  for (std::size_t i = 0; i < ofArc.size(); ++i)
  {
    const bool forward = halfEdge % 2 == 0;
    const ChartPiece& piece = ofArc[forward ? i : ofArc.size() - 1 - i];
    ArcPath::Piece added{ piece.triangle, this->Map.PlaceOf(piece.triangle, piece.from).head<2>(),
      this->Map.PlaceOf(piece.triangle, piece.to).head<2>(),
      direction * (piece.to - piece.from).norm() };
    if (!forward)
    {
      std::swap(added.from, added.to);
    }
    pieces.push_back(added);
  }
}

std::optional<ArcPaths::Way> ArcPaths::Follow(
  int halfEdge, const std::complex<double>& direction) const
{
  Way way;
  // A separatrix passes every half-edge at most once.
  for (std::size_t passed = 0; passed < this->Mesh.halfEdges.size(); ++passed)
  {
    this->Append(halfEdge, direction, way.pieces);
    const THalfEdge& back = this->Mesh.halfEdges[TMesh::Twin(halfEdge)];
    const TNode& node = this->Mesh.nodes[back.node];
    way.cone = node.cone;
    if (node.cone >= 0)
    {
      return way;
    }
    halfEdge = node.kind == NodeKind::OnSeparatrix ? this->At(back.node, back.slot + 2) : -1;
    if (halfEdge < 0)
    {
      break;
    }
  }
  return {};
}

std::optional<ArcPaths::Way> ArcPaths::FromEnd(
  int halfEdge, const std::complex<double>& direction) const
{
  const THalfEdge& half = this->Mesh.halfEdges[halfEdge];
  const TNode& node = this->Mesh.nodes[half.node];
  Way way;
  way.cone = node.cone;
  const bool onBoundary = this->Mesh.arcs[halfEdge / 2].onBoundary;
  // Along the boundary the direction of crosses does not change, so it adds nothing to a derivative.
  if (node.cone >= 0 || (node.kind == NodeKind::OnBoundary && !onBoundary))
  {
    return way;
  }
  std::optional<Way> shortest;
  for (const int turn : { 1, -1 })
  {
    const int side = this->At(half.node, half.slot + turn);
    if (side < 0 || this->Mesh.arcs[side / 2].onBoundary || !LeadsToStart(side))
    {
      continue;
    }
    const std::complex<double> quarter(0.0, turn);
    std::optional<Way> found = this->Follow(side, quarter * direction);
    if (found && (!shortest || found->pieces.size() < shortest->pieces.size()))
    {
      shortest = std::move(found);
    }
  }
  return shortest;
}

std::optional<ArcPath> ArcPaths::Of(int arc) const
{
  const std::complex<double> i(0.0, 1.0);
  std::optional<Way> first = this->FromEnd(2 * arc, i);
  std::optional<Way> last = this->FromEnd(2 * arc + 1, -i);
  if (!first || !last)
  {
    return {};
  }
  ArcPath path;
  path.firstCone = first->cone;
  path.lastCone = last->cone;
  for (auto piece = first->pieces.rbegin(); piece != first->pieces.rend(); ++piece)
  {
    path.pieces.push_back({ piece->triangle, piece->to, piece->from, -piece->step });
  }
  this->Append(2 * arc, i, path.pieces);
  path.pieces.insert(path.pieces.end(), last->pieces.begin(), last->pieces.end());
  return path;
}

std::vector<ArcPath> ArcPaths::Joined() const
{
  std::vector<ArcPath> joined;
  for (int h = 0; h < static_cast<int>(this->Mesh.halfEdges.size()); ++h)
  {
    const int cone = this->Mesh.nodes[this->Mesh.halfEdges[h].node].cone;
    if (cone < 0 || this->Mesh.arcs[h / 2].onBoundary)
    {
      continue;
    }
    std::optional<Way> way = this->Follow(h, 1.0);
    if (way && cone < way->cone) // otherwise the path is found from its other end
    {
      joined.push_back({ cone, way->cone, std::move(way->pieces) });
    }
  }
  return joined;
}
}
