#include "Parts.h"

#include "PartsTrace.h"
#include "ThreadLimit.h"

#include <omp.h>

#include <algorithm>
#include <condition_variable>
#include <exception>
#include <mutex>

namespace crossfield
{
namespace
{
/// Threads of a parallel region of OpenMP, which take parts of all loops that the region runs, also
/// of loops inside of parts. The tasks of OpenMP would do the same, but those of LLVM 14 fail when
/// several threads of the host start regions and end.
class Team
{
public:
  /// The team of the calling thread, or null.
  static thread_local Team* Present;

  /// Calls a function for all parts, and returns when all have finished. Must be called in a thread
  /// of the team. While a thread waits, it takes parts of its own loop only: another loop might wait
  /// for something that this thread holds.
  void Run(std::size_t parts, const std::function<void(std::size_t)>& function)
  {
    Loop loop{ function, parts };
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Open.push_back(&loop);
    this->Changed.notify_all();
    while (loop.next < parts)
    {
      this->RunNext(loop, lock);
    }
    loop.ended.wait(lock, [&loop] { return loop.finished == loop.parts; });
  }

  /// Takes parts of the loops of other threads until End is called, of the outermost loops first.
  void Help()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    for (;;)
    {
      this->Changed.wait(lock, [this] { return this->HasEnded || !this->Open.empty(); });
      if (this->Open.empty())
      {
        return;
      }
      Loop& loop = *this->Open.front();
      this->RunNext(loop, lock);
      if (loop.finished == loop.parts)
      {
        loop.ended.notify_one(); // its thread cannot continue before this one releases the lock
      }
    }
  }

  /// Lets the other threads leave.
  void End()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->HasEnded = true;
    this->Changed.notify_all();
  }

private:
  struct Loop
  {
    const std::function<void(std::size_t)>& function;
    std::size_t parts;
    std::size_t next = 0;
    std::size_t finished = 0;
    std::condition_variable ended{};
  };

  /// Runs the next part of a loop without the lock.
  void RunNext(Loop& loop, std::unique_lock<std::mutex>& lock)
  {
    const std::size_t part = loop.next++;
    if (loop.next == loop.parts)
    {
      this->Open.erase(std::find(this->Open.begin(), this->Open.end(), &loop));
    }
    lock.unlock();
    loop.function(part);
    lock.lock();
    ++loop.finished;
  }

  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<Loop*> Open; ///< Loops with parts that no thread has taken.
  bool HasEnded = false;
};

thread_local Team* Team::Present = nullptr;

/// Calls a function, which must not throw, in the calling thread as the first of a team.
void RunInTeam(int threads, const std::function<void()>& function)
{
  Team team;
#pragma omp parallel num_threads(threads)
  {
    Team::Present = &team;
    if (omp_get_thread_num() == 0)
    {
      function();
      team.End();
    }
    else
    {
      team.Help();
    }
    Team::Present = nullptr;
  }
}

int TeamSize(std::size_t parts)
{
  return static_cast<int>(std::min(parts, static_cast<std::size_t>(ThreadLimit())));
}
}

void ForParts(std::size_t parts, const std::function<void(std::size_t)>& function)
{
  if (parts == 0)
  {
    return;
  }
  if (parts == 1)
  {
    function(0);
    return;
  }
  std::vector<std::exception_ptr> failures(parts);
  const std::function<void(std::size_t)> attempt = [&](std::size_t part)
  {
    try
    {
      function(part);
    }
    catch (...)
    {
      failures[part] = std::current_exception();
    }
  };
  if (PartsTrace* const trace = PartsTrace::Active())
  {
    trace->Run(parts, attempt);
  }
  else if (Team* const team = Team::Present)
  {
    team->Run(parts, attempt);
  }
  else if (const int threads = TeamSize(parts); threads > 1 && omp_in_parallel() == 0)
  {
    RunInTeam(threads, [&] { Team::Present->Run(parts, attempt); });
  }
  else
  {
    for (std::size_t part = 0; part < parts; ++part)
    {
      attempt(part);
    }
  }
  for (const std::exception_ptr& failure : failures)
  {
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }
}

void WithAllThreads(const std::function<void()>& function)
{
  const int threads = TeamSize(MaximumPartCount);
  if (PartsTrace::Active() != nullptr || Team::Present != nullptr || threads == 1 ||
    omp_in_parallel() != 0)
  {
    function();
    return;
  }
  std::exception_ptr failure;
  RunInTeam(threads,
    [&]
    {
      try
      {
        function();
      }
      catch (...)
      {
        failure = std::current_exception();
      }
    });
  if (failure)
  {
    std::rethrow_exception(failure);
  }
}
}
