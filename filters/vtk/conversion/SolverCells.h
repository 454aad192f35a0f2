#ifndef SolverCells_h
#define SolverCells_h

#include "vtkCellType.h"
#include "vtkType.h"

#include <array>

/** Types of cells of a SolverMesh in VTK. */
namespace SolverCells
{
/** A type of cells of VTK. */
struct CellKind
{
  int type;
  int dimension;
  int order;
  vtkIdType points;
};

/** All types. */
constexpr std::array<CellKind, 12> Kinds = { { { VTK_LINE, 1, 1, 2 },
  { VTK_QUADRATIC_EDGE, 1, 2, 3 }, { VTK_LAGRANGE_CURVE, 1, 3, 4 }, { VTK_TRIANGLE, 2, 1, 3 },
  { VTK_QUADRATIC_TRIANGLE, 2, 2, 6 }, { VTK_QUAD, 2, 1, 4 }, { VTK_BIQUADRATIC_QUAD, 2, 2, 9 },
  { VTK_LAGRANGE_QUADRILATERAL, 2, 3, 16 }, { VTK_WEDGE, 3, 1, 6 }, { VTK_HEXAHEDRON, 3, 1, 8 },
  { VTK_BIQUADRATIC_QUADRATIC_WEDGE, 3, 2, 18 }, { VTK_TRIQUADRATIC_HEXAHEDRON, 3, 2, 27 } } };
}

#endif
