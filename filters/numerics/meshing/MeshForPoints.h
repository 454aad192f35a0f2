#pragma once

#include "PlanarDomain.h"
#include "Progress.h"
#include "Singularity.h"
#include "TriangleMesh.h"

#include <vector>

namespace crossfield
{
/// Triangulates a domain without holes for SolveHField: four times finer at the singularities, and
/// fine enough to separate them from each other and from the boundary. Narrow parts of the domain
/// are at least two edges wide (NarrowParts.h). `meshSize` 0 means 1/40 of the diagonal.
TriangleMesh MeshForPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize = 0.0, const Progress& progress = {});

/// Triangulates a domain for several configurations. The mesh is fine enough for each of them; for
/// a single one it equals that of MeshForPoints.
TriangleMesh MeshForConfigurations(const PlanarDomain& domain,
  const std::vector<Configuration>& configurations, double meshSize = 0.0,
  const Progress& progress = {});

/// Works as MeshForPoints with a vertex at each singularity, as SolveSeamlessMap requires.
/// `refinement` divides all edge lengths. If reflections are among the symmetries of the domain
/// with the singularities, the mesh has these symmetries (DrillOptions::symmetries). Without such
/// symmetries it has all vertices of the domain; with them, vertices on straight sides may be missing,
/// but for those of `kept`.
TriangleMesh MeshThroughPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize = 0.0, const Progress& progress = {}, double refinement = 1.0,
  const std::vector<Point>& kept = {});
}
