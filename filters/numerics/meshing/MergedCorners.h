#pragma once

#include "LoopArc.h"

#include <utility>

namespace crossfield
{
/// Limits for thinning one loop.
struct Thinning
{
  double length = 0.0;
  double turn = 0.0;     ///< Maximum turning angle of the vertices that one side replaces.
  double rounding = 0.0; ///< Lengths that differ by less are equal.
};

/// Points of a loop that are retained, and the runs of corners and neighbouring vertices that are
/// merged into one of them.
struct KeptPlaces
{
  std::vector<double> places;
  std::vector<std::pair<double, double>>
    merged; ///< Begin, which may be negative, and end of each run, in order.
};

/// Returns the given points and the corners of a loop, with corners within a length of each other
/// merged into one.
KeptPlaces FindKeptPlaces(const LoopArc& arc, const std::vector<double>& turns, double cornerAngle,
  const std::vector<double>& given, const Thinning& thinning);
}
