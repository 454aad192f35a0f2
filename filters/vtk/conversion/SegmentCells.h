#ifndef SegmentCells_h
#define SegmentCells_h

#include "DomainConversion.h"

#include "vtkType.h"

#include <functional>
#include <vector>

class vtkDataSet;

/** Lines of a data set along the boundary of its domain. */
namespace SegmentCells
{
/**
 * Returns for every segment of a domain, per loop that after each vertex, the first line of the data
 * set between its ends for which `isWanted` is true; −1 if there is none.
 */
std::vector<std::vector<vtkIdType>> Find(vtkDataSet* input, const DomainConversion::Domain& domain,
  const std::function<bool(vtkIdType)>& isWanted);

/** Does the same, with lines that segments are parts of: ends of lines inside divide segments of the boundary. */
std::vector<std::vector<vtkIdType>> FindAround(vtkDataSet* input,
  const DomainConversion::Domain& domain, const std::function<bool(vtkIdType)>& isWanted);
}

#endif
