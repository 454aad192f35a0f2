/**
 * Values of the property Arrays of filters that compute a cross field: the sets of arrays that they
 * write. The exact field is in double precision; arrays that follow from it are in single
 * precision.
 */

#ifndef vtkCrossFieldArraySets_h
#define vtkCrossFieldArraySets_h

namespace vtkCrossFieldArraySets
{
enum
{
  /** `CrossFieldCR`, and `H` of vtkHField: the arrays that other filters need. */
  Exact = 0,
  /** Also `Cross` and `CrossNorm`, and `SizeMap` of vtkHField: arrays for display. */
  Display = 1,
  /** Also `Representation` and `Cross2`. */
  All = 2
};
}

#endif
