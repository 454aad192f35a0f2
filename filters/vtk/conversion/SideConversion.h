#ifndef SideConversion_h
#define SideConversion_h

#include "BoundarySides.h"
#include "DomainConversion.h"
#include "QuadMesh.h"
#include "SideText.h"

#include <string>
#include <vector>

class vtkCellData;
class vtkDataSet;
class vtkDoubleArray;
class vtkFieldData;
class vtkMultiBlockDataSet;
class vtkStringArray;
class vtkTable;

namespace crossfield
{
struct QuadResult;
struct RegionSet;
}

/** Conversion of the names of boundary sides. */
namespace SideConversion
{
/**
 * Returns the name of the cell array with the names of sides: `requested`, or `Side` if that is
 * empty and the cells have it, otherwise nothing. Throws crossfield::Error if a requested array is
 * missing or holds neither strings nor integers.
 */
std::string FindArray(vtkDataSet* input, const std::string& requested);

/** Returns the names of all cells in the array that FindArray finds; nothing without one. */
std::vector<std::string> NamesOfCells(vtkDataSet* input, const std::string& requested);

/**
 * Reads the sides of each part of a domain from a cell array of its lines: of its curves, or,
 * beside surface cells, of lines along their boundary. Integers are read as their decimal text.
 * Segments of the boundary without a line, and lines with an empty string, have no name (see
 * crossfield::NameSides); lines inside the domain are ignored. With `regions`, the parts are their domains, and
 * sides between them have the names of interfaces. Throws crossfield::Error as
 * FindArray does, or if a requested array names no segment.
 */
std::vector<crossfield::BoundarySides> ReadSides(vtkDataSet* input, const std::string& requested,
  const std::vector<DomainConversion::Domain>& parts, crossfield::RegionSet* regions = nullptr);

/**
 * Reads a table of sides with the columns of SideText, of strings or numbers; 0 prescribes nothing. A table
 * without columns has no rows. Throws crossfield::Error if it has another column, or a row without a name.
 */
std::vector<SideText::Row> ReadTable(vtkTable* table);

/** Adds the array `Side` of boundary lines. */
void WriteSides(const crossfield::QuadMesh& mesh, vtkCellData* data);

/**
 * Adds the field data `SideName` of blocks: four strings; a side of a block along several sides of
 * the boundary has their names in order, separated by commas.
 */
void WriteBlockSides(const crossfield::QuadResult& result, vtkMultiBlockDataSet* blocks);

/** Adds the field data `SideNames`, `SideEdges` and `SideLengths`, one value per side. */
void WriteReport(const crossfield::QuadMesh& mesh, vtkFieldData* data);

/** Writes the name of each side, and the middle of the middle one of its edges. */
void WritePlaces(const crossfield::QuadMesh& mesh, const crossfield::DomainPlane& plane,
  vtkStringArray* names, vtkDoubleArray* places);
}

#endif
