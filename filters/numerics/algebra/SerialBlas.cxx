#include "SerialBlas.h"

#include <mutex>

// OpenBLAS's own interface; its header cannot be included together with another cblas.h.
extern "C"
{
  int openblas_get_num_threads(void);
  void openblas_set_num_threads(int count);
}

namespace crossfield
{
namespace
{
std::mutex Mutex;
int Users = 0;
int ThreadsBefore = 1;
}

SerialBlas::SerialBlas()
{
  const std::lock_guard<std::mutex> lock(Mutex);
  if (Users++ == 0)
  {
    ThreadsBefore = openblas_get_num_threads();
    openblas_set_num_threads(1);
  }
}

SerialBlas::~SerialBlas()
{
  const std::lock_guard<std::mutex> lock(Mutex);
  if (--Users == 0)
  {
    openblas_set_num_threads(ThreadsBefore);
  }
}
}
