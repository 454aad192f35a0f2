#pragma once

#include "Drawing.h"
#include "DxfText.h"

#include <vector>

namespace crossfield
{
/// Returns whether an entity is a curve that DxfCurves reads.
bool IsDxfCurve(std::string_view type);

/// Returns the pieces of an entity of a .dxf file: LINE, ARC, CIRCLE, ELLIPSE, SPLINE, LWPOLYLINE,
/// or POLYLINE with its vertices. Throws Error if a value is missing or not valid, or if the plane of
/// the entity is not parallel to z = 0.
std::vector<DrawingPiece> DxfCurves(
  const DxfObject& entity, const std::vector<DxfObject>& vertices);

/// Returns the map from the coordinate system of an entity to that of the drawing: the identity, or
/// the reflection of x if the entity is seen from below.
AffineMap DxfEntityMap(const DxfObject& entity);
}
