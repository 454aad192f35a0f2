#ifndef PipelineRun_h
#define PipelineRun_h

#include "CommandLine.h" // for the exit statuses

#include <stdexcept>
#include <string>

class vtkAlgorithm;

/** Updates the filters of a pipeline, and throws the errors that VTK reports. */
namespace PipelineRun
{
/** Error with one sentence that names cause, place and remedy, and the exit status of the program.
 */
class Error : public std::runtime_error
{
public:
  explicit Error(const std::string& sentence, ExitStatus status = BadInput)
    : std::runtime_error(sentence)
    , Status(status)
  {
  }
  ExitStatus GetStatus() const { return this->Status; }

private:
  ExitStatus Status;
};

/**
 * Updates a filter and those upstream; throws the first error that one of them reports, with status
 * AnswerIsNo if the configuration is inconsistent. On a terminal it shows a progress line on
 * standard error, which begins with `what`.
 */
void Update(vtkAlgorithm* filter, const char* what);

/** Runs work() and throws the first error that VTK reports during it. */
void RequireNoError(void (*work)(void*), void* data);
template <class Work>
void RequireNoError(Work work)
{
  RequireNoError([](void* data) { (*static_cast<Work*>(data))(); }, &work);
}
}

#endif
