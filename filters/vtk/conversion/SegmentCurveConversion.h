#ifndef SegmentCurveConversion_h
#define SegmentCurveConversion_h

#include "BoundaryPieces.h"
#include "DomainConversion.h"

class vtkDataSet;

/** Conversion of the curves of a domain's boundary. */
namespace SegmentCurveConversion
{
/**
 * Reads the curves of the segments of a domain from the arrays of its lines (CurveConversion.h),
 * without curves that no segment has. Throws crossfield::Error as CurveConversion::ReadCurves does.
 */
crossfield::CurvesOfSegments Read(vtkDataSet* input, const DomainConversion::Domain& domain);

/** Copies the field data with curves, if there are any. */
void CopyCurves(vtkDataSet* from, vtkDataSet* to);
/** Removes the field data with curves. */
void RemoveCurves(vtkDataSet* data);
}

#endif
