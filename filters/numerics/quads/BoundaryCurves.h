#pragma once

#include "LoopArc.h"
#include "MeshTopology.h"

namespace crossfield
{
/// A place on a boundary loop: the length along its polyline.
struct CurvePlace
{
  int loop = -1; ///< −1: not on the boundary.
  double at = 0.0;
};

/// The boundary loops of a mesh as curves by their length, in the plane.
class BoundaryCurves
{
public:
  explicit BoundaryCurves(const MeshTopology& topology);

  /// The place at a fraction of an entry of mesh.boundary.
  CurvePlace Place(int boundaryPosition, double fraction) const;
  Point At(const CurvePlace& place) const;
  /// The place of a loop that is nearest to a point; the vertex between two edges that are equally near. Linear in the
  /// loop's vertices.
  CurvePlace Nearest(int loop, const Point& point) const;
  /// Unit vector along the polyline there; at a vertex that of the edge after it.
  Point Tangent(const CurvePlace& place) const;
  double Length(int loop) const { return this->ArcOf(loop).Length(); }
  /// Places of the vertices that are corners (MeshTopology::corners).
  std::vector<CurvePlace> Corners() const;
  /// The entry of mesh.boundary at a place.
  int PositionAt(const CurvePlace& place) const;

private:
  const LoopArc& ArcOf(int loop) const { return this->Arcs[static_cast<std::size_t>(loop)]; }

  const MeshTopology& Topology;
  std::vector<LoopArc> Arcs;               ///< Of the aligned loops.
  std::vector<std::vector<int>> Positions; ///< Entries of mesh.boundary, per loop and side.
  std::vector<std::pair<int, std::size_t>> LoopAndEdge; ///< Of every entry.
};
}
