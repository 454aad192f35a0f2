#pragma once

#include "JoinedParts.h"
#include "SurfaceRequest.h"

namespace crossfield
{
/// Makes the quads of a connected part of a surface (docs/method.md §22.11, §22.12): singularities, map and T-mesh of
/// each face, edge counts of all faces together. Faces that cannot be laid out are joined to others, which changes the
/// features of the part, if they are smaller than a few quads or `joinsAll` is set. `count` is the number of
/// quads if request.quadSize is 0. Throws Error as MakeQuadsOfSurface does, of kind CoarseMesh if smaller triangles may help.
PartOfQuads MakeQuadsOfBody(FeaturedPart& part, const SurfaceRequest& request, int count,
  bool joinsAll, const Progress& progress);
}
