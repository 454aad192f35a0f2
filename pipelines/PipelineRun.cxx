#include "PipelineRun.h"

#include "vtkPerforatedCrossField.h"

#include "vtkAlgorithm.h"
#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <cstdio>
#include <iostream>
#include <string>
#include <unistd.h>
#include <vector>

namespace
{
/** Keeps the first error message instead of printing it; warnings go to standard error. */
class ErrorCatcher : public vtkOutputWindow
{
public:
  static ErrorCatcher* New();
  vtkTypeMacro(ErrorCatcher, vtkOutputWindow);

  void DisplayErrorText(const char* text) override
  {
    // The executive repeats that an algorithm failed; a few readers leave it at a warning.
    // VTK's arrays say what they cannot allocate before they throw std::bad_alloc.
    const bool repetition =
      std::string(text).find("returned failure for request") != std::string::npos ||
      std::string(text).find("Unable to allocate") != std::string::npos;
    this->Failed = true;
    if (this->First.empty() && !repetition)
    {
      this->First = Sentence(text);
    }
  }
  void DisplayWarningText(const char* text) override { this->Warnings.push_back(Sentence(text)); }
  void DisplayGenericWarningText(const char* text) override { this->DisplayWarningText(text); }

  bool Failed = false;
  std::string First;
  std::vector<std::string> Warnings;

private:
  /** VTK writes "ERROR: In FILE, line N\nvtkClass (0x…): sentence\n\n". */
  static std::string Sentence(std::string text)
  {
    const auto begin = text.find("): ");
    text = begin == std::string::npos ? text : text.substr(begin + 3);
    text.erase(text.find_last_not_of(" \n") + 1);
    return text;
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
                                        : "VTK does not say why");
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
    throw filter->GetErrorCode() == vtkPerforatedCrossField::InconsistentError
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
