#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Returns the radius at which the hole of a singularity touches the boundary or a neighbouring
/// hole of the same radius: the minimum of its distance to the boundary, negative outside the
/// domain, and half of its distance to the nearest other singularity.
double LargestHoleRadius(
  const PlanarDomain& domain, const Configuration& configuration, std::size_t row);

/// Returns the default radius of a hole: at most the mesh size, and at most a third of the distance
/// to the boundary or to the nearest other singularity, so that triangles fit in between
/// (docs/method.md §5.5). Outside the domain or on its boundary it is the mesh size; DrillHoles
/// then reports the singularity by its name.
double DefaultRadius(
  const PlanarDomain& domain, const Configuration& configuration, std::size_t row, double meshSize);

/// Returns the configuration with default radii where none is given.
Configuration WithDefaultRadii(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize);
}
