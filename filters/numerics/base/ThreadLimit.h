#pragma once

#include "ControlGroups.h"

namespace crossfield
{
/// Returns the number of threads that computations may use, at least 1. It changes the time of a
/// computation, never its result (Parts.h).
///
/// A number that the user has set counts as it is: OMP_NUM_THREADS, or omp_set_num_threads in the
/// host. Without one it is the number of processors to which this process is bound (affinity), and
/// at most ProcessorQuota. In both cases it is at most OMP_THREAD_LIMIT, and at most the number of every
/// WithThreadLimit around the call. Under a limit on the address space (`ulimit -v`) it is 1, because
/// every thread reserves addresses: its stack, and a buffer of OpenBLAS.
int ThreadLimit();

/// Returns how many threads can run at once, at most `wanted` and at least 1. Starts them if so many
/// have not been started before, because the system may deny threads that no limit announces
/// (`ulimit -u`, pids.max of control groups), and TBB ends the program then.
int StartableThreads(int wanted);

/// Scope in which computations that this thread starts use at most the given number of threads.
class WithThreadLimit
{
public:
  explicit WithThreadLimit(int threads);
  ~WithThreadLimit();
  WithThreadLimit(const WithThreadLimit&) = delete;
  WithThreadLimit& operator=(const WithThreadLimit&) = delete;

private:
  int Before;
};

/// Returns the number of processors that the control groups of this process (containers) may use
/// on average, rounded up; 0 if it is not limited. Reads `cpu.max` of version 2, and
/// `cpu.cfs_quota_us` and `cpu.cfs_period_us` of version 1.
int ProcessorQuota(const SystemFiles& files = {});
}
