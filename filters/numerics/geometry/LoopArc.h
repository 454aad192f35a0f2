#pragma once

#include "ClosedPolyline.h"

namespace crossfield
{
/// Arc-length parametrisation of a loop in the plane.
class LoopArc : public ClosedPolyline<Point>
{
public:
  explicit LoopArc(const Loop& loop)
    : ClosedPolyline<Point>(loop)
  {
  }

  /// Returns the arc length of the point of the loop nearest to a given point. If two adjacent
  /// sides are equally near, it is the vertex between them. Takes time linear in the number of
  /// vertices.
  double Nearest(const Point& place) const;

  /// Works as Nearest on the sides of the part of a length that starts at an arc length.
  double NearestOnPart(const Point& place, double start, double length) const;

  /// Works as Nearest, but returns a negative number if the distance exceeds `reach`.
  double Find(const Point& place, double reach) const;
  /// Returns the arc lengths of those points that are at most `reach` away from the loop.
  std::vector<double> FindAll(const std::vector<Point>& places, double reach) const;

  /// Returns the turning angles at the vertices, positive to the left.
  std::vector<double> Turns() const;

  /// Returns the arc lengths of the vertices that are corners (IsCorner), in increasing order.
  std::vector<double> Corners(double cornerAngle) const;
};

/// Vertex of a simplified loop, with its parameter on the original loop.
struct ArcVertex
{
  double at = 0.0; ///< Arc length on the original loop, in [0, Length()).
  Point place = Point::Zero();
};

/// Returns the largest distance from a vertex of a loop to the side of the simplified loop that
/// replaces it. Such a side joins two consecutive vertices, whose `at` increase around the loop.
double LargestDistance(const LoopArc& arc, const std::vector<ArcVertex>& vertices);

/// Returns the positions of vertices.
Loop PositionsOf(const std::vector<ArcVertex>& vertices);
}
