#include "ThroughPoints.h"

namespace crossfield
{
DrawingPiece ThroughPoints(
  const std::vector<Point>& points, bool isPeriodic, const EndTangents& tangents)
{
  std::vector<Point> places;
  for (const Point& point : points)
  {
    if (places.empty() || point != places.back())
    {
      places.push_back(point);
    }
  }
  if (places.size() < 3)
  {
    return LinePiece(places.front(), places.back());
  }
  const Point first = places.front();
  const Point last = places.back();
  const bool isClosed = isPeriodic && places.size() > 3;
  if (isClosed)
  {
    places.pop_back(); // the first one again
  }
  const PlaneCurve curve = SplineThrough(places, isClosed, tangents);
  DrawingPiece piece = CurvePiece(curve, curve.knots.front(), curve.knots.back());
  piece.first = first;
  piece.last = last;
  return piece;
}
}
