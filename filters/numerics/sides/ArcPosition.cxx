#include "ArcPosition.h"

#include <algorithm>

namespace crossfield
{
ArcPosition FindOnArc(const TArc& arc, double distance)
{
  double remaining = distance;
  const ChartPiece* at = &arc.pieces.front();
  for (const ChartPiece& piece : arc.pieces)
  {
    at = &piece;
    const double length = (piece.to - piece.from).norm();
    if (remaining <= length)
    {
      break;
    }
    remaining -= &piece == &arc.pieces.back() ? 0.0 : length;
  }
  const double length = (at->to - at->from).norm();
  const double fraction = length > 0.0 ? std::clamp(remaining / length, 0.0, 1.0) : 0.0;
  return { at, at->from + fraction * (at->to - at->from) };
}

CurvePlace FindOnBoundary(
  const SeamlessMap& map, const MeshBoundary& curves, const ChartPiece& piece, const Point& w)
{
  const int side = map.topology->SideOfBoundary(piece.position).second;
  const Point& from = map.At(piece.triangle, side);
  const double length = (map.At(piece.triangle, (side + 1) % 3) - from).norm();
  return curves.Place(piece.position, std::clamp((w - from).norm() / length, 0.0, 1.0));
}
}
