#ifndef SolverMeshReading_h
#define SolverMeshReading_h

#include "SolverMesh.h"

#include <map>
#include <string>

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
 * `BlockId`, `I`, `J` and `K`, without them none; pairs those of PeriodicConversion::Read; patches of sides with a
 * boundary layer (field data `LayerSide`) are walls. Sources are the points and
 * cells of the grid. Throws crossfield::Error if there are no cells or no faces, other cells, several orders, no
 * sides, or a point that is not finite, and as PeriodicConversion::Read does.
 */
crossfield::SolverMesh Read(vtkUnstructuredGrid* grid);

/**
 * Sets types of patches by names of sides. Throws crossfield::Error if there is no such side, its patch is
 * periodic or the end of one layer, or the type is none that a side alone can have.
 */
void SetPatchTypes(const std::map<std::string, std::string>& types, crossfield::SolverMesh& mesh);

/** Reads the curves of the boundary. Throws crossfield::Error as CurveConversion::ReadCurves does. */
void ReadCurves(vtkUnstructuredGrid* grid, crossfield::SolverMesh& mesh);
}

#endif
