#ifndef QuadConversion_h
#define QuadConversion_h

#include "DomainPlane.h"
#include "QuadWorkflow.h"

class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/** Conversion of quad meshes; see vtkQuadMesher for the arrays. */
namespace QuadConversion
{
/** Writes quads, boundary lines, and the report as field data. */
void WriteQuads(const crossfield::QuadResult& result, const crossfield::DomainPlane& plane,
  vtkUnstructuredGrid* output);

/** Writes the numbers of blocks that were computed. */
void WriteBlockCounts(const crossfield::BlockCounts& counts, vtkFieldData* data);

/** Writes one vtkStructuredGrid per block. */
void WriteBlocks(const crossfield::QuadResult& result, const crossfield::DomainPlane& plane,
  vtkMultiBlockDataSet* output);

/** Writes one polyline per arc of the T-mesh. */
void WriteLayout(
  const crossfield::QuadResult& result, const crossfield::DomainPlane& plane, vtkPolyData* output);
}

#endif
