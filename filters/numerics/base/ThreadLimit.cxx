#include "ThreadLimit.h"

#include <omp.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#if __has_include(<sys/resource.h>)
#include <sys/resource.h>
#endif

namespace crossfield
{
namespace
{
thread_local int LimitOfScopes = std::numeric_limits<int>::max();

bool HasAddressLimit()
{
#ifdef RLIMIT_AS
  rlimit limit = {};
  return getrlimit(RLIMIT_AS, &limit) == 0 && limit.rlim_cur != RLIM_INFINITY;
#else
  return false;
#endif
}
}

int ThreadLimit()
{
  static const int quota = ProcessorQuota();
  static const bool hasAddressLimit = HasAddressLimit();
  int threads = omp_get_max_threads();
  if (quota > 0 && threads == omp_get_num_procs()) // the default
  {
    threads = std::min(threads, quota);
  }
  threads = std::min({ threads, omp_get_thread_limit(), LimitOfScopes });
  return hasAddressLimit ? 1 : std::max(1, threads);
}

int StartableThreads(int wanted)
{
  static std::mutex mutex;
  static int most = 1;
  static bool isDenied = false;
  const std::lock_guard<std::mutex> lock(mutex);
  if (wanted > most && !isDenied)
  {
    std::mutex begin; // the threads wait for each other
    std::unique_lock<std::mutex> wait(begin);
    std::vector<std::thread> threads;
    try
    {
      for (int i = 1; i < wanted; ++i)
      {
        threads.emplace_back([&begin] { const std::lock_guard<std::mutex> begun(begin); });
      }
    }
    catch (const std::system_error&)
    {
      isDenied = true;
    }
    wait.unlock();
    for (std::thread& thread : threads)
    {
      thread.join();
    }
    most = std::max(most, 1 + static_cast<int>(threads.size()));
  }
  return std::min(wanted, most);
}

WithThreadLimit::WithThreadLimit(int threads)
  : Before(LimitOfScopes)
{
  LimitOfScopes = std::min(LimitOfScopes, threads);
}

WithThreadLimit::~WithThreadLimit()
{
  LimitOfScopes = this->Before;
}

int ProcessorQuota(const SystemFiles& files)
{
  double minimum = 0.0;
  const auto lower = [&minimum](double quota, double period)
  {
    if (quota > 0.0 && period > 0.0)
    {
      minimum = minimum > 0.0 ? std::min(minimum, quota / period) : quota / period;
    }
  };
  ForControlGroups(files, "cpu",
    [&lower](const std::string& folder, int version)
    {
      double quota = 0.0;
      double period = 0.0;
      if (version == 2)
      {
        std::ifstream stream(folder + "/cpu.max"); // "max 100000" without a limit
        if (stream >> quota >> period)
        {
          lower(quota, period);
        }
      }
      else // −1 without a limit
      {
        lower(ReadNumber(folder + "/cpu.cfs_quota_us").value_or(0.0),
          ReadNumber(folder + "/cpu.cfs_period_us").value_or(0.0));
      }
    });
  return static_cast<int>(std::ceil(minimum));
}
}
