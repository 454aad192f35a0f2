#include "InterruptGuard.h"

#include <atomic>
#include <csignal>
#include <unistd.h>
#include <utility>

namespace
{
// The handler runs in any thread, so blocking signals in the thread that writes is not enough.
enum State
{
  Idle,
  Guarded, // a guard exists
  Ending   // a handler removes files
};
std::atomic<int> Current{ Idle };
std::atomic<int> Waiting{ 0 };
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler must not wait for a lock");

int Depth = 0; // number of nested guards, all in the thread that writes
std::vector<std::string> Files;
std::vector<std::string> Folders;

extern "C" void RemoveAndEnd(int number)
{
  int expected = Idle;
  if (!Current.compare_exchange_strong(expected, Ending))
  {
    Waiting = number;
    return;
  }
  // unlink, rmdir, signal and raise are allowed in handlers; reading the strings allocates nothing.
  for (const std::string& file : Files)
  {
    unlink(file.c_str());
  }
  for (auto folder = Folders.rbegin(); folder != Folders.rend(); ++folder)
  {
    rmdir(folder->c_str());
  }
  std::signal(number, SIG_DFL);
  raise(number);
}
}

InterruptGuard::InterruptGuard()
{
  if (Depth++ > 0)
  {
    return;
  }
  int expected = Idle;
  while (!Current.compare_exchange_strong(expected, Guarded))
  {
    pause(); // another thread ends the program
    expected = Idle;
  }
}

InterruptGuard::~InterruptGuard()
{
  if (--Depth > 0)
  {
    return;
  }
  Current = Idle;
  if (const int number = Waiting.exchange(0))
  {
    raise(number);
  }
}

void InterruptGuard::Install()
{
  for (const int number : { SIGINT, SIGTERM, SIGHUP, SIGPIPE })
  {
    struct sigaction now = {};
    // An ignored signal stays ignored, as nohup wants it. Libraries catch some: UCX of Open MPI SIGHUP, for its log.
    if (sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_IGN)
    {
      std::signal(number, RemoveAndEnd);
    }
  }
  std::signal(SIGXFSZ, SIG_IGN); // then writing beyond a limit is an error, like a full disk
}

void InterruptGuard::RemoveOnSignal(
  std::vector<std::string> files, std::vector<std::string> folders)
{
  Files = std::move(files);
  Folders = std::move(folders);
}
