#ifndef SolverMeshWriting_h
#define SolverMeshWriting_h

#include "SolverMesh.h"

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

/** Conversion of a SolverMesh to data of VTK. */
namespace SolverMeshWriting
{
/**
 * Writes a mesh of RaiseOrder or SweepQuads with the arrays of the grid that its sources are in; see
 * vtkQuadsToHigherOrder and vtkExtrudeQuads. Quads and lines have the order of that grid; hexahedra come before
 * the faces of their boundary.
 */
void WriteMesh(
  const crossfield::SolverMesh& mesh, vtkUnstructuredGrid* from, vtkUnstructuredGrid* output);

/** Writes the blocks of a mesh as structured grids with `BlockId` on the cells. */
void WriteBlocks(const crossfield::SolverMesh& mesh, vtkMultiBlockDataSet* output);
}

#endif
