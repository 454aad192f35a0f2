/**
 * Which arrays the filters that compute a cross field write: values of their property Arrays. The exact
 * field is in double precision; what can be derived from it is in single precision, enough to look at.
 */

#ifndef vtkCrossFieldArraySets_h
#define vtkCrossFieldArraySets_h

namespace vtkCrossFieldArraySets
{
enum
{
  /** `CrossFieldCR`, and `H` of vtkHField: all that the filters of this module need. */
  Exact = 0,
  /** Also `Cross` and `CrossNorm`, and `SizeMap` of vtkHField: what one looks at. */
  Display = 1,
  /** Also `Representation` and `Cross2`. */
  All = 2
};
}

#endif
