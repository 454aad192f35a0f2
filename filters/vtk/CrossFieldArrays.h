#ifndef CrossFieldArrays_h
#define CrossFieldArrays_h

#include "DomainConversion.h"
#include "HField.h"
#include "SolvedField.h"

#include <string>

class vtkUnstructuredGrid;

/**
 * Writes a cross field and its report into the arrays of a mesh. Points that no cell uses get zeros.
 */
namespace CrossFieldArrays
{
/** Cell and point arrays `CrossFieldCR`, `Representation`, `Cross`, `Cross2`, `CrossNorm`. */
void AddField(const DomainConversion::DrilledMesh& cells, const crossfield::CrossField& field,
  vtkUnstructuredGrid* output);

/**
 * The field that `CrossFieldCR` has on the mesh that the cells were read into. Throws crossfield::Error
 * when the array is missing or does not have 6 components.
 */
crossfield::CrossField ReadField(
  const DomainConversion::DrilledMesh& cells, vtkUnstructuredGrid* input);

/** The report as field data; see vtkPerforatedCrossField. */
void AddReport(const crossfield::SolvedField& field, vtkUnstructuredGrid* output);

/** What vtkGinzburgLandauCrossField adds to the report. */
void AddConvexifiedSteps(int steps, vtkUnstructuredGrid* output);

/**
 * Point arrays `H`, `SizeMap`, and the field data `RenormalizedEnergy` and `PointSingularities`, the
 * configuration where it is one of points; see vtkHField.
 */
void AddH(const DomainConversion::DrilledMesh& cells, const crossfield::HField& field,
  const crossfield::Configuration& configuration, vtkUnstructuredGrid* output);

/**
 * The values of a cell array on the triangles; none for an empty name. Throws crossfield::Error when
 * the array is missing or does not have one component.
 */
Eigen::VectorXd ReadOnTriangles(
  const DomainConversion::DrilledMesh& cells, const std::string& name, vtkUnstructuredGrid* input);
}

#endif
