#pragma once

#include "BoundaryPieces.h"

namespace crossfield
{
/// How finely curves are sampled.
struct SamplingLimits
{
  double longest = 0.0; ///< No segment is longer.
  double shortest =
    0.0; ///< Segments are not divided below this length, unless they turn like corners.
};

/// A domain whose polylines sample its curves.
struct SampledDomain
{
  PlanarDomain domain;
  BoundarySides sides; ///< With the positions of the new vertices.
  CurvedBoundary boundary;
  std::vector<Point> kept; ///< The new positions of the points to keep.
};

/// Samples the curves of a domain more finely where its polylines are coarse (docs/method.md §17.4):
/// vertices inside curves move onto them, and segments are divided into equal parts of the parameter
/// until they are short enough and turn by at most 5°. Corners, ends of curves and segments without a
/// curve do not change. Points of `kept` on the boundary become vertices of the curve.
///
/// Throws Error if the vertices are not in order along a curve, or as MakePlanarDomain does.
SampledDomain SampleCurves(const PlanarDomain& domain, const BoundarySides& sides,
  const CurvesOfSegments& curves, const SamplingLimits& limits, const std::vector<Point>& kept);
}
