#pragma once

#include "VertexFan.h"

#include <optional>

namespace crossfield
{
/// A point on the outline of a triangle.
struct OutlinePoint
{
  int side = 0;          ///< Side of the triangle.
  double fraction = 0.0; ///< Fraction of the side from its start; 0 is the corner.
};

/// The part of a straight line in one triangle. In the chart of the triangle the line runs in
/// direction i^direction; its transverse coordinate is exactly `level`, and the length from the
/// line's start is ± the longitudinal coordinate + offset.
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
  bool startsInside = false; ///< Starts at a point inside the triangle, not on its outline.

  bool AlongU() const { return this->direction % 2 == 0; }
  double Sign() const { return this->direction < 2 ? 1.0 : -1.0; }
  /// Convert between the length from the start and the longitudinal coordinate.
  double LengthAt(double coordinate) const { return this->Sign() * coordinate + this->offset; }
  double CoordinateAt(double length) const { return this->Sign() * (length - this->offset); }
  /// Returns the point at a length, in the chart of the triangle.
  Point At(double length) const
  {
    const double along = this->CoordinateAt(length);
    return this->AlongU() ? Point(along, this->level) : Point(this->level, along);
  }
};

/// Follows straight lines from triangle to triangle (docs/method.md §13.1). The side through which
/// a line leaves follows from one exact comparison: whether the vertex ahead is on its left. A
/// vertex on the line counts as left, in every triangle, so that no line is lost.
class LineWalk
{
public:
  explicit LineWalk(const SeamlessMap& map)
    : Map(map)
  {
  }

  /// Starts at a vertex.
  LineSegment Start(const Departure& departure) const;
  /// Starts at the midpoint of a boundary edge, perpendicular to it, into the domain.
  LineSegment StartFromSide(int boundaryPosition) const;
  /// Starts at a point of a triangle.
  LineSegment StartInside(int triangle, const Point& w, int direction) const;

  /// Returns the triangle beyond the end of a segment; −1 when the end is on the boundary.
  int Beyond(const LineSegment& segment) const;
  /// Returns the segment in the triangle beyond.
  LineSegment Continue(const LineSegment& segment) const;
  /// Returns a segment along a side of its triangle, up to `tolerance`, in the chart of the
  /// triangle beyond that side, without its entry and exit; none if it is along no side, or one of
  /// the boundary.
  std::optional<LineSegment> Beside(const LineSegment& segment, double tolerance) const;

  /// Returns the point of the domain at a length within a segment.
  SpacePoint PlaceAt(const LineSegment& segment, double length) const;
  SpacePoint PlaceAt(int triangle, const OutlinePoint& point) const;

private:
  /// Sets the triangle beyond a side and what depends on its chart.
  void Pass(const LineSegment& segment, int side, LineSegment& next) const;
  /// Return the transverse and longitudinal coordinate of a corner of the segment's triangle.
  double Across(const LineSegment& segment, int corner) const;
  double Along(const LineSegment& segment, int corner) const;
  /// Returns whether a corner is on the left of the line or on it.
  bool IsLeft(const LineSegment& segment, int corner) const;
  /// Sets the exit of a segment, through a side of its triangle.
  void Leave(LineSegment& segment, int side) const;

  const SeamlessMap& Map;
};
}
