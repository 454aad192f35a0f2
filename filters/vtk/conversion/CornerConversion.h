#ifndef CornerConversion_h
#define CornerConversion_h

#include "CornerClassification.h"
#include "DomainPlane.h"
#include "PoincareHopf.h"

class vtkDataSet;
class vtkPolyData;
class vtkTable;

/** Conversion of corners and counts to VTK data, in the plane of the domain. */
namespace CornerConversion
{
/** Point arrays of vtkBoundaryCornerClassifier, and its field data. */
void WriteCorners(const crossfield::CornerClassification& classification,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** One row per scenario; see vtkBoundaryCornerClassifier. */
void WriteScenarios(const crossfield::CornerClassification& classification, vtkTable* output);

/** Points with `Angle`, `QuarterIndex` and `Cancellable`. */
void WriteCountedCorners(const std::vector<crossfield::CountedCorner>& corners,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Points with `QuarterIndex`, as ReadCorners takes them. */
void WriteChoices(const std::vector<crossfield::CornerChoice>& choices,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** One row per boundary loop; see vtkPoincareHopfCheck. */
void WriteLoopTable(const crossfield::PoincareHopfCount& count,
  const std::vector<double>& holonomyDefects, vtkTable* output);

/**
 * The points of a data set with their integer point array `QuarterIndex`; nothing for a null
 * pointer. Throws crossfield::Error when the array is missing or not integer.
 */
std::vector<crossfield::CornerChoice> ReadCorners(
  vtkDataSet* input, const crossfield::DomainPlane& plane);
}

#endif
