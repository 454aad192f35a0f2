#ifndef CrossFieldArrays_h
#define CrossFieldArrays_h

#include "DrilledMeshConversion.h"
#include "HField.h"
#include "SolvedField.h"

#include <string>

class vtkUnstructuredGrid;

/**
 * Functions that write a cross field and its report to the arrays of a mesh. Points that no cell
 * uses get zeros.
 */
namespace CrossFieldArrays
{
/**
 * Adds the cell array `CrossFieldCR` and, in single precision, those of the cell and point arrays
 * `Representation`, `Cross`, `Cross2`, `CrossNorm` that a value of vtkCrossFieldArraySets selects.
 * Removes the arrays of an earlier field of the mesh.
 */
void AddField(const DrilledMeshConversion::DrilledMesh& cells, const crossfield::CrossField& field,
  int arrays, vtkUnstructuredGrid* output);

/**
 * Returns the field in the array `CrossFieldCR` on a mesh whose cells were read before. Throws
 * crossfield::Error if the array is missing or does not have 6 components.
 */
crossfield::CrossField ReadField(
  const DrilledMeshConversion::DrilledMesh& cells, vtkUnstructuredGrid* input);

/** Adds the report as field data; see vtkPerforatedCrossField. */
void AddReport(const crossfield::SolvedField& field, vtkUnstructuredGrid* output);

/** Adds the field data that only vtkGinzburgLandauCrossField reports. */
void AddConvexifiedSteps(int steps, vtkUnstructuredGrid* output);

/**
 * Adds the point array `H` and, unless `arrays` selects exact arrays only, `SizeMap` in single
 * precision; and the field data `RenormalizedEnergy` and `PointSingularities`, the configuration,
 * if its singularities are points. See vtkHField.
 */
void AddH(const DrilledMeshConversion::DrilledMesh& cells, const crossfield::HField& field,
  const crossfield::Configuration& configuration, int arrays, vtkUnstructuredGrid* output);

/**
 * Returns the values of a cell array on the triangles; an empty name gives none. Throws
 * crossfield::Error if the array is missing or does not have one component.
 */
Eigen::VectorXd ReadOnTriangles(const DrilledMeshConversion::DrilledMesh& cells,
  const std::string& name, vtkUnstructuredGrid* input);
}

#endif
