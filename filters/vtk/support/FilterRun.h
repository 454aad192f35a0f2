#ifndef FilterRun_h
#define FilterRun_h

#include "Error.h"
#include "MemoryBudget.h"
#include "Progress.h"
#include "ThreadLimit.h"
#include "ThreadsOfVtk.h"
#include "vtkCrossFieldErrorCodes.h"

#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkInformation.h"
#include "vtkInformationStringKey.h"

#include <cerrno>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <system_error>

/**
 * Calls of the numerics from RequestData: progress, abort, errors and the number of threads are
 * handled in one place.
 */
namespace FilterRun
{
// CheckAbort() also checks the algorithms downstream. VTK 9.1 does not have it.
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

// After an abort the executive empties the outputs unless the filter keeps them. VTK 9.1 does not
// empty them.
template <class Algorithm>
auto KeepAbortedOutput(Algorithm* self, int) -> decltype(self->SetAbortOutput(false))
{
  return self->SetAbortOutput(false);
}
template <class Algorithm>
void KeepAbortedOutput(Algorithm*, long)
{
}

/** Result of a computation. */
struct Outcome
{
  unsigned long errorCode = vtkErrorCode::NoError;
  std::string message; ///< Empty without an error.
};

/**
 * Runs work(progress), which reports progress to the filter and its abort flag to the numerics. An
 * error is reported as one vtkErrorMacro sentence; an abort is not an error. In both cases the
 * outputs are unchanged, since `work` fills them last.
 */
template <class Algorithm, class Work>
Outcome Try(Algorithm* self, Work work)
{
  const auto fail =
    [self](const std::string& message, unsigned long errorCode = vtkCrossFieldErrorCodes::BadInput)
  {
    vtkErrorWithObjectMacro(self, << message);
    return Outcome{ errorCode, message };
  };
  const crossfield::Progress progress(
    [self](double fraction)
    {
      self->UpdateProgress(fraction);
      return !WantsAbort(self, 0);
    });
  const crossfield::WithThreadLimit threads(ThreadsOfVtk());
  try
  {
    progress.Report(0.0); // an abort before the work begins
    work(progress);
    return {};
  }
  catch (const crossfield::Aborted&)
  {
    return {};
  }
  catch (const crossfield::Error& error)
  {
    return fail(error.what(),
      error.GetKind() == crossfield::Error::Kind::Inconsistent
        ? vtkCrossFieldErrorCodes::Inconsistent
        : vtkCrossFieldErrorCodes::BadInput);
  }
  catch (const std::bad_alloc&)
  {
    return fail(crossfield::OutOfMemory);
  }
  catch (const std::exception& error) // from a library; may have several lines
  {
    const std::string text = error.what();
    if (text.find(std::generic_category().message(EAGAIN)) != std::string::npos)
    {
      return fail(crossfield::OutOfThreads); // TBB has no exception type for this error
    }
    return fail("The computation broke down (" + text.substr(0, text.find('\n')) +
      "); simplify the domain, or report it with this message.");
  }
}

/**
 * Returns whether the filter runs in ParaView. If RequestData returns 0 there, ParaView continues
 * to draw the old output and prints a long second message, so a failed filter returns 1 with an
 * empty output.
 */
inline bool IsInParaView(vtkAlgorithm* self)
{
  return self->GetExecutive()->IsA("vtkPVCompositeDataPipeline") != 0;
}

/** Returns the key under which the information of a failed filter holds its error message. */
inline vtkInformationStringKey* MessageKey()
{
  static vtkInformationStringKey* const key =
    vtkInformationStringKey::MakeKey("CROSS_FIELD_ERROR", "FilterRun");
  return key;
}

/** Returns the message of the nearest failed filter upstream, or nothing if none has failed. */
inline std::optional<std::string> UpstreamFailure(vtkAlgorithm* self)
{
  for (int port = 0; port < self->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < self->GetNumberOfInputConnections(port); ++i)
    {
      vtkAlgorithm* upstream = self->GetInputAlgorithm(port, i);
      if (upstream == nullptr)
      {
        continue;
      }
      if (upstream->GetErrorCode() != vtkErrorCode::NoError)
      {
        const char* message = upstream->GetInformation()->Get(MessageKey());
        return message != nullptr
          ? message
          : std::string(upstream->GetClassName()) + " has failed; correct its input or parameters.";
      }
      if (std::optional<std::string> message = UpstreamFailure(upstream))
      {
        return message;
      }
    }
  }
  return std::nullopt;
}

/**
 * Runs work(progress), sets the error code, and returns the result of RequestData: 0 after an
 * error. In ParaView it returns 1, and a filter downstream of a failed filter does nothing and has
 * an error code as well. After an error calls report(message), with the message of the failed
 * filter.
 */
template <class Algorithm, class Work, class Report>
int RunAndReport(Algorithm* self, unsigned long& errorCode, Work work, Report report)
{
  const bool inParaView = IsInParaView(self);
  const std::optional<std::string> upstream =
    inParaView ? UpstreamFailure(self) : std::optional<std::string>();
  const Outcome outcome =
    upstream ? Outcome{ vtkCrossFieldErrorCodes::BadInput, *upstream } : Try(self, work);
  errorCode = outcome.errorCode;
  self->GetInformation()->Remove(MessageKey());
  if (errorCode != vtkErrorCode::NoError)
  {
    self->GetInformation()->Set(MessageKey(), outcome.message);
    report(outcome.message.c_str());
  }
  return errorCode == vtkErrorCode::NoError || inParaView ? 1 : 0;
}

/** Runs RequestData of a source. */
template <class Algorithm, class Work>
int Run(Algorithm* self, unsigned long& errorCode, Work work)
{
  return RunAndReport(self, errorCode, work, [](const char*) {});
}

/** Runs RequestData of a filter with a report. An input without cells gives empty outputs. */
template <class Algorithm, class Work, class Report>
int Run(Algorithm* self, unsigned long& errorCode, vtkDataSet* input, Work work, Report report)
{
  return RunAndReport(
    self, errorCode,
    [&](const crossfield::Progress& progress)
    {
      if (input->GetNumberOfCells() > 0)
      {
        work(progress);
      }
    },
    report);
}

/** Runs RequestData of a filter without a report. */
template <class Algorithm, class Work>
int Run(Algorithm* self, unsigned long& errorCode, vtkDataSet* input, Work work)
{
  return Run(self, errorCode, input, work, [](const char*) {});
}
}

#endif
