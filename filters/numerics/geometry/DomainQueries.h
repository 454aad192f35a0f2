#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Returns the distance of a point to the boundary, negative outside the domain.
double SignedDistance(const Point& point, const PlanarDomain& domain);

/// Returns the contribution of a segment to the winding number around a point: 1 if it crosses the
/// ray to the right of the point upwards, −1 if downwards, otherwise 0.
int RayCrossing(const Point& point, const Point& from, const Point& to);

/// Returns the length of the ray that starts at a boundary point in a unit direction and ends where
/// it first meets the boundary again; 0 if it never does.
double DistanceAlongRay(const PlanarDomain& domain, const Point& from, const Point& direction);

/// Throws Error, naming the singularity, if a singularity is outside the domain by more than 1e-6
/// of its diagonal or has a coordinate that is not finite.
void RequireInside(const PlanarDomain& domain, const Configuration& configuration);
}
