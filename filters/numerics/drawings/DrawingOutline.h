#pragma once

#include "Drawing.h"

#include <string>
#include <vector>

namespace crossfield
{
/// The segment of a loop after a vertex.
struct OutlineSegment
{
  int curve = -1;   ///< Index in DrawingOutline::curves; −1 if the curve is not known.
  std::string name; ///< Name of the side; empty if it has none.
};

/// One closed polyline.
struct OutlineLoop
{
  Loop points;
  std::vector<OutlineSegment> segments; ///< One for each point.
};

/// Boundary loops of a drawing, with the curves that they sample.
struct DrawingOutline
{
  std::vector<OutlineLoop> loops;
  std::vector<PlaneCurve> curves; ///< All straight lines share one.
  double largestGap = 0.0;        ///< Maximum distance between ends that were joined.
  std::vector<std::string> warnings;
};

/// Chains the pieces of a drawing into closed curves (PieceChains.h) and samples them
/// (PieceSampling.h). Where ends were not exactly at the same point, the vertex is an end of a curve
/// rather than of a line; a curve whose other end is off by more than 5e-7 of the extent is then
/// not recorded, because vertices of a curve have to lie on it within 1e-6.
///
/// `tolerance` is the distance within which ends are joined, 0 for DefaultJoinTolerance; `turn` is
/// SamplingRule::turn. Throws Error if the drawing has no pieces or ChainPieces does.
DrawingOutline TraceOutline(const Drawing& drawing, double tolerance, double turn);
}
