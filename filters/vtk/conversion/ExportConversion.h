#ifndef ExportConversion_h
#define ExportConversion_h

#include "ExportMesh.h"

class vtkUnstructuredGrid;

/** Conversion of quads with their boundary edges to the mesh that files are written from. */
namespace ExportConversion
{
/**
 * Reads quads and lines of one order: those of vtkQuadMesher::CopyMesh and vtkQuadsToHigherOrder. Lines
 * have their side in the string array `Side`; all cells are one region with the name domain. Throws
 * crossfield::Error if there are no quads or no lines, other cells, several orders, no sides, or a point that is not
 * finite. Periodic sides are read as PeriodicConversion::Read does.
 */
crossfield::ExportMesh ReadMesh(vtkUnstructuredGrid* mesh);
}

#endif
