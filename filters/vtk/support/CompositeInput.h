#ifndef CompositeInput_h
#define CompositeInput_h

#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkInformationVector;

namespace CompositeInput
{
/**
 * Returns the data set of a port. Blocks become one data set with the arrays that all of them have:
 * loops of several blocks may bound one domain.
 */
vtkSmartPointer<vtkDataSet> Append(vtkInformationVector* port);
}

#endif
