#ifndef RegionConversion_h
#define RegionConversion_h

#include "DomainConversion.h"
#include "LineConversion.h"
#include "QuadRequest.h"
#include "RegionSet.h"
#include "RegionValues.h"

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
  RegionValues values; ///< Of materials.

  /** Returns the domains of the regions. */
  std::vector<DomainConversion::Domain> Domains() const;
};

/**
 * Reads the regions of the surface cells of a data set, whose materials are in a cell array of strings or integers, and
 * which lines divide. Values are those of the integers, or the numbers of strings in the order of their first cells.
 * Without an array, which needs lines, the domain is of the material `domain`, value 0. Throws crossfield::Error as
 * crossfield::MakeRegionSet and crossfield::CellsAlongLines do.
 */
Regions Read(
  vtkDataSet* input, const std::string& array, const LineConversion::Lines& lines, vtkObject* self);

/**
 * Adds for each region `RegionMaterial` (string), `RegionRequiredInteriorQuarters` and
 * `RegionGivenInteriorQuarters` (int) to a report.
 */
void WriteCounts(const std::vector<crossfield::RegionReport>& regions,
  const std::vector<std::string>& materials, vtkFieldData* report);

/**
 * Adds `Region` (int), the value of the material, to the quads, to the cells of blocks and to boundary edges, where it
 * is that on their left, and `RegionLeft` and `RegionRight` to boundary edges (−1 outside). To the report it adds, if
 * materials are strings, `RegionName` (string), the material of each value, and for each region `RegionMaterial`
 * (string), `RegionQuads`, `RegionRequiredInteriorQuarters` and `RegionGivenInteriorQuarters` (int), and for each
 * interface `InterfaceName` (string), `InterfaceEdges` (int) and `InterfaceSizeRatio` (double, the largest ratio of the
 * areas of the two quads at an edge, and the median).
 */
void Write(const RegionValues& regions, const crossfield::QuadWorkflowResult& result,
  vtkUnstructuredGrid* quads, vtkMultiBlockDataSet* blocks, vtkPolyData* boundary,
  vtkFieldData* report);
}

#endif
