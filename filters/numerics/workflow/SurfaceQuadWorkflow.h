#pragma once

#include "SurfaceRequest.h"

namespace crossfield
{
/// Makes quads of a surface in space with the given singularities, each in the nearest face, or with chosen ones
/// (docs/method.md §22.6, §22.11, §22.12). Parts share the number of quads by their areas. Of the result, what
/// concerns positions in a plane is empty; singularities are the irregular nodes. With names of regions, `regions`
/// has one entry for each face.
/// Lines between two regions may be called `A+B` or `B+A`.
/// Chosen singularities of a part of one face are also moved (MovedCones); the better mesh of the two is returned.
///
/// Where a part needs smaller triangles, its own are divided (TriangleDivision).
///
/// Throws Error as PlaceCones, ChooseSurfaceCones, SolveSurfaceMap and MakeSurfaceQuads do, and if the quarter
/// indices of a part do not add up to 4χ.
QuadWorkflowResult MakeQuadsOfSurface(
  const SurfaceMesh& surface, const SurfaceRequest& given, const Progress& progress = {});
}
