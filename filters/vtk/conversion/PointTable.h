#ifndef PointTable_h
#define PointTable_h

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkAbstractArray;
class vtkTable;

/** Comma-separated tables of points, as people write them and as ParaView exports them. */
namespace PointTable
{
/** The whole text of a file; a pipe can be read once only, from the beginning to the end. */
std::string ReadFile(const std::string& file);

/** The table of a text whose first line names the columns; without columns if VTK cannot read it. */
vtkSmartPointer<vtkTable> Read(const std::string& text);

/** The names of the column of a coordinate, 0 to 2: x or Points:0, which some programs write Points_0. */
std::vector<std::string> NamesOfAxis(int axis);

/** The first column that has one of the names, in large or small letters with any blanks around; or null. */
vtkAbstractArray* FindColumn(vtkTable* table, const std::vector<std::string>& names);
}

#endif
