#include "PipelineRun.h"

#include "vtkCrossFieldErrorCodes.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{
/** Stores the first error message and all warnings instead of printing them. */
class ErrorCatcher : public vtkOutputWindow
{
public:
  static ErrorCatcher* New();
  vtkTypeMacro(ErrorCatcher, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    // The executive reports once more that an algorithm failed; a few readers only warn. VTK's
    // arrays report what they cannot allocate before they throw std::bad_alloc. Names in a file may contain
    // such words too, but no message of ours begins with them.
    const std::string sentence = Sentence(text);
    const bool repetition = (sentence.rfind("Algorithm ", 0) == 0 &&
                              sentence.find("returned failure for request") != std::string::npos) ||
      sentence.rfind("Unable to allocate", 0) == 0;
    this->Failed = true;
    if (this->First.empty() && !repetition)
    {
      this->First = sentence;
    }
  }
  void DisplayWarningText(const char* text) override { this->Warnings.push_back(Sentence(text)); }
  /** Stores an error of a function without an object, such as one that parses numbers. */
  void DisplayGenericWarningText(const char* text) override { this->DisplayErrorText(text); }

  bool Failed = false;
  std::string First;
  std::vector<std::string> Warnings;

private:
  /**
   * Returns the sentence in a message of VTK, "ERROR: In FILE, line N\nvtkClass (0x…):
   * sentence\n\n", in one line. Messages without an object have no class.
   */
  static std::string Sentence(const std::string& text)
  {
    const auto end = text.find("): ");
    const auto head = text.find(", line ");
    const auto begin = end != std::string::npos ? end + 2
      : head != std::string::npos               ? text.find('\n', head)
                                                : 0;
    std::istringstream words(text.substr(std::min(begin, text.size())));
    std::string sentence;
    for (std::string word; words >> word;)
    {
      sentence += (sentence.empty() ? "" : " ") + word;
    }
    return sentence;
  }
};
vtkStandardNewMacro(ErrorCatcher);

void ShowProgress(vtkObject* caller, unsigned long, void* what, void*)
{
  const double fraction = static_cast<vtkAlgorithm*>(caller)->GetProgress();
  std::fprintf(stderr, "\r%-12s %3.0f %%", static_cast<const char*>(what), 100.0 * fraction);
  std::fflush(stderr);
}
}

namespace PipelineRun
{
void RequireNoError(void (*work)(void*), void* data)
{
  const vtkSmartPointer<vtkOutputWindow> previous = vtkOutputWindow::GetInstance();
  vtkNew<ErrorCatcher> catcher;
  vtkOutputWindow::SetInstance(catcher);
  try
  {
    work(data);
  }
  catch (...)
  {
    vtkOutputWindow::SetInstance(previous);
    throw;
  }
  vtkOutputWindow::SetInstance(previous);
  if (catcher->Failed)
  {
    const auto& warnings = catcher->Warnings;
    throw Error(!catcher->First.empty() ? catcher->First
        : !warnings.empty()             ? warnings.front()
                                        : "VTK reports no cause");
  }
  for (const std::string& warning : catcher->Warnings)
  {
    std::cerr << "Warning: " << warning << "\n";
  }
}

void Update(vtkAlgorithm* filter, const char* what)
{
  unsigned long observer = 0;
  if (isatty(STDERR_FILENO) != 0)
  {
    vtkNew<vtkCallbackCommand> command;
    command->SetCallback(ShowProgress);
    command->SetClientData(const_cast<char*>(what));
    observer = filter->AddObserver(vtkCommand::ProgressEvent, command);
  }
  try
  {
    RequireNoError([filter] { filter->Update(); });
  }
  catch (const Error& error)
  {
    throw filter->GetErrorCode() == vtkCrossFieldErrorCodes::Inconsistent
      ? Error(error.what(), AnswerIsNo)
      : error;
  }
  if (observer != 0)
  {
    filter->RemoveObserver(observer);
    std::fputs("\r                    \r", stderr);
  }
}
}
