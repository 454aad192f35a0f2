#pragma once

#include "QuadRequest.h"

namespace crossfield
{
/// Runs the steps of MakeQuadMesh (RunQuadSteps), and if layers are requested and singularities are
/// chosen, runs them again until the bands of the layers are free of irregular nodes (docs/method.md
/// §16.5): first without singularities where the domain needs none, then with more and more
/// distance between singularities and layered sides.
QuadWorkflowResult RunWithLayers(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress);
}
