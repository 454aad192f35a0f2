#ifndef SurfaceConversion_h
#define SurfaceConversion_h

#include "SurfaceField.h"
#include "SurfaceIndices.h"
#include "SurfaceQuadWorkflow.h"

#include "vtkType.h"

#include <memory>
#include <vector>

class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/** Conversion of surfaces in space between VTK data and numerics. Every function throws crossfield::Error. */
namespace SurfaceConversion
{
/** Returns whether a data set has surface cells that are in no plane (DomainPlane::IsNear). */
bool IsSurface(vtkDataSet* input);

/**
 * Reads the triangles of a surface, whose points are merged as in DomainConversion::ReadDomain. Strips, quadrilaterals
 * and polygons are divided. `cells` receives the cell of each triangle.
 */
crossfield::SurfaceMesh ReadTriangles(vtkDataSet* input, std::vector<vtkIdType>* cells = nullptr);

/** Reads the parts of a surface, with singularities at vertices, that no line divides. */
crossfield::ConedSurfaces Read(vtkDataSet* input, vtkDataSet* singularities);

/** Returns the only part of a surface without sharp edges whose quarter indices add up. */
const crossfield::ConedSurface& Single(const crossfield::ConedSurfaces& surfaces);

/**
 * Writes the triangles of a surface with `H` and `SizeMap` (points), `Cross` and `Cross2` (cells) and the field data
 * `HolonomyDefect`, `Converged` and `UnwantedSingularities` of vtkHField.
 */
void WriteField(const crossfield::ConedSurface& surface, const crossfield::SurfaceField& field,
  vtkUnstructuredGrid* output);

/** Crosses of the triangles of a surface. */
struct Crosses
{
  std::shared_ptr<const crossfield::MeshTopology> topology;
  Eigen::VectorXd angle; ///< Of one direction in the chart of each triangle, radians.
};

/** Reads triangles, without merging points, with the cell array `Cross` along the surface. */
Crosses ReadCrosses(vtkUnstructuredGrid* input);

/** Writes singularities of a field with the arrays of vtkCrossFieldSingularities. */
void WriteSingularities(const crossfield::MeshTopology& topology,
  const std::vector<crossfield::VertexSingularity>& singularities, vtkPolyData* output);

/** Writes corners with the arrays of vtkPoincareHopfCheck. */
void WriteCorners(const std::vector<crossfield::SurfaceCorner>& corners, vtkPolyData* output);

/** Writes singularities as vertices with the array `QuarterIndex`. */
void WriteConfiguration(
  const std::vector<crossfield::SurfaceSingularity>& singularities, vtkPolyData* output);

/** Returns points with the array `QuarterIndex`; a null pointer gives none. */
std::vector<crossfield::SurfaceSingularity> ReadSingularities(vtkDataSet* input);
}

#endif
