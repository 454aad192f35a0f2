#ifndef ConfigurationConversion_h
#define ConfigurationConversion_h

#include "DomainPlane.h"
#include "Singularity.h"

class vtkDataArray;
class vtkDataSet;
class vtkPolyData;

/**
 * Conversion of singularities between VTK data and numerics. Every function throws
 * crossfield::Error.
 */
namespace ConfigurationConversion
{
/**
 * Returns the points of a data set, in the plane of a domain, with their arrays `QuarterIndex` and
 * optionally `Radius`. A null pointer gives no singularities.
 */
crossfield::Configuration ReadConfiguration(
  vtkDataSet* input, const crossfield::DomainPlane& plane);

/** Returns the array `QuarterIndex` of points, which must exist. */
vtkDataArray* RequireQuarterIndices(vtkDataSet* input);

/**
 * Writes points with `QuarterIndex`, with `Radius` if any point has one, and with their plane
 * (PlaneFrame.h).
 */
void WriteConfiguration(const crossfield::Configuration& configuration,
  const crossfield::DomainPlane& plane, vtkPolyData* output);
}

#endif
