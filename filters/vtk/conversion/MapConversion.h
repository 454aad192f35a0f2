#ifndef MapConversion_h
#define MapConversion_h

#include "DomainPlane.h"
#include "SeamlessMap.h"

class vtkUnstructuredGrid;

/** Conversion of flat maps; every function throws crossfield::Error. */
namespace MapConversion
{
/** A map, and the plane in space that its domain lies in. */
struct Map
{
  crossfield::SeamlessMap map;
  crossfield::DomainPlane plane;
};

/** The mesh cut along the seams, with the arrays of vtkCrossFieldMap. */
void WriteMap(const Map& written, vtkUnstructuredGrid* output);

/** What WriteMap has written. */
Map ReadMap(vtkUnstructuredGrid* input);
}

#endif
