#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Half the room around a singularity: the least of its distance to the boundary, negative outside, and
/// half of that to the next singularity. Holes of this radius would touch.
double RoomOf(const PlanarDomain& domain, const Configuration& configuration, std::size_t row);

/// The radius of a hole where none is given: at most the mesh size, at most a third of the distance to
/// the boundary or to the next singularity, so that triangles fit in between (docs/method.md §5.5). Outside the
/// domain or on its boundary the mesh size, which drilling refuses by its name.
double ChosenRadius(
  const PlanarDomain& domain, const Configuration& configuration, std::size_t row, double meshSize);

/// The configuration with a radius wherever it has none; given ones are kept.
Configuration WithChosenRadii(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize);
}
