#pragma once

#include "PlanarDomain.h"
#include "PlaneCurve.h"

namespace crossfield
{
/// Consecutive segments of a loop on one circle.
struct RecognisedArc
{
  std::size_t first = 0; ///< Vertex where it starts.
  std::size_t count = 0; ///< Number of segments; all of them if the loop is a circle.
  PlaneCurve circle;
};

/// Finds the arcs of circles that parts of a loop sample (docs/method.md §17.3). An arc has at least
/// five points, which are within 1e-7 of the diagonal of the loop and within 0.01 of the smallest sagitta of its
/// segments from the circle, and turns by at least 30°. Segments are longest first from where the loop
/// is not on a circle, and no segment belongs to two arcs. Vertices that turn by more than
/// `cornerAngle` are not inside an arc.
std::vector<RecognisedArc> FindArcs(const Loop& loop, double cornerAngle = DefaultCornerAngle);
}
