#ifndef DomainConversion_h
#define DomainConversion_h

#include "DomainPlane.h"
#include "MeshTopology.h"
#include "PlanarDomain.h"
#include "Singularity.h"

#include "vtkType.h"

#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * Conversion between VTK data and numerics; every function throws crossfield::Error. This is where
 * data of a plane in space become coordinates of that plane, and back (DomainPlane.h).
 */
namespace DomainConversion
{
/** A domain, and the plane in space that it lies in. */
struct Domain
{
  crossfield::PlanarDomain domain;
  crossfield::DomainPlane plane;
};

/** The plane of the points of a data set that its lines and surface cells use. */
crossfield::DomainPlane FindPlane(vtkDataSet* input);

/**
 * Reads a domain from lines along its boundary, or from surface cells, which have to cover it once.
 * Points closer than 1e-9 of the bounding box's diagonal are one point.
 */
Domain ReadDomain(vtkDataSet* input);

/** One closed polyline per loop in the plane z = 0. */
void WriteLoops(const std::vector<crossfield::Loop>& loops, vtkPolyData* output);

/**
 * Points in the plane of a domain with their arrays `QuarterIndex` and, optionally, `Radius`; nothing
 * for a null pointer.
 */
crossfield::Configuration ReadConfiguration(
  vtkDataSet* input, const crossfield::DomainPlane& plane);

/** The array `QuarterIndex` of points, which must have it. */
vtkDataArray* RequireQuarterIndices(vtkDataSet* input);

/** Points with `QuarterIndex` and, if any of them has one, `Radius`. */
void WriteConfiguration(const crossfield::Configuration& configuration,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

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
