#pragma once

#include "Drawing.h"

#include <vector>

namespace crossfield
{
/// How finely curves become polylines.
struct SamplingRule
{
  /// Maximum turn along a segment in radians. At 5° the corners of the polyline are far below the
  /// default angle of corners, 30°.
  double turn = Pi / 36.0;
  /// Maximum distance between curve and segment. DrawingOutline uses 1e-4 of the extent, a fifth of
  /// the detail that is removed for a mesh of the default size.
  double distance = 0.0;
  /// Length below which a part of a curve is one segment, whatever it turns; a cusp has no tangent.
  double shortest = 0.0;
};

/// Returns the parameters of the points that replace a piece, from its `begin` to its `end`: both
/// ends, the ends of its smooth parts (SmoothParts), and points between them so that each segment
/// satisfies the rule. Arcs of circles are divided evenly, a full circle into a multiple of 8; other
/// curves are bisected. Throws Error if there are more than a million points.
std::vector<double> SampleParameters(const DrawingPiece& piece, const SamplingRule& rule);

/// Returns the length of a piece, to about a percent.
double ApproximateLength(const DrawingPiece& piece);
}
