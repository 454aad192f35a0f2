#ifndef ConfigurationConversion_h
#define ConfigurationConversion_h

#include "DomainPlane.h"
#include "Singularity.h"

class vtkDataArray;
class vtkDataSet;
class vtkPolyData;

/** Conversion of singularities between VTK data and numerics; every function throws crossfield::Error. */
namespace ConfigurationConversion
{
/**
 * Points in the plane of a domain with their arrays `QuarterIndex` and, optionally, `Radius`; nothing
 * for a null pointer.
 */
crossfield::Configuration ReadConfiguration(
  vtkDataSet* input, const crossfield::DomainPlane& plane);

/** The array `QuarterIndex` of points, which must have it. */
vtkDataArray* RequireQuarterIndices(vtkDataSet* input);

/** Points with `QuarterIndex` and, if any of them has one, `Radius`; and their plane (PlaneFrame.h). */
void WriteConfiguration(const crossfield::Configuration& configuration,
  const crossfield::DomainPlane& plane, vtkPolyData* output);
}

#endif
