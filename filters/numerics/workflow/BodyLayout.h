#pragma once

#include "Error.h"
#include "FaceJoin.h"
#include "QuadRequest.h"

namespace crossfield
{
/// Computes the layout of a face from its singularities, and adds the seconds that it took. Throws Error as
/// SolveSurfaceMap, TraceSeparatrices and MakeTMesh do, of kind Inconsistent if the quarter indices do not add up.
Layout LayOutFace(const ConedSurface& face, QuadSeconds& seconds, const Progress& progress = {});

/// Returns an error of a face of a body, with its place if the body has several.
Error InFace(const SurfaceBody& body, const ConedSurface& face, const Error& error);

/// Throws Error if quads do not have the Euler characteristic of a body.
void RequireCover(const SurfaceBody& body, const QuadMesh& mesh);

/// Returns the layouts of all faces of a body as one.
LayoutSet JoinBody(const SurfaceBody& body, const SurfaceNames& names, std::vector<Layout> layouts);
}
