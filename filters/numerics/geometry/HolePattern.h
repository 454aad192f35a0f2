#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

#include <optional>

namespace crossfield
{
struct Circle
{
  Point centre = Point::Zero();
  double radius = 0.0;
};

/// Returns the circle on which the vertices of a loop are, to 1 % of the radius. A loop with fewer
/// than 12 vertices is a polygon.
std::optional<Circle> CircleOf(const Loop& loop);

/// A boundary loop that is a circle.
struct RoundHole : Circle
{
  std::size_t loop = 0; ///< Loop of the domain.
  double gap = 0.0;     ///< Distance to the other loops.
};

/// Returns the inner loops that are circles.
std::vector<RoundHole> FindRoundHoles(const PlanarDomain& domain);

std::vector<Point> Centres(const std::vector<RoundHole>& holes);

/// Returns the domain with holes filled.
PlanarDomain FillHoles(const PlanarDomain& domain, const std::vector<RoundHole>& holes);

/// Returns four singularities of quarter index −1 around every hole (docs/method.md §14.10), in the
/// directions between those of the cross at its centre, at 1.41 radii from it but no farther from
/// the hole than 0.4 of the gap. `crossAngles`: for each hole the angle of a direction of the cross
/// at its centre in the filled domain.
Configuration PatternAroundHoles(
  const std::vector<RoundHole>& holes, const std::vector<double>& crossAngles);
}
