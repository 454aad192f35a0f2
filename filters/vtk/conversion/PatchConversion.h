#ifndef PatchConversion_h
#define PatchConversion_h

#include "MapConversion.h"
#include "TMesh.h"

class vtkPolyData;

/** Conversion of the patches of a T-mesh. */
namespace PatchConversion
{
/** Writes the triangles and the outline of each patch; see vtkSeparatrices. */
void WritePatches(
  const MapConversion::Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output);
}

#endif
