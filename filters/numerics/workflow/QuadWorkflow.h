#pragma once

#include "QuadRequest.h"

namespace crossfield
{
/// Makes the quad mesh of a domain (docs/method.md §14): chooses singularities unless they are
/// given, caps corners, repairs the holonomy, meshes, solves for the map, traces separatrices, makes
/// quads and merges blocks. Curves of the boundary are sampled first (CurveSteps.h), and boundary
/// nodes are on them. What fails is tried in other ways (QuadAttempts.h), and remedies that an error or
/// a warning offers have been tried (QuadAdvice.h).
///
/// Throws Error if there would be more quads than can be numbered, and as ChooseSingularities,
/// RepairForMap, MeshThroughPoints, SolveSeamlessMap, TraceSeparatrices, MakeTMesh and MakeQuads do.
QuadWorkflowResult MakeQuadMesh(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress = {});
}
