#include "IsolatedReading.h"

#include "vtkAlgorithm.h"
#include "vtkDataObject.h"
#include "vtkGenericDataObjectReader.h"
#include "vtkGenericDataObjectWriter.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkTrivialProducer.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <fstream>
#include <iostream>
#include <new>
#include <sstream>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

namespace
{
using PipelineRun::Error;

/** Exit status of the child; any other status is a crash. */
enum ChildStatus
{
  Copied = 40, ///< The copy is complete; the text holds warnings.
  Refused,     ///< The text is the error message.
  NoMemory     ///< An allocation failed.
};

/** Unnamed file in memory that parent and child share. */
class MemoryFile
{
public:
  MemoryFile()
    : Descriptor(memfd_create("crossfield", MFD_CLOEXEC))
  {
    if (this->Descriptor < 0)
    {
      throw Error("The system has no memory for the contents of a file; free some.");
    }
  }
  ~MemoryFile() { close(this->Descriptor); }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;

  std::string Path() const { return "/proc/self/fd/" + std::to_string(this->Descriptor); }

private:
  int Descriptor;
};

void Limit(decltype(RLIMIT_CPU) resource, rlim_t value)
{
  rlimit limit{};
  getrlimit(resource, &limit);
  limit.rlim_cur = std::min(limit.rlim_max, value);
  setrlimit(resource, &limit);
}

/** Returns the bytes of data of this process, as RLIMIT_DATA counts them. */
rlim_t DataSize()
{
  std::ifstream statistics("/proc/self/statm");
  rlim_t pages = 0;
  for (int column = 0; column < 6; ++column)
  {
    statistics >> pages;
  }
  return pages * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
}

void LimitChild(const std::string& file)
{
  const rlim_t megabyte = 1 << 20;
  const auto size = static_cast<rlim_t>(vtksys::SystemTools::FileLength(file));
  const auto machine =
    static_cast<rlim_t>(sysconf(_SC_PHYS_PAGES)) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE));
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_CPU, 10 + 10 * (size / megabyte));
  Limit(RLIMIT_DATA, DataSize() + std::min(machine, 1024 * megabyte + 1000 * size));
}

/** Reads the file, writes the copy and the messages, and exits. */
[[noreturn]] void RunChild(const std::string& file, vtkAlgorithm* reader,
  const std::string& copyPath, const std::string& textPath)
{
  // Messages of a crashing reader are dropped; warnings go into the text.
  dup2(open("/dev/null", O_WRONLY), STDERR_FILENO);
  std::ofstream text(textPath);
  std::cerr.rdbuf(text.rdbuf());
  int status = EXIT_FAILURE;
  try
  {
    LimitChild(file);
    vtkSMPTools::SetBackend("Sequential"); // a forked process has none of its parent's threads
    PipelineRun::Update(reader, "reading");
    vtkNew<vtkGenericDataObjectWriter> writer;
    writer->SetInputConnection(reader->GetOutputPort());
    writer->SetFileName(copyPath.c_str());
    writer->SetFileTypeToBinary();
    PipelineRun::Update(writer, "reading");
    status = ChildStatus::Copied;
  }
  catch (const std::bad_alloc&)
  {
    status = ChildStatus::NoMemory;
  }
  catch (const std::exception& error)
  {
    status = ChildStatus::Refused;
    text << error.what();
  }
  text.flush();
  _exit(status); // without destructors and exit handlers, which belong to the parent
}

/** Describes the status that waitpid returns for a child that did not finish. */
std::string DescribeCrash(int status)
{
  const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
  if (signal == SIGXCPU)
  {
    return "its reader takes too long on it";
  }
  return std::string("its reader crashes on it") +
    (signal != 0 ? std::string(": ") + strsignal(signal) : "");
}
}

namespace IsolatedReading
{
vtkSmartPointer<vtkAlgorithm> Read(const std::string& file, vtkAlgorithm* reader)
{
  const MemoryFile copy;
  const MemoryFile text;
  const pid_t child = fork();
  if (child == 0)
  {
    RunChild(file, reader, copy.Path(), text.Path());
  }
  int status = 0;
  while (child > 0 && waitpid(child, &status, 0) < 0 && errno == EINTR)
  {
  }
  if (child < 0)
  {
    throw Crash("the system cannot start a process to read it");
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) < ChildStatus::Copied)
  {
    throw Crash(DescribeCrash(status));
  }
  if (WEXITSTATUS(status) == ChildStatus::NoMemory)
  {
    throw Crash("it needs more memory than is available for a file of its size");
  }
  std::ostringstream words;
  words << std::ifstream(text.Path()).rdbuf();
  if (WEXITSTATUS(status) == ChildStatus::Refused)
  {
    throw Error(words.str());
  }
  std::cerr << words.str();
  auto copyReader = vtkSmartPointer<vtkGenericDataObjectReader>::New();
  copyReader->SetFileName(copy.Path().c_str());
  PipelineRun::Update(copyReader, "reading");
  auto source = vtkSmartPointer<vtkTrivialProducer>::New();
  source->SetOutput(copyReader->GetOutput());
  return source;
}
}
