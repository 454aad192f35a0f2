#pragma once

#include "QuadRequest.h"

namespace crossfield
{
/// Runs the steps of MakeQuadMesh (RunQuadSteps). If singularities are chosen and layers or sizes of
/// sides are requested, it first tries none where the domain needs none. With layers it runs the
/// steps again, with more and more distance between singularities and layered sides, until the bands
/// are free of irregular nodes (docs/method.md §16.5).
QuadWorkflowResult RunWithLayers(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress);
}
