#pragma once

#include "CurvedLoops.h"
#include "LoopArc.h"
#include "PlanarTopology.h"

namespace crossfield
{
/// A point on a boundary loop, given by its arc length.
struct CurvePlace
{
  int loop = -1;   ///< −1: not on the boundary.
  double at = 0.0; ///< Length along the polyline.
};

/// The boundary loops of a mesh as curves in the plane, parametrised by arc length of the polyline
/// along the mesh. Where the boundary has a curve, points are on it (CurvedLoops.h).
class BoundaryCurves
{
public:
  explicit BoundaryCurves(const PlanarTopology& topology, const CurvedBoundary& boundary = {});

  /// Returns the position at a fraction of an entry of mesh.boundary.
  CurvePlace Place(int boundaryPosition, double fraction) const;
  /// Returns the point of the plane at a position.
  Point At(const CurvePlace& place) const;
  /// Returns the position on a loop nearest to a point; the vertex if two adjacent edges are
  /// equally near. Cost: linear in the vertices of the loop.
  CurvePlace Nearest(int loop, const Point& point) const;
  /// Returns the derivative of At by the arc length; on a polyline its unit tangent, at a vertex that
  /// of the edge after it.
  Point Tangent(const CurvePlace& place) const;
  /// Returns the index of the curve at a position, −1 if it is on a polyline.
  int CurveAt(const CurvePlace& place) const;
  /// Returns the polylines.
  const std::vector<LoopArc>& GetArcs() const { return this->Arcs; }
  double Length(int loop) const { return this->ArcOf(loop).Length(); }
  /// Returns the positions of corner vertices (MeshTopology::corners).
  std::vector<CurvePlace> Corners() const;
  /// Returns the entry of mesh.boundary at a position.
  int PositionAt(const CurvePlace& place) const;

private:
  const LoopArc& ArcOf(int loop) const { return this->Arcs[static_cast<std::size_t>(loop)]; }

  const PlanarTopology& Topology;
  std::vector<LoopArc> Arcs; ///< The aligned loops.
  CurvedLoops Curved;
  std::vector<std::vector<int>> Positions; ///< Entries of mesh.boundary, per loop and side.
  std::vector<std::pair<int, std::size_t>> LoopAndEdge; ///< Per entry of mesh.boundary.
};
}
