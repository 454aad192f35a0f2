#pragma once

#include "Plane.h"

#include <utility>

namespace crossfield
{
/// Arc-length parametrisation of a closed polyline, starting at its first vertex.
class LoopArc
{
public:
  explicit LoopArc(const Loop& loop);

  /// Returns the length of the loop.
  double Length() const { return this->Starts.back(); }
  /// Returns the arc length at a vertex; for the number of vertices, the length of the loop.
  double Start(std::size_t vertex) const { return this->Starts[vertex]; }
  const Loop& Vertices() const { return this->Polyline; }

  // Arc lengths may be negative or exceed the length of the loop.

  /// Returns the side at an arc length and the position on it as a fraction in [0, 1]. At a vertex
  /// it is the side after the vertex.
  std::pair<std::size_t, double> SideAt(double length) const;

  /// Returns the point at an arc length.
  Point At(double length) const;

  /// Returns the unit vector along the side at an arc length.
  Point Tangent(double length) const;

  /// Returns the vertex nearest to an arc length, measured along the loop.
  std::size_t NearestVertex(double length) const;

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

private:
  double Wrap(double length) const;
  const Point& End(std::size_t side) const
  {
    return this->Polyline[(side + 1) % this->Polyline.size()];
  }

  Loop Polyline;
  std::vector<double> Starts; ///< Arc lengths of the vertices, followed by the length of the loop.
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
