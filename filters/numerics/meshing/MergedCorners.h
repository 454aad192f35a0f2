#pragma once

#include "LoopArc.h"

#include <utility>

namespace crossfield
{
/// Of one loop, what it is made of and what its sides may be.
struct Thinning
{
  double length = 0.0;
  double turn = 0.0;     ///< That a side may stand for.
  double rounding = 0.0; ///< Lengths that differ by less are equal.
};

/// What stays of a loop: places along it, and the runs of corners that one of them takes in, with what goes beside
/// them.
struct KeptPlaces
{
  std::vector<double> places;
  std::vector<std::pair<double, double>>
    merged; ///< Begin, which may be negative, and end; in order.
};

/// The corners of a loop, those within a length of each other as one, and given places.
KeptPlaces FindKeptPlaces(const LoopArc& arc, const std::vector<double>& turns, double cornerAngle,
  const std::vector<double>& given, const Thinning& thinning);
}
