#ifndef MapConversion_h
#define MapConversion_h

#include "DomainPlane.h"
#include "SeamlessMap.h"

class vtkUnstructuredGrid;

/** Conversion of seamless maps. Every function throws crossfield::Error. */
namespace MapConversion
{
/** Map and the plane of its domain in space. */
struct Map
{
  crossfield::SeamlessMap map;
  crossfield::DomainPlane plane;
};

/** Writes the mesh cut along the seams, with the arrays of vtkCrossFieldMap. */
void WriteMap(const Map& written, vtkUnstructuredGrid* output);

/** Reads the output of WriteMap. */
Map ReadMap(vtkUnstructuredGrid* input);
}

#endif
