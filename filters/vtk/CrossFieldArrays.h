#ifndef CrossFieldArrays_h
#define CrossFieldArrays_h

#include "CrossFieldReport.h"
#include "DomainConversion.h"
#include "HField.h"

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
 * The values of `CrossFieldCR` at the edges of the mesh that the cells were read into. Throws
 * crossfield::Error when the array is missing or does not have 6 components.
 */
crossfield::ComplexVector ReadField(const DomainConversion::DrilledMesh& cells,
  const crossfield::EdgeNumbering& edges, vtkUnstructuredGrid* input);

/** The report as field data; see vtkPerforatedCrossField. */
void AddReport(const crossfield::CrossField& field, vtkUnstructuredGrid* output);

/** What vtkGinzburgLandauCrossField adds to the report. */
void AddConvexifiedSteps(int steps, vtkUnstructuredGrid* output);

/** Point arrays `H`, `SizeMap`, and the field data `RenormalizedEnergy`; see vtkHField. */
void AddH(const DomainConversion::DrilledMesh& cells, const crossfield::HField& field,
  vtkUnstructuredGrid* output);

/**
 * The values of a cell array on the triangles; none for an empty name. Throws crossfield::Error when
 * the array is missing or does not have one component.
 */
Eigen::VectorXd ReadOnTriangles(
  const DomainConversion::DrilledMesh& cells, const std::string& name, vtkUnstructuredGrid* input);
}

#endif
