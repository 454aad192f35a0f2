#ifndef FilterRun_h
#define FilterRun_h

#include "Error.h"
#include "MemoryBudget.h"
#include "Progress.h"
#include "vtkCrossFieldErrorCodes.h"

#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"

#include <cerrno>
#include <exception>
#include <new>
#include <string>
#include <system_error>

/** The one way in which the filters of this module call numerics, from their RequestData. */
namespace FilterRun
{
// CheckAbort() asks the algorithms downstream as well; VTK 9.1 does not have it.
template <class Algorithm>
auto WantsAbort(Algorithm* self, int) -> decltype(self->CheckAbort())
{
  return self->CheckAbort();
}
template <class Algorithm>
bool WantsAbort(Algorithm* self, long)
{
  return self->GetAbortExecute() != 0;
}

// After an abort the executive empties the outputs, unless the filter has something to keep; VTK 9.1
// does not empty them.
template <class Algorithm>
auto KeepAbortedOutput(Algorithm* self, int) -> decltype(self->SetAbortOutput(false))
{
  return self->SetAbortOutput(false);
}
template <class Algorithm>
void KeepAbortedOutput(Algorithm*, long)
{
}

/**
 * Runs work(progress), forwarding progress to the filter and its abort flag to the numerics, and
 * returns the error code for the filter to publish. An error is reported as one vtkErrorMacro
 * sentence; an abort is no error. Either leaves the output as it was: work fills it last.
 */
template <class Algorithm, class Work>
unsigned long Try(Algorithm* self, Work work)
{
  const crossfield::Progress progress(
    [self](double fraction)
    {
      self->UpdateProgress(fraction);
      return !WantsAbort(self, 0);
    });
  try
  {
    progress.Report(0.0); // an abort before the work begins
    work(progress);
    return vtkErrorCode::NoError;
  }
  catch (const crossfield::Aborted&)
  {
    return vtkErrorCode::NoError;
  }
  catch (const crossfield::Error& error)
  {
    vtkErrorWithObjectMacro(self, << error.what());
    return error.GetKind() == crossfield::Error::Kind::Inconsistent
      ? vtkCrossFieldErrorCodes::Inconsistent
      : vtkCrossFieldErrorCodes::BadInput;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(self, << crossfield::OutOfMemory);
    return vtkCrossFieldErrorCodes::BadInput;
  }
  catch (const std::exception& error) // of a library, and no sentence: it may have several lines
  {
    const std::string text = error.what();
    if (text.find(std::generic_category().message(EAGAIN)) != std::string::npos)
    {
      vtkErrorWithObjectMacro(
        self, << crossfield::OutOfThreads); // TBB has no type of its own for it
      return vtkCrossFieldErrorCodes::BadInput;
    }
    vtkErrorWithObjectMacro(self, << "The computation broke down ("
                                  << text.substr(0, text.find('\n'))
                                  << "); simplify the domain, or report it with this message.");
    return vtkCrossFieldErrorCodes::BadInput;
  }
}

/**
 * Whether the filter is in ParaView, which goes on drawing what it had when RequestData returns 0, and
 * says a second time, at length, that it did. There a failed filter has an empty output that counts.
 */
inline bool IsInParaView(vtkAlgorithm* self)
{
  return self->GetExecutive()->IsA("vtkPVCompositeDataPipeline") != 0;
}

/** Whether one of the filters above has failed, and has said why. */
inline bool HasFailedAbove(vtkAlgorithm* self)
{
  for (int port = 0; port < self->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < self->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* above = self->GetInputAlgorithm(port, i);
      if (above != nullptr &&
        (above->GetErrorCode() != vtkErrorCode::NoError || HasFailedAbove(above)))
      {
        return true;
      }
    }
  }
  return false;
}

/**
 * RequestData of a source: runs work(progress), publishes the error code and returns 0 after an error; in
 * ParaView 1, where a filter below one that has failed does nothing and has an error code, too.
 */
template <class Algorithm, class Work>
int Run(Algorithm* self, unsigned long& errorCode, Work work)
{
  const bool inParaView = IsInParaView(self);
  if (inParaView && HasFailedAbove(self))
  {
    errorCode = vtkCrossFieldErrorCodes::BadInput;
    return 1;
  }
  errorCode = Try(self, work);
  return errorCode == vtkErrorCode::NoError || inParaView ? 1 : 0;
}

/** The same for a filter; without cells in the input there is nothing to do, and the output is empty. */
template <class Algorithm, class Work>
int Run(Algorithm* self, unsigned long& errorCode, vtkDataSet* input, Work work)
{
  return Run(self, errorCode,
    [&](const crossfield::Progress& progress)
    {
      if (input->GetNumberOfCells() > 0)
      {
        work(progress);
      }
    });
}

/** The same, and tell(sentence) of why there is no output; where a filter above has said that, of where to look for it. */
template <class Algorithm, class Work, class Tell>
int Run(Algorithm* self, unsigned long& errorCode, vtkDataSet* input, Work work, Tell tell)
{
  bool isTold = false;
  const int result = Run(self, errorCode, input,
    [&](const crossfield::Progress& progress)
    {
      try
      {
        work(progress);
      }
      catch (const crossfield::Error& error)
      {
        isTold = true;
        tell(error.what());
        throw;
      }
    });
  if (errorCode != vtkErrorCode::NoError && !isTold)
  {
    tell(HasFailedAbove(self) ? "A filter above has failed, and has said why."
                              : "The computation has failed; a message says why.");
  }
  return result;
}
}

#endif
