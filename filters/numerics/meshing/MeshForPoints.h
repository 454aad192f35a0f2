#pragma once

#include "PlanarDomain.h"
#include "Progress.h"
#include "Singularity.h"
#include "TriangleMesh.h"

#include <vector>

namespace crossfield
{
/// Triangulates a domain without holes for SolveHField: four times finer at the singularities, and
/// fine enough to tell them from each other and from the boundary. `meshSize` 0: 1/40 of the diagonal.
TriangleMesh MeshForPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize = 0.0, const Progress& progress = {});

/// One mesh that serves each of several configurations as well as its own; that of a single one is the same.
TriangleMesh MeshForAll(const PlanarDomain& domain,
  const std::vector<Configuration>& configurations, double meshSize = 0.0,
  const Progress& progress = {});

/// MeshForPoints with a vertex on every singularity, as SolveSeamlessMap needs it.
TriangleMesh MeshOnPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize = 0.0, const Progress& progress = {});
}
