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
/** Writes quads with their points, output 0 of vtkQuadMesher. */
void WriteQuads(const crossfield::QuadResult& result, const crossfield::DomainPlane& plane,
  vtkUnstructuredGrid* output);

/** Writes the boundary edges with the domain on their left, and their curves. */
void WriteBoundary(const crossfield::QuadMesh& mesh, const crossfield::CurvedBoundary& curves,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Writes quads and their boundary edges into one grid; see vtkQuadMesher::CopyMesh. */
void Combine(vtkUnstructuredGrid* quads, vtkPolyData* boundary, vtkUnstructuredGrid* output);

/** Writes one vtkStructuredGrid per block. */
void WriteBlocks(const crossfield::QuadResult& result, const crossfield::DomainPlane& plane,
  vtkMultiBlockDataSet* output);

/** Adds the part of the domain to the cells of quads and blocks. */
void WriteParts(const crossfield::QuadWorkflowResult& result, vtkUnstructuredGrid* quads,
  vtkMultiBlockDataSet* blocks);

/** Writes one polyline per side of a block; a side that two blocks share is written once. */
void WriteLayout(
  const crossfield::QuadResult& result, const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Writes one polyline per arc of the T-mesh. */
void WriteSeparatrices(
  const crossfield::QuadResult& result, const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Writes the interior points whose valence is not 4. */
void WriteIrregularNodes(
  const crossfield::QuadMesh& mesh, const crossfield::DomainPlane& plane, vtkPolyData* output);
}

#endif
