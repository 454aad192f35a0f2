#ifndef DrilledMeshConversion_h
#define DrilledMeshConversion_h

#include "DomainPlane.h"
#include "PlanarTopology.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

/**
 * Conversion of drilled meshes between VTK data and numerics. Every function throws
 * crossfield::Error.
 */
namespace DrilledMeshConversion
{
/**
 * Returns the data set if it is a mesh with the cell array `BoundaryKind`, such as one of
 * vtkDrillHoles, else null.
 */
vtkUnstructuredGrid* AsDrilledMesh(vtkDataSet* input);

/** Drilled mesh, its plane, and the points and cells of its vertices, triangles and edges. */
struct DrilledMesh
{
  crossfield::SharedPlanarTopology topology;
  crossfield::DomainPlane plane;
  std::vector<vtkIdType> pointIds; ///< Without points that no cell uses.
  std::vector<vtkIdType> triangleCells;
  std::vector<vtkIdType> lineCells;
  std::vector<vtkIdType> imprintedCells; ///< Edges of imprinted circles.
};

/**
 * Reads a drilled mesh. Throws crossfield::Error also if the cells do not form a mesh; see
 * PlanarTopology.h.
 */
DrilledMesh ReadDrilledMesh(vtkUnstructuredGrid* input);

/** Returns the points and cells of a mesh in the order of WriteDrilledMesh. */
DrilledMesh NumberCells(
  const crossfield::SharedPlanarTopology& topology, const crossfield::DomainPlane& plane);

/** Writes triangles, then lines, in the given plane, with the cell arrays of vtkDrillHoles. */
void WriteDrilledMesh(const crossfield::TriangleMesh& mesh, const crossfield::DomainPlane& plane,
  vtkUnstructuredGrid* output);
}

#endif
