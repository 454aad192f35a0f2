#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Distance of a point to the boundary, negative outside the domain.
double SignedDistance(const Point& point, const PlanarDomain& domain);

/// How far one can go from a point of the boundary into the domain, in a unit direction, before
/// meeting the boundary again; 0 when that never happens.
double ClearWay(const PlanarDomain& domain, const Point& from, const Point& direction);

/// Throws Error that names the first singularity outside the domain, by more than 1e-6 of its diagonal, or
/// with a coordinate that is not finite.
void RequireInside(const PlanarDomain& domain, const Configuration& configuration);
}
