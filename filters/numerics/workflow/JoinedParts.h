#pragma once

#include "PartRequests.h"
#include "Progress.h"

namespace crossfield
{
/// Makes the quads of each part as MakeQuadMesh does and joins them: points, quads, blocks, loops
/// and curves have numbers that continue from part to part, and sentences begin with the number of
/// their part, from 1. The result of one part is that of MakeQuadMesh. Throws Error as MakeQuadMesh
/// does, with the number of the part, and as SplitRequest does.
QuadWorkflowResult MakeQuadsOfParts(
  const std::vector<DomainPart>& parts, const QuadRequest& request, const Progress& progress = {});
}
