#ifndef SolverMeshReading_h
#define SolverMeshReading_h

#include "SolverMesh.h"

class vtkPolyData;
class vtkUnstructuredGrid;

/** Conversion of quads or hexahedra with their boundary to a SolverMesh. */
namespace SolverMeshReading
{
/**
 * Joins the outputs of vtkQuadMesher for quads and boundary, with its curves, to one grid; without
 * boundary, or if it is empty, `grid` is the first input. Throws crossfield::Error if the boundary has not
 * the arrays of that output, or InputCheck::Require refuses an input.
 */
void Join(vtkUnstructuredGrid* quads, vtkPolyData* boundary, vtkUnstructuredGrid* grid);

/**
 * Reads quads and lines of one order: those of vtkQuadMesher::CopyMesh and vtkQuadsToHigherOrder; or
 * hexahedra, prisms and the quads and triangles of their boundary: those of vtkExtrudeQuads. Faces have their
 * side in the string array `Side`; all cells are one region with the name domain. Blocks are those of the arrays
 * `BlockId`, `I`, `J` and `K`, without them none; pairs those of PeriodicConversion::Read. Sources are the points and
 * cells of the grid. Throws crossfield::Error if there are no cells or no faces, other cells, several orders, no
 * sides, or a point that is not finite, and as PeriodicConversion::Read does.
 */
crossfield::SolverMesh Read(vtkUnstructuredGrid* grid);

/** Reads the curves of the boundary. Throws crossfield::Error as CurveConversion::ReadCurves does. */
void ReadCurves(vtkUnstructuredGrid* grid, crossfield::SolverMesh& mesh);
}

#endif
