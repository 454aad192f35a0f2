#pragma once

#include "QuadRequest.h"

namespace crossfield
{
/// Runs the steps of MakeQuadMesh once, without trying remedies, for a request of WithSideSizes; throws
/// Error as it does.
QuadWorkflowResult RunQuadSteps(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress);
}
