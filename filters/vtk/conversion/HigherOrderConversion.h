#ifndef HigherOrderConversion_h
#define HigherOrderConversion_h

#include "DomainPlane.h"
#include "HigherOrder.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkPolyData;
class vtkUnstructuredGrid;

/** Conversion of quads of higher order; see vtkQuadsToHigherOrder for the arrays. */
namespace HigherOrderConversion
{
/** Quads with straight edges, and where they were read from. */
struct Quads
{
  crossfield::StraightQuads straight;
  crossfield::DomainPlane plane;
  std::vector<vtkIdType> quadCells; ///< Cell of each quad.
  std::vector<vtkIdType> edgeCells; ///< Cell of each boundary edge.
};

/** Throws crossfield::Error unless quads and boundary have the arrays of vtkQuadMesher's outputs. */
void RequireBoundaryOf(vtkUnstructuredGrid* quads, vtkPolyData* boundary);

/**
 * Reads quads, their boundary edges and curves. Throws crossfield::Error if there are cells that are
 * neither quads nor lines, or no quads or lines, and as CurveConversion::ReadCurves does.
 */
Quads ReadQuads(vtkUnstructuredGrid* mesh);

/** Writes quads and edges of higher order in the order of the cells of `mesh`, with its arrays. */
void WriteQuads(const Quads& quads, const crossfield::CurvedQuads& curved,
  vtkUnstructuredGrid* mesh, vtkUnstructuredGrid* output);

/** Returns a sentence about inverted quads. */
std::string DescribeInverted(const crossfield::CurvedQuads& curved);
}

#endif
