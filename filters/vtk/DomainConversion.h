#ifndef DomainConversion_h
#define DomainConversion_h

#include "PlanarDomain.h"
#include "Singularity.h"
#include "TriangleMesh.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/** Conversion between VTK data and numerics; every function throws crossfield::Error. */
namespace DomainConversion
{
/** Boundary loops and the plane z = const that they lie in. */
struct Loops
{
  std::vector<crossfield::Loop> loops;
  double z = 0.0;
};

/**
 * Reads boundary loops from lines, or the boundary of surface cells. Points closer than 1e-9 of
 * the bounding box's diagonal are one point.
 */
Loops ReadLoops(vtkDataSet* input);

/** One closed polyline per loop in the plane z = 0. */
void WriteLoops(const std::vector<crossfield::Loop>& loops, vtkPolyData* output);

/** Reads the points with their arrays `QuarterIndex` and, optionally, `Radius`. */
crossfield::Configuration ReadConfiguration(vtkDataSet* input);

/** A drilled mesh, and which cells its triangles and boundary edges are. */
struct DrilledMesh
{
  crossfield::TriangleMesh mesh;
  std::vector<vtkIdType> triangleCells;
  std::vector<vtkIdType> lineCells;
  std::vector<vtkIdType> imprintedCells; ///< Of the edges of imprinted circles.
};

DrilledMesh ReadDrilledMesh(vtkUnstructuredGrid* input);

/** Triangles, then lines, in the plane of the given z, with the cell arrays of vtkDrillHoles. */
void WriteDrilledMesh(
  const crossfield::TriangleMesh& mesh, double z, vtkUnstructuredGrid* output);
}

#endif
