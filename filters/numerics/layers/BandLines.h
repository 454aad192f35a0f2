#pragma once

#include "MonotoneCurve.h"
#include "QuadBand.h"

namespace crossfield
{
/// A grid line across a band, from the wall inwards.
struct BandLine
{
  /// Whether one of its neighbours along the wall is a layered side; others are beyond a side.
  bool isLayered = false;
  bool hasFirst = false; ///< Whether a layer prescribes the height of its first row.
  double length = 0.0;   ///< Length across the band.
  double first = 0.0;    ///< Height of the first row along the line; without one that of the quads.
};

/// The grid lines across a band as curves, and the heights of rows along them (docs/method.md
/// §16.2).
class BandLines
{
public:
  /// Constructs the lines across the first rows of a band.
  BandLines(const LayeredMesh& layered, const QuadBand& band, const QuadWalk& walk,
    const BoundaryCurves& curves, int rows);

  const std::vector<BandLine>& Lines() const { return this->Data; }
  /// Returns the point of a line at the wall.
  const Point& WallAt(std::size_t line) const { return this->Walls[line]; }
  /// Returns the number of rows with which no line grows faster than its layers allow.
  int RowsNeeded() const;
  /// Returns the maximum ratio of the row behind the band to the last of `rows` new rows, or its
  /// inverse, over the columns at layered sides.
  double LargestStep(int rows) const;
  /// Returns the new inner points of all lines for a number of rows.
  std::vector<std::vector<QuadPoint>> Divide(int rows) const;
  /// Returns the maximum ratio of consecutive edges of the divided lines, from the wall inwards.
  double LargestGrowth(const std::vector<std::vector<QuadPoint>>& points) const;

private:
  /// Returns the prescribed heights of the first row at the wall, normal to it, and marks the lines
  /// at layered sides.
  std::vector<double> HeightsAtWall();
  /// Returns the height of the first of `rows` rows along a line.
  double FirstOf(const BandLine& line, int rows) const;
  /// Returns the mean sine of the angles between a direction at a line's start and the wall, or its
  /// layered part.
  double SineAtWall(std::size_t line, const Point& direction) const;
  Point PlaceOf(int point) const { return this->Layered.mesh.points[point].InPlane(); }
  bool IsEnd(std::size_t line) const;
  /// Returns the points of a line as a curve. At a corner that rows of layers turn around, it
  /// starts along the bisector, so that the rows are as high on both sides.
  MonotoneCurve CurveOf(std::size_t line) const;
  /// Returns the arc lengths on the boundary from the start of an end line to its points.
  std::vector<double> LengthsOnBoundary(std::size_t line) const;
  /// Returns the position on the boundary at a length from the start of an end line.
  CurvePlace PlaceOnBoundary(std::size_t line, double length) const;
  /// Returns, per line, the part of the deviation of the boundary at an end line from a smooth
  /// curve that it takes.
  std::vector<double> PartsOfEnd(std::size_t end) const;

  const LayeredMesh& Layered;
  const QuadBand& Band;
  const QuadWalk& Walk;
  const BoundaryCurves& Curves;
  const int OldRows;
  std::vector<std::vector<int>> Points; ///< Per line.
  std::vector<Point> Walls;             ///< Per line, its point at the wall.
  std::vector<BandLine> Data;
};
}
