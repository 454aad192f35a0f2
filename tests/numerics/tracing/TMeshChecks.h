#pragma once

#include "TMeshPatches.h"

#include "SeamlessMapSolve.h"
#include "Support.h"

namespace crossfield::test
{
/// The T-mesh of a domain, meshed with a vertex on every singularity.
TMesh LinesOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize,
  const SeamlessMapOptions& options = {});

/// That on a mesh.
TMesh LinesOn(const TriangleMesh& mesh, const Configuration& configuration);

/// Area of all faces.
double MapArea(const TMesh& mesh);

/// The counts of docs/method.md §13.3; opposite sides are equal; the faces fill the map and the domain.
void ExpectSound(const TMesh& mesh, int euler);

inline int Count(std::size_t size)
{
  return static_cast<int>(size);
}
}
