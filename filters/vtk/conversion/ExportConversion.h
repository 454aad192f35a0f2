#ifndef ExportConversion_h
#define ExportConversion_h

#include "ExportMesh.h"
#include "SweepQuads.h"

#include "vtkType.h"

#include <vector>

class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

/** Conversion of quads or hexahedra with their boundary to the mesh that files are written from, and back. */
namespace ExportConversion
{
/** A mesh and where it was read from. */
struct Cells
{
  crossfield::ExportMesh mesh;
  std::vector<vtkIdType> cells; ///< Per cell of the mesh, the cell of the data set.
  std::vector<vtkIdType> faces; ///< Per boundary face, the cell of the data set.
};

/**
 * Reads quads and lines of one order: those of vtkQuadMesher::CopyMesh and vtkQuadsToHigherOrder; or
 * hexahedra, prisms and the quads and triangles of their boundary: those of vtkExtrudeQuads. Faces have their
 * side in the string array `Side`; all cells are one region with the name domain. Blocks are those of the arrays
 * `BlockId`, `I`, `J` and `K`, without them none. Throws crossfield::Error if there are no cells or no
 * faces, other cells, several orders, no sides, or a point that is not finite. Periodic sides are
 * read as PeriodicConversion::Read does.
 */
Cells ReadMesh(vtkUnstructuredGrid* mesh);

/** Writes swept quads with the arrays of the quads; see vtkExtrudeQuads. */
void WriteSwept(const crossfield::SweptMesh& swept, const Cells& quads, vtkUnstructuredGrid* from,
  vtkUnstructuredGrid* output);

/** Writes the blocks of a mesh as structured grids with `BlockId` on the cells. */
void WriteBlocks(const crossfield::ExportMesh& mesh, vtkMultiBlockDataSet* output);
}

#endif
