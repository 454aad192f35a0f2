#ifndef MaterialCheck_h
#define MaterialCheck_h

#include <string>

class vtkDataSet;

namespace MaterialCheck
{
/**
 * Returns the cell array of the materials of a domain: `requested`, nothing for `none`, and if `requested` is empty
 * `Material` or `Region`, if one of them is an array of materials with several values on the surface cells. Throws
 * crossfield::Error if a requested array is missing or holds neither strings nor single integers.
 */
std::string FindArray(vtkDataSet* domain, const std::string& requested);

/**
 * Returns a warning that a domain of several materials is meshed as one, with the name of the array and its number of
 * values; empty if there is none. An array of materials is a cell array of integers or strings with several values on the
 * surface cells, and fewer values than cells, which numbers of the cells would have. Arrays that the filters here write, and
 * those of VTK about ghosts and original cells, are not meant.
 */
std::string Warning(vtkDataSet* domain);
}

#endif
