#ifndef PartSelection_h
#define PartSelection_h

#include "vtkSmartPointer.h"

#include <string>

class vtkDataSet;

/** Selection of one of several connected parts of a domain. */
namespace PartSelection
{
/**
 * Returns the cells of one part with their arrays, in a data set of the type of the input; the input itself if `part` is empty.
 * `part` is "largest", a number from 1 for the largest, or the name of a side that one part alone has, in the cell array
 * that SideConversion::FindArray finds. Throws crossfield::Error if there is no such part, or the loops are not valid.
 */
vtkSmartPointer<vtkDataSet> Select(
  vtkDataSet* input, const std::string& part, const std::string& sideNameArray);
}

#endif
