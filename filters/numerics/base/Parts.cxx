#include "Parts.h"

#include "PartsTrace.h"
#include "ThreadLimit.h"

#include <omp.h>

#include <exception>

namespace crossfield
{
namespace
{
/// Whether this thread belongs to a team that was started below.
thread_local bool isInTeam = false;

/// Marks the calling thread as a member of a team.
class TeamMember
{
public:
  TeamMember() { isInTeam = true; }
  ~TeamMember() { isInTeam = false; }
  TeamMember(const TeamMember&) = delete;
  TeamMember& operator=(const TeamMember&) = delete;
};

/// Calls a function, which must not throw, in the calling thread as the master of a team. The other
/// threads wait for tasks.
void RunInTeam(int threads, const std::function<void()>& function)
{
#pragma omp parallel num_threads(threads)
  {
    const TeamMember member;
#pragma omp master
    function();
  }
}

/// Calls a function for all parts as tasks of the present team.
void RunTasks(std::size_t parts, const std::function<void(std::size_t)>& function)
{
#pragma omp taskgroup
  {
    for (std::size_t part = 1; part < parts; ++part)
    {
#pragma omp task firstprivate(part) shared(function)
      function(part);
    }
    function(0);
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
  else if (isInTeam)
  {
    RunTasks(parts, attempt);
  }
  else if (const int threads = TeamSize(parts); threads > 1 && omp_in_parallel() == 0)
  {
    RunInTeam(threads, [&] { RunTasks(parts, attempt); });
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
  if (PartsTrace::Active() != nullptr || isInTeam || threads == 1 || omp_in_parallel() != 0)
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
