#pragma once

#include <vector>

namespace crossfield
{
/// Lengths of the edges along a side: a geometric sequence on every part of the side between two
/// corners, in the direction with the domain on the left.
struct Progression
{
  /// Last over first edge; towards both ends, the middle over the first.
  double ratio = 1.0;
  bool both = false; ///< The same sequence from both ends to the middle.
  /// Lengths of the first and the last edge, instead of the ratio; towards both ends, of the first
  /// and of the middle one. They prescribe the number of edges. 0: not prescribed.
  double first = 0.0;
  double last = 0.0;

  bool HasLengths() const { return this->first > 0.0; }
};

/// What is prescribed for one side of the boundary.
struct SidePrescription
{
  int side = 0;  ///< Index in BoundarySides::names.
  int count = 0; ///< Number of edges; 0: not prescribed.
  bool isGraded = false;
  Progression progression; ///< Used if isGraded.
  /// Length of all edges, met within SizeTolerance; 0: not prescribed.
  double size = 0.0;
  double inside = 0.0; ///< Target size of quads in what the side encloses; 0: not prescribed.
};

using SidePrescriptions = std::vector<SidePrescription>;

/// Largest relative error of the edges of a side of prescribed size.
constexpr double SizeTolerance = 0.2;

/// Returns the arc lengths of `count` + 1 points that divide a length in a progression of edges.
std::vector<double> DivideLength(double length, int count, const Progression& progression);

/// Returns the number of edges, not rounded, in the first `part` of a length that is divided into
/// `count` edges.
double EdgesWithin(double part, double length, double count, const Progression& progression);

/// Returns the number of edges for which the first and the last one have prescribed lengths.
int CountForLengths(double length, const Progression& progression);
}
