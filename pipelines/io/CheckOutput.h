#ifndef CheckOutput_h
#define CheckOutput_h

#include "vtkSmartPointer.h"

class vtkAlgorithm;
class vtkConfigurationProposal;
class vtkPoincareHopfCheck;
class vtkPolyData;
class vtkTable;

/** Output of `crossfield check`: the lines that it prints, and the alternatives that it writes. */
namespace CheckOutput
{
/** Prints the counts of the theorem, the corners that can be cancelled and the holonomy defects. */
void Print(vtkPoincareHopfCheck* check);

/** Returns the points of one alternative with their quarter indices. */
vtkSmartPointer<vtkPolyData> AlternativePoints(vtkConfigurationProposal* proposal, int number);

/** Prints a row for each alternative that was proposed. */
void PrintAlternatives(vtkTable* table);

/**
 * Prints a line if the cheapest quarter indices of the corners, those of `crossfield corners`, need
 * a sum in the interior that differs from the required one.
 */
void PrintCornerHint(vtkAlgorithm* domain, double required);
}

#endif
