#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Part of a loop that a sliding boundary edge must not reach, 150° of a round hole: the chord of half
/// a loop crosses the hole. Four edges, the fewest of a loop, need less.
constexpr double LongestPartOfLoop = 5.0 / 12.0;
/// The same at the start of smoothing: well below it, because the energy of QuadEnergy is infinite
/// there.
constexpr double LongestPartAtStart = 0.9 * LongestPartOfLoop;

/// Returns the length from one position to the next along a loop of length `loop`, between −0.2 and
/// 0.8 of it: few edges may share a loop, and positions may be in the wrong order, but not by much.
double LengthAlong(const CurvePlace& from, const CurvePlace& to, double loop);

/// Moves points of the boundary apart that are in the wrong order, which can happen where arcs of
/// the T-mesh have no edge, or whose edges are shorter than the part `shortest` of their ideal
/// length, or, with shortest > 0, longer than LongestPartAtStart. Ideal lengths are in proportion to
/// target lengths between two fixed points, or equal where those would be too long. Positions are
/// the mean of those given and of ideal ones, with as little of the latter as it takes. Other points
/// do not move.
void OrderOnBoundary(QuadMesh& mesh, const BoundaryCurves& curves, double shortest = 0.0);

/// Returns whether an edge of the boundary is longer than a part of its loop.
bool HasLongEdges(const QuadMesh& mesh, const BoundaryCurves& curves, double part);
}
