#ifndef CrossFieldArrays_h
#define CrossFieldArrays_h

#include "DrilledMeshConversion.h"
#include "HField.h"
#include "SolvedField.h"

#include <string>

class vtkUnstructuredGrid;

/**
 * Writes a cross field and its report into the arrays of a mesh. Points that no cell uses get zeros.
 */
namespace CrossFieldArrays
{
/**
 * The cell array `CrossFieldCR`, and of the cell and point arrays `Representation`, `Cross`, `Cross2`,
 * `CrossNorm` those of one of vtkCrossFieldArraySets, in single precision. Those of another field that the
 * mesh carried before are removed.
 */
void AddField(const DrilledMeshConversion::DrilledMesh& cells, const crossfield::CrossField& field,
  int arrays, vtkUnstructuredGrid* output);

/**
 * The field that `CrossFieldCR` has on the mesh that the cells were read into. Throws crossfield::Error
 * when the array is missing or does not have 6 components.
 */
crossfield::CrossField ReadField(
  const DrilledMeshConversion::DrilledMesh& cells, vtkUnstructuredGrid* input);

/** The report as field data; see vtkPerforatedCrossField. */
void AddReport(const crossfield::SolvedField& field, vtkUnstructuredGrid* output);

/** What vtkGinzburgLandauCrossField adds to the report. */
void AddConvexifiedSteps(int steps, vtkUnstructuredGrid* output);

/**
 * Point arrays `H` and, unless only exact ones are wanted, `SizeMap` in single precision; and the field data `RenormalizedEnergy` and `PointSingularities`, the
 * configuration where it is one of points; see vtkHField.
 */
void AddH(const DrilledMeshConversion::DrilledMesh& cells, const crossfield::HField& field,
  const crossfield::Configuration& configuration, int arrays, vtkUnstructuredGrid* output);

/**
 * The values of a cell array on the triangles; none for an empty name. Throws crossfield::Error when
 * the array is missing or does not have one component.
 */
Eigen::VectorXd ReadOnTriangles(const DrilledMeshConversion::DrilledMesh& cells,
  const std::string& name, vtkUnstructuredGrid* input);
}

#endif
