#ifndef PipelineRun_h
#define PipelineRun_h

#include "CommandLine.h" // for the exit statuses

#include <stdexcept>
#include <string>

class vtkAlgorithm;

/** Updates the filters of a pipeline, and turns what VTK reports as an error into an exception. */
namespace PipelineRun
{
/** One sentence that names cause and mend, which the program prints, and its exit status. */
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
 * Updates a filter and all above it; throws the first error sentence that any of them
 * reported, with status AnswerIsNo if the configuration is inconsistent.
 * On a terminal it keeps a progress line on standard error.
 */
void Update(vtkAlgorithm* filter, const char* what);

/** Runs work() and throws the first error that VTK reported meanwhile. */
void RequireNoError(void (*work)(void*), void* data);
template <class Work>
void RequireNoError(Work work)
{
  RequireNoError([](void* data) { (*static_cast<Work*>(data))(); }, &work);
}
}

#endif
