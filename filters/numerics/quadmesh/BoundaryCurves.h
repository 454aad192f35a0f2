#pragma once

#include "CurvedLoops.h"
#include "LoopArc.h"
#include "PairedSides.h"

#include <vector>

namespace crossfield
{
/// A point on a boundary loop, given by its arc length.
struct CurvePlace
{
  int loop = -1;   ///< −1: not on the boundary.
  double at = 0.0; ///< Length along the polyline.
};

/// Boundary loops as curves in the plane or in space, parametrised by the arc length of polylines. Where the
/// boundary of a planar domain has a curve, points are on it (CurvedLoops.h).
class BoundaryCurves
{
public:
  /// `loops` have the domain on their left.
  explicit BoundaryCurves(const std::vector<Loop>& loops, const CurvedBoundary& boundary = {});
  /// Makes those of a surface.
  explicit BoundaryCurves(std::vector<ClosedPolyline<SpacePoint>> loops);

  /// Returns the point in space at a position.
  SpacePoint PlaceAt(const CurvePlace& place) const;
  /// Returns the derivative of PlaceAt by the arc length; on a polyline its unit tangent, at a vertex that of the
  /// edge after it.
  SpacePoint DirectionAt(const CurvePlace& place) const;
  double Length(int loop) const;
  /// Returns the arc length at a vertex of a polyline; for the number of vertices, its length.
  double StartOf(int loop, std::size_t vertex) const;
  /// Returns the side of the polyline at a position; at a vertex it is the side after it.
  std::size_t SideAt(const CurvePlace& place) const;

  /// Returns the triangle of a surface at a position; `otherwise` if it is not known.
  int TriangleAt(const CurvePlace& place, int otherwise) const;

  bool IsInPlane() const { return this->InSpace.empty(); }

  /// Returns the position on a side of a pair, the first (0) or second (1), on a loop, that is the image of a
  /// position on the other one: in the plane the nearest to `image`, on a surface the one as far from the middle
  /// of the side.
  CurvePlace ImageOn(const PairedSides& pair, std::size_t side, int loop, const CurvePlace& other,
    const SpacePoint& image) const;

  // In the plane only:

  /// Returns the point of the plane at a position.
  Point At(const CurvePlace& place) const;
  /// Returns the position on a loop nearest to a point; the vertex if two adjacent edges are
  /// equally near. Cost: linear in the vertices of the loop.
  CurvePlace Nearest(int loop, const Point& point) const;
  /// Returns the position on a side of a pair, the first (0) or second (1), nearest to a point.
  CurvePlace NearestOn(
    const PairedSides& pair, std::size_t side, int loop, const Point& point) const;
  /// Returns the derivative of At by the arc length.
  Point Tangent(const CurvePlace& place) const;
  /// Returns the index of the curve at a position, −1 if it is on a polyline.
  int CurveAt(const CurvePlace& place) const;
  /// Returns the polylines.
  const std::vector<LoopArc>& GetArcs() const { return this->Arcs; }
  const LoopArc& ArcOf(int loop) const { return this->Arcs[loop]; }

private:
  std::vector<LoopArc> Arcs; ///< In the plane.
  CurvedLoops Curved;
  std::vector<ClosedPolyline<SpacePoint>> InSpace; ///< On a surface.

protected:
  /// Of a surface, per loop and side of its polyline; empty if they are not known.
  std::vector<std::vector<int>> Triangles;
};
}
