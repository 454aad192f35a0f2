/**
 * Error codes that GetErrorCode() of every filter of this module returns; vtkErrorCode::NoError (0)
 * means success. Each error comes with one sentence as an ErrorEvent and with an empty output. Only
 * in ParaView, a filter downstream of a failed filter has BadInput without a sentence of its own.
 */

#ifndef vtkCrossFieldErrorCodes_h
#define vtkCrossFieldErrorCodes_h

#include "vtkErrorCode.h" // for UserError, the first code available to other libraries

namespace vtkCrossFieldErrorCodes
{
enum
{
  /** The input or a parameter is invalid, or the computation failed; the message states which. */
  BadInput = vtkErrorCode::UserError,
  /** The input is valid, but no cross field with the given singularities exists on the domain. */
  Inconsistent = vtkErrorCode::UserError + 1
};
}

#endif
