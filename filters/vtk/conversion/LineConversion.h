#ifndef LineConversion_h
#define LineConversion_h

#include "CellsAlongLines.h"
#include "DomainPlane.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataSet;

/** Lines inside of a domain along which quads are aligned: line cells of given names. */
namespace LineConversion
{
/** Names of lines, and which cells are on them. */
struct Lines
{
  std::vector<std::string> names;
  std::vector<int> ofCell; ///< Per cell, an index in `names`; −1 for others. Empty without names.
};

/**
 * Finds the lines whose names are in `lines`, and those of `open` that are names of lines; others may be those of
 * interfaces. `array` is the requested cell array with names (SideConversion::FindArray). Throws crossfield::Error if
 * no line has one of the names in `lines`.
 */
Lines Find(vtkDataSet* input, const std::string& array, const std::vector<std::string>& lines,
  const std::vector<std::string>& open);

/** Returns a domain without its lines. Its cells have no data. */
vtkSmartPointer<vtkDataSet> Without(vtkDataSet* input, const Lines& lines);

/** Returns the segments of lines in a plane. */
std::vector<crossfield::SegmentOnLine> Read(
  vtkDataSet* input, const Lines& lines, const crossfield::DomainPlane& plane);
}

#endif
