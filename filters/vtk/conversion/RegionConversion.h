#ifndef RegionConversion_h
#define RegionConversion_h

#include "DomainConversion.h"
#include "QuadRequest.h"
#include "RegionSet.h"

#include <string>
#include <vector>

class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkUnstructuredGrid;

/** Conversion of domains of several materials. */
namespace RegionConversion
{
/** Regions in their plane. */
struct Regions
{
  crossfield::RegionSet set;
  crossfield::DomainPlane plane;
  std::vector<int> values; ///< Value of each material in the array `Region`.

  /** Returns the domains of the regions. */
  std::vector<DomainConversion::Domain> Domains() const;
};

/**
 * Reads the regions of the surface cells of a data set, whose materials are in a cell array of strings or integers.
 * The values of integers are kept, strings have values from 0 in their order. Throws crossfield::Error as
 * crossfield::MakeRegionSet does.
 */
Regions Read(vtkDataSet* input, const std::string& array);

/**
 * Adds `Region` (int), the value of the material, to the quads and to the cells of blocks, and `RegionLeft` and
 * `RegionRight` to boundary edges (−1 outside). To the report it adds for each material `MaterialName` (string) and
 * `MaterialValue` (int), its name and value, and for each region `RegionName` (string), its material, and
 * `RegionQuads`, `RegionRequiredInteriorQuarters` and `RegionGivenInteriorQuarters` (int).
 */
void Write(const Regions& regions, const crossfield::QuadWorkflowResult& result,
  vtkUnstructuredGrid* quads, vtkMultiBlockDataSet* blocks, vtkPolyData* boundary,
  vtkFieldData* report);
}

#endif
