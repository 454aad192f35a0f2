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

/**
 * Returns the positions, in a lattice with the first index fastest, of the nodes of a quad in VTK's
 * order: corners, edges from lower to higher index, inside.
 */
std::vector<std::size_t> LatticeOrder(int order);

/**
 * Joins the outputs of vtkQuadMesher for quads and boundary, with its curves, to one mesh; without
 * boundary, or if it is empty, `mesh` is the first input. Throws crossfield::Error if the boundary has not
 * the arrays of that output, or InputCheck::Require refuses an input.
 */
void Join(vtkUnstructuredGrid* quads, vtkPolyData* boundary, vtkUnstructuredGrid* mesh);

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
