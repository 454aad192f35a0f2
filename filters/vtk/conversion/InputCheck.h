#ifndef InputCheck_h
#define InputCheck_h

#include "vtkType.h"

class vtkDataSet;

/**
 * Readers do not check what they read, nor do data sets check what they are given. What this module
 * takes as given is checked here, before any filter walks along cells.
 */
namespace InputCheck
{
/**
 * Throws crossfield::Error unless every cell has its points, in the number that its type asks for,
 * among those of the data set, and every array of cells and points has a tuple for each.
 */
void Require(vtkDataSet* input);

/** Throws crossfield::Error unless the three coordinates of a point are finite. */
void RequireFinite(const double* place, vtkIdType point);
}

#endif
