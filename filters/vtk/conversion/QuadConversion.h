#ifndef QuadConversion_h
#define QuadConversion_h

#include "DomainPlane.h"
#include "QuadMesher.h"

class vtkMultiBlockDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/** Conversion of quad meshes; see vtkQuadMesher for the arrays. */
namespace QuadConversion
{
/** Quads, boundary lines, and the report in field data. */
void WriteQuads(const crossfield::QuadResult& result, const crossfield::DomainPlane& plane,
  vtkUnstructuredGrid* output);

/** A vtkStructuredGrid per block. */
void WriteBlocks(const crossfield::QuadResult& result, const crossfield::DomainPlane& plane,
  vtkMultiBlockDataSet* output);

/** A polyline per arc of the T-mesh. */
void WriteLayout(
  const crossfield::QuadResult& result, const crossfield::DomainPlane& plane, vtkPolyData* output);
}

#endif
