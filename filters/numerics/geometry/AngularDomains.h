#pragma once

#include "Plane.h"

namespace crossfield
{
/// Regular hexagon around the origin with its corners at this distance, the first on the x axis.
std::vector<Loop> HexagonalDomain(double radius);

/// Five-pointed star around the origin, one tip upwards: tips at the radius, the corners between
/// them at the inner radius.
std::vector<Loop> StarDomain(double radius, double innerRadius);

/// The angular domains of the paper (section "Generalized Poincaré-Hopf theorem"), drawn from its
/// text, each with the total of interior quarter indices that the smallest rotations ask for.
/// Widths are along x, and all are symmetric about the x axis.
///@{
/// Six sides with two angles of 145° at the left and four of 107.5°: 0.
std::vector<Loop> AngularBalancedDomain(double width);
/// Hexagon with angles of 100° at its two tips and four of 130°: −2, which is two −1/4.
std::vector<Loop> AngularNegativeDomain(double width);
/// Hexagon with angles of 80° at its two tips and four of 140°: 2, which is two +1/4.
std::vector<Loop> AngularPositiveDomain(double width);
/// AngularPositiveDomain with a round hole of radius width / 10 at its centre, in segments of at
/// most the edge length: −2.
std::vector<Loop> AngularHoleDomain(double width, double edgeLength);
///@}
}
