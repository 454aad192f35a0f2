#ifndef InputCheck_h
#define InputCheck_h

#include "vtkType.h"

class vtkDataSet;

/**
 * Checks of input data before a filter loops over cells. Neither readers nor data sets check their
 * content.
 */
namespace InputCheck
{
/**
 * Throws crossfield::Error unless every cell has the number of points of its type, all of them
 * points of the data set, and every array of cells and points has a tuple for each.
 */
void Require(vtkDataSet* input);

/** Throws crossfield::Error unless the three coordinates of a point are finite. */
void RequireFinite(const double* place, vtkIdType point);
}

#endif
