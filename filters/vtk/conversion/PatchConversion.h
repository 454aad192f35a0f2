#ifndef PatchConversion_h
#define PatchConversion_h

#include "MapConversion.h"
#include "TMesh.h"

namespace crossfield
{
struct QuadMesh;
}
class vtkPolyData;

/** Conversion of the patches of a T-mesh. */
namespace PatchConversion
{
/** Writes the triangles and the outline of each patch; see vtkSeparatrices. */
void WritePatches(
  const MapConversion::Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output);

/**
 * Writes the quads of each patch as polygons with the cell array `FaceId`, whose edges are those of the quads: on a
 * surface other triangles would cover these.
 */
void WriteQuadsOfPatches(const crossfield::QuadMesh& quads, vtkPolyData* output);
}

#endif
