#pragma once

#include "Plane.h"

namespace crossfield
{
/// Returns a regular hexagon centred at the origin with circumradius `radius` and a corner on the
/// positive x axis.
std::vector<Loop> HexagonalDomain(double radius);

/// Returns a five-pointed star centred at the origin, one tip pointing up. The tips are at distance
/// `radius`, the corners between them at `innerRadius`.
std::vector<Loop> StarDomain(double radius, double innerRadius);

/// The angular domains of the paper (section "Generalized Poincaré-Hopf theorem"), drawn from its
/// text. Each comment ends with the total of interior quarter indices that follows from the
/// smallest rotations at the corners. Widths are along x, and all domains are symmetric about the x
/// axis.
///@{
/// Returns a hexagon with two angles of 145° on the left and four of 107.5°: total 0.
std::vector<Loop> AngularBalancedDomain(double width);
/// Returns a hexagon with angles of 100° at its two tips and four of 130°: total −2, two
/// singularities of index −1/4.
std::vector<Loop> AngularNegativeDomain(double width);
/// Returns a hexagon with angles of 80° at its two tips and four of 140°: total 2, two
/// singularities of index +1/4.
std::vector<Loop> AngularPositiveDomain(double width);
/// Returns AngularPositiveDomain with a round hole of radius width / 10 at its centre, in segments
/// no longer than `edgeLength`: total −2.
std::vector<Loop> AngularHoleDomain(double width, double edgeLength);
///@}
}
