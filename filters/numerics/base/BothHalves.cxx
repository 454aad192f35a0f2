#include "BothHalves.h"

#include <omp.h>

#include <algorithm>
#include <array>
#include <exception>
#include <thread>

namespace crossfield
{
void ForBothHalves(bool parallel, const std::function<void(std::size_t)>& function)
{
  std::array<std::exception_ptr, 2> failures;
  const auto attempt = [&](std::size_t half)
  {
    try
    {
      function(half);
    }
    catch (...)
    {
      failures[half] = std::current_exception();
    }
  };
  if (parallel && std::min(omp_get_max_threads(), omp_get_thread_limit()) > 1)
  {
    std::thread second(attempt, 1);
    attempt(0);
    second.join();
  }
  else
  {
    attempt(0);
    attempt(1);
  }
  for (const std::exception_ptr& failure : failures)
  {
    if (failure)
    {
      std::rethrow_exception(failure);
    }
  }
}
}
