#ifndef DrilledMeshConversion_h
#define DrilledMeshConversion_h

#include "DomainPlane.h"
#include "MeshTopology.h"

#include "vtkType.h"

#include <vector>

class vtkDataSet;
class vtkUnstructuredGrid;

/** Conversion of drilled meshes between VTK data and numerics; every function throws crossfield::Error. */
namespace DrilledMeshConversion
{
/** The data set if it is a mesh with the cell array `BoundaryKind`, as vtkDrillHoles makes, else null. */
vtkUnstructuredGrid* AsDrilledMesh(vtkDataSet* input);

/** A drilled mesh, its plane, and which points and cells its vertices, triangles and edges are. */
struct DrilledMesh
{
  crossfield::SharedTopology topology;
  crossfield::DomainPlane plane;
  std::vector<vtkIdType> pointIds; ///< Points that no cell uses are left out.
  std::vector<vtkIdType> triangleCells;
  std::vector<vtkIdType> lineCells;
  std::vector<vtkIdType> imprintedCells; ///< Of the edges of imprinted circles.
};

/** Throws crossfield::Error also where the cells make no mesh; see MeshTopology.h. */
DrilledMesh ReadDrilledMesh(vtkUnstructuredGrid* input);

/** The points and cells of a mesh as WriteDrilledMesh writes them. */
DrilledMesh NumberCells(
  const crossfield::SharedTopology& topology, const crossfield::DomainPlane& plane);

/** Triangles, then lines, in the given plane, with the cell arrays of vtkDrillHoles. */
void WriteDrilledMesh(const crossfield::TriangleMesh& mesh, const crossfield::DomainPlane& plane,
  vtkUnstructuredGrid* output);
}

#endif
