#pragma once

#include "VertexFan.h"

namespace crossfield
{
/// Where a line is on the outline of a triangle.
struct OutlinePoint
{
  int side = 0;          ///< Of the triangle.
  double fraction = 0.0; ///< From the side's start; 0 is the corner.
};

/// The part of a straight line inside of one triangle. In the chart of the triangle the line runs along
/// i^direction; the coordinate across is `level`, exactly, and the length from the line's start is
/// ± the coordinate along + offset.
struct LineSegment
{
  int triangle = 0;
  int direction = 0;
  double level = 0.0;
  double offset = 0.0;
  OutlinePoint entry;
  OutlinePoint exit;
  double entryLength = 0.0;
  double exitLength = 0.0;
  bool startsInside = false; ///< At a point of the triangle, not on its outline.

  bool AlongU() const { return this->direction % 2 == 0; }
  double Sign() const { return this->direction < 2 ? 1.0 : -1.0; }
  /// Length at a coordinate along, and the other way round.
  double LengthAt(double coordinate) const { return this->Sign() * coordinate + this->offset; }
  double CoordinateAt(double length) const { return this->Sign() * (length - this->offset); }
  Point At(double length) const
  {
    const double along = this->CoordinateAt(length);
    return this->AlongU() ? Point(along, this->level) : Point(this->level, along);
  }
};

/// Steps of straight lines from triangle to triangle (docs/method.md §13.1). Which side a line leaves through follows
/// from the sign of one exact comparison: whether the vertex ahead is on its left. A vertex on the line counts
/// as left, in every triangle, so that no line is lost.
class LineWalk
{
public:
  explicit LineWalk(const SeamlessMap& map)
    : Map(map)
  {
  }

  LineSegment Start(const Departure& departure) const;
  /// Into the domain from the middle of a boundary edge, at right angles.
  LineSegment StartFromSide(int boundaryPosition) const;
  /// From a point of a triangle.
  LineSegment StartInside(int triangle, const Point& w, int direction) const;

  /// The triangle beyond the end of a segment; −1 when that is on the boundary.
  int Beyond(const LineSegment& segment) const;
  /// The segment in the triangle beyond.
  LineSegment Continue(const LineSegment& segment) const;

  /// The point of the plane at a length within a segment.
  Point PlaneAt(const LineSegment& segment, double length) const;
  Point PlaneAt(int triangle, const OutlinePoint& point) const;
  /// The point of the plane where a triangle has coordinates w.
  Point PlaneAt(int triangle, const Point& w) const;

private:
  /// Of the coordinates of a corner of a triangle those across and along a direction.
  double Across(const LineSegment& segment, int corner) const;
  double Along(const LineSegment& segment, int corner) const;
  bool IsLeft(const LineSegment& segment, int corner) const;
  void Leave(LineSegment& segment, int side) const;

  const SeamlessMap& Map;
};
}
