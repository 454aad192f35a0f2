#pragma once

#include "BoundaryCorners.h"
#include "EdgeNumbering.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
/// The domain with a vertex wherever a singularity lies on its boundary, within 1e-6 of the diagonal.
PlanarDomain InsertBoundarySingularities(
  const PlanarDomain& domain, const Configuration& configuration);

/// Triangulates a domain without holes for SolveHField: four times finer at the singularities, and
/// fine enough to tell them from each other and from the boundary. `meshSize` 0: 1/40 of the diagonal.
TriangleMesh MeshForPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize = 0.0, const Progress& progress = {});

/// What SolveHField makes of a configuration.
struct PlacedConfiguration
{
  Configuration interior;
  std::vector<std::size_t> rows; ///< Of the interior ones in the configuration.
  std::vector<CornerChoice>
    corners; ///< Given ones, then those of the cheapest assignment, if used.
};

/// Tells singularities at vertices of outer and inner loops, within 1e-6 of the diagonal, from those
/// inside, and completes the corners; see SolveHField.
PlacedConfiguration PlaceConfiguration(const TriangleMesh& mesh,
  const std::vector<BoundaryLoop>& loops, const Configuration& configuration,
  const std::vector<CornerChoice>& corners);
}
