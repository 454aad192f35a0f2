#ifndef CornerConversion_h
#define CornerConversion_h

#include "CornerClassification.h"
#include "DomainPlane.h"
#include "PoincareHopf.h"

class vtkDataSet;
class vtkFieldData;
class vtkPolyData;
class vtkTable;

/** Conversion of corners and counts to VTK data, in the plane of the domain. */
namespace CornerConversion
{
/** Writes the corners with the point arrays and field data of vtkBoundaryCornerClassifier. */
void WriteCorners(const crossfield::CornerClassification& classification,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Writes the number of ambiguous corners as `AmbiguousCorners`, unless it is 0. */
void WriteAmbiguous(int count, vtkFieldData* report);

/** Writes one row per scenario; see vtkBoundaryCornerClassifier. */
void WriteScenarios(const crossfield::CornerClassification& classification, vtkTable* output);

/** Writes points with `Angle`, `QuarterIndex` and `Cancellable`. */
void WriteCountedCorners(const std::vector<crossfield::CountedCorner>& corners,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Writes points with `QuarterIndex`, in the format of ReadCorners. */
void WriteChoices(const std::vector<crossfield::CornerChoice>& choices,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Writes one row per boundary loop; see vtkPoincareHopfCheck. */
void WriteLoopTable(const crossfield::PoincareHopfCount& count,
  const std::vector<double>& holonomyDefects, vtkTable* output);

/**
 * Returns the points of a data set with their integer point array `QuarterIndex`. A null pointer
 * gives no corners. Throws crossfield::Error if the array is missing or not integer.
 */
std::vector<crossfield::CornerChoice> ReadCorners(
  vtkDataSet* input, const crossfield::DomainPlane& plane);
}

#endif
