#ifndef RegionValues_h
#define RegionValues_h

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataSet;

/** The regions of cells by their values in a cell array. */
struct RegionValues
{
  std::vector<int> ofCell;        ///< Per cell that was asked for, the number of its region.
  std::vector<std::string> names; ///< Of the regions; those of integers are their decimal text.
  std::vector<int> values;        ///< Value of each region in the array `Region`.
  bool areNamed = false;          ///< Whether the array holds strings.

  /**
   * Reads the regions of cells from an array of strings or integers. Regions are in the order of integers, or of
   * the first cells of strings, whose values are their numbers.
   */
  static RegionValues Read(
    vtkDataSet* input, const std::string& array, const std::vector<vtkIdType>& cells);
};

#endif
