#pragma once

#include "TMeshPatches.h"

#include "SeamlessMapSolve.h"
#include "Support.h"

namespace crossfield::test
{
/// Returns the T-mesh of a domain, meshed with a vertex at every singularity.
TMesh LinesOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize,
  const SeamlessMapOptions& options = {});

/// Returns the T-mesh on a mesh.
TMesh LinesOn(const TriangleMesh& mesh, const Configuration& configuration);

/// Returns the area of all patches in the map.
double MapArea(const TMesh& mesh);

/// Checks the counts of docs/method.md §13.3, that opposite sides have equal lengths, and that the
/// patches fill the map and the domain.
void ExpectSound(const TMesh& mesh, int euler);

inline int Count(std::size_t size)
{
  return static_cast<int>(size);
}
}
