#ifndef CrossFieldArrays_h
#define CrossFieldArrays_h

#include "CrossFieldReport.h"
#include "DomainConversion.h"

class vtkUnstructuredGrid;

/** Writes a cross field and its report into the arrays of a mesh. */
namespace CrossFieldArrays
{
/** Cell and point arrays `CrossFieldCR`, `Representation`, `Cross`, `Cross2`, `CrossNorm`. */
void AddField(const DomainConversion::DrilledMesh& cells, const crossfield::CrossField& field,
  vtkUnstructuredGrid* output);

/** The report as field data; see vtkPerforatedCrossField. */
void AddReport(const crossfield::CrossField& field, vtkUnstructuredGrid* output);
}

#endif
