#pragma once

#include "MeshBoundary.h"
#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// A point of an arc of a T-mesh.
struct ArcPosition
{
  const ChartPiece* piece = nullptr; ///< The piece that contains the point.
  Point w = Point::Zero();           ///< The point in the map, in the chart of the piece.
};

/// Returns the point of an arc at a distance in the map from its start.
ArcPosition FindOnArc(const TArc& arc, double distance);

/// Returns the position on the boundary of a point in the map on a piece along the boundary.
CurvePlace FindOnBoundary(
  const SeamlessMap& map, const MeshBoundary& curves, const ChartPiece& piece, const Point& w);
}
