#ifndef QuadsOutput_h
#define QuadsOutput_h

#include <initializer_list>
#include <string>

class vtkFieldData;
class vtkUnstructuredGrid;

/** The lines that `crossfield quads` prints. */
namespace QuadsOutput
{
/** Prints numbers of quads, blocks and irregular nodes, and the quality. */
void Print(vtkUnstructuredGrid* quads);

/** Prints the names of the sides, and a line for each boundary layer, each pair of periodic sides and each curve. */
void PrintSides(vtkFieldData* report);

/** Prints the names of the files that were written; an empty name stands for none. */
void PrintFiles(std::initializer_list<std::string> files);
}

#endif
