#ifndef PointTable_h
#define PointTable_h

#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <optional>
#include <string>
#include <vector>

class vtkAbstractArray;
class vtkTable;

/** Comma-separated tables of points, written by users or exported by ParaView. */
namespace PointTable
{
/** Returns the text of a file. Reads it once from the beginning to the end, as a pipe requires. */
std::string ReadFile(const std::string& file);

/**
 * Returns the table of a text whose first line names the columns. It has no columns if VTK cannot
 * read the text.
 */
vtkSmartPointer<vtkTable> Read(const std::string& text);

/**
 * Returns the names of the column of a coordinate, 0 to 2: x, Points:0, or Points_0 as some
 * programs write it.
 */
std::vector<std::string> NamesOfAxis(int axis);

/**
 * Returns the first column with one of the names, ignoring case and surrounding blanks, or null.
 */
vtkAbstractArray* FindColumn(vtkTable* table, const std::vector<std::string>& names);

/**
 * Returns the number in a row of a column, which may have a plus sign and blanks around it; none if
 * there is something else. vtkVariant accepts plus signs before VTK 9.3 only.
 */
std::optional<double> NumberAt(vtkAbstractArray* column, vtkIdType row);
}

#endif
