#pragma once

#include "PairedSides.h"
#include "PlaneCurve.h"

#include <array>
#include <vector>

namespace crossfield
{
/// A boundary edge of StraightQuads, with the domain on its left.
struct StraightEdge
{
  std::array<int, 2> points{};
  int curve = -1; ///< Index in StraightQuads::curves, −1 if it is straight.
  int side = -1;  ///< Number of its side, used for periodic sides.
};

/// Quads with straight edges and the curves of their boundary.
struct StraightQuads
{
  std::vector<Point> points;
  std::vector<std::array<int, 4>> quads; ///< Counter-clockwise.
  std::vector<StraightEdge> edges;
  std::vector<PlaneCurve> curves;
  std::vector<PairedSides> periodic; ///< Sides whose nodes match.
};
}
