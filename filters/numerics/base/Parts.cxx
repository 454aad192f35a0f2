#include "Parts.h"

#include "PartsTrace.h"
#include "ThreadLimit.h"

#include <omp.h>
#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <exception>
#include <optional>

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CROSSFIELD_THREAD_SANITIZER 1
#include <sanitizer/tsan_interface.h>
#endif
#endif

namespace crossfield
{
namespace
{
/// Tells the thread sanitizer that what precedes Release precedes what follows Acquire. It cannot
/// see how TBB orders threads, because that is in a library.
class Order
{
#ifdef CROSSFIELD_THREAD_SANITIZER
public:
  void Release()
  {
    __tsan_release(&this->Key);
  }
  void Acquire()
  {
    __tsan_acquire(&this->Key);
  }

private:
  char Key = 0;
#else
public:
  void Release() {}
  void Acquire() {}
#endif
};

/// Marks the calling thread as one of those that run the parts of a computation.
class InsideParts
{
public:
  InsideParts() { ++Depth; }
  ~InsideParts() { --Depth; }
  InsideParts(const InsideParts&) = delete;
  InsideParts& operator=(const InsideParts&) = delete;

  static bool Here() { return Depth > 0; }

private:
  static thread_local int Depth;
};

thread_local int InsideParts::Depth = 0;

/// Calls function(0), …, function(parts − 1), which must not throw, in the threads of the present
/// arena. While a thread waits for others, it takes parts of this loop only: those of another loop
/// might wait for something that this thread holds.
void RunParts(std::size_t parts, const std::function<void(std::size_t)>& function)
{
  Order begin;
  Order end;
  begin.Release();
  tbb::this_task_arena::isolate(
    [&]
    {
      tbb::parallel_for(
        std::size_t{ 0 }, parts,
        [&](std::size_t part)
        {
          begin.Acquire();
          const InsideParts inside;
          function(part);
          end.Release();
        },
        tbb::simple_partitioner());
    });
  end.Acquire();
}

/// Calls a function, which must not throw, in the calling thread as the first of several. TBB makes
/// as many threads as there are processors, unless it is told to make more.
void RunWithThreads(int threads, const std::function<void()>& function)
{
  std::optional<tbb::global_control> more;
  if (threads > tbb::info::default_concurrency())
  {
    more.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  }
  tbb::task_arena arena(threads);
  arena.execute(
    [&]
    {
      const InsideParts inside;
      function();
    });
}

}

int ThreadsOfParts()
{
  if (const PartsTrace* const trace = PartsTrace::Active())
  {
    return trace->Processors();
  }
  if (InsideParts::Here())
  {
    return tbb::this_task_arena::max_concurrency();
  }
  return omp_in_parallel() != 0 ? 1 : StartableThreads(ThreadLimit());
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
  else if (InsideParts::Here())
  {
    RunParts(parts, attempt);
  }
  else if (const int threads = ThreadsOfParts(); threads > 1)
  {
    RunWithThreads(std::min(threads, static_cast<int>(parts)), [&] { RunParts(parts, attempt); });
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
  const int threads = ThreadsOfParts();
  if (PartsTrace::Active() != nullptr || InsideParts::Here() || threads == 1)
  {
    function();
    return;
  }
  std::exception_ptr failure;
  RunWithThreads(threads,
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
