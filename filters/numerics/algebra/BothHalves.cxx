#include "BothHalves.h"

#include <omp.h>

#include <algorithm>
#include <array>
#include <exception>

namespace crossfield
{
void ForBothHalves(bool parallel, const std::function<void(std::size_t)>& function)
{
  std::array<std::exception_ptr, 2> failures;
  const int threads = parallel ? std::min(2, omp_get_max_threads()) : 1;
#pragma omp parallel for num_threads(threads) schedule(static, 1)
  for (int half = 0; half < 2; ++half)
  {
    try
    {
      function(static_cast<std::size_t>(half));
    }
    catch (...)
    {
      failures[static_cast<std::size_t>(half)] = std::current_exception();
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
}
