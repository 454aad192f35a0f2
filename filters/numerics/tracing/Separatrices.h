#pragma once

#include "LineWalk.h"

#include <array>

namespace crossfield
{
/// Separatrices nearer than this, relative to the extent, are on one isoline. Levels are exact, but
/// two that are equal by the symmetry of the domain, and not by an equation, differ by the rounding
/// error of the solve: 1e-14 to 3e-12 were measured.
constexpr double SameIsoline = 1e-11;

/// Reason why a separatrix ends.
enum class SeparatrixEnd
{
  None,     ///< It has not been stopped.
  Line,     ///< It meets another separatrix from the side.
  Boundary, ///< It meets the boundary.
  HeadOn    ///< It meets another one head-on, on the same isoline: the two form one path.
};

/// A separatrix: a straight line in the seamless map from a cone, or from a boundary loop, to where
/// it is stopped.
struct TracedSeparatrix
{
  int cone = -1; ///< Cone where it starts; −1 for extra ones, which start on the boundary.
  int slot = 0;  ///< Direction at the cone, counter-clockwise from 0.
  int startPosition = -1; ///< Entry of mesh.boundary where an extra one starts.
  double delay = 0.0;     ///< Delay of its start, as a length.
  double length = 0.0;    ///< Length in the map.
  SeparatrixEnd end = SeparatrixEnd::None;
  int other = -1;            ///< Separatrix at its end.
  double otherLength = 0.0;  ///< Length along that one to the common point.
  double headOnLength = 0.0; ///< Length of both together where two meet head-on.
  int endPosition = -1;      ///< Entry of mesh.boundary where it ends.
  int lastSegment = 0;       ///< Segment in which it ends.
  int endDirection = 0;      ///< Its direction in the chart of that segment's triangle.
  int otherDirection = 0;    ///< Direction of the other separatrix there.
  std::vector<LineSegment> segments;
};

/// A point at which two separatrices arrive at the same time, as the images of each other under a
/// reflection of the domain do on its axis. Both continue, so that the T-mesh has the symmetry.
struct SeparatrixTie
{
  std::array<int, 2> lines{};
  std::array<double, 2> lengths{}; ///< Along each of the two.
  std::array<int, 2> segments{};   ///< In which they meet, in the same triangle.
};

/// All separatrices of a map, each up to the first separatrix or boundary side that it meets
/// (docs/method.md §13).
struct TraceGraph
{
  std::vector<TracedSeparatrix> separatrices;
  int extraSeparatrices =
    0;            ///< Number of extra ones, at the end: for boundary loops that no other meets.
  int headOn = 0; ///< Pairs that meet head-on.
  std::vector<SeparatrixTie> ties;
};
}
