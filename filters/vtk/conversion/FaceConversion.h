#ifndef FaceConversion_h
#define FaceConversion_h

#include "MapConversion.h"
#include "TMesh.h"

class vtkPolyData;

/** Conversion of the faces of a T-mesh. */
namespace FaceConversion
{
/** Triangles for each face, and its outline; see vtkSeparatrices. */
void WriteFaces(
  const MapConversion::Map& traced, const crossfield::TMesh& mesh, vtkPolyData* output);
}

#endif
