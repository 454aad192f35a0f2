/**
 * What GetErrorCode() of every filter of this module gives; 0, vtkErrorCode::NoError, when nothing
 * went wrong. Each comes with one sentence as an ErrorEvent, and an empty output; only in ParaView a
 * filter below one that has failed has BadInput without a sentence of its own.
 */

#ifndef vtkCrossFieldErrorCodes_h
#define vtkCrossFieldErrorCodes_h

#include "vtkErrorCode.h" // for the number that codes of other libraries than VTK begin with

namespace vtkCrossFieldErrorCodes
{
enum
{
  /** The input or a parameter is bad, or the computation broke down; the sentence says which. */
  BadInput = vtkErrorCode::UserError,
  /** The input is valid, but no cross field with the given singularities exists on the domain. */
  Inconsistent = vtkErrorCode::UserError + 1
};
}

#endif
