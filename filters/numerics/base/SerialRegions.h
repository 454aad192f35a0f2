#pragma once

namespace crossfield
{
/// Scope guard that makes OpenMP parallel regions opened by this thread run with a single thread.
///
/// CHOLMOD requests four threads in every small loop, whatever the value of OMP_NUM_THREADS, and on
/// fewer processors these wait for each other. With OMP_NUM_THREADS=1, where no parallel region of
/// this library encloses the loops, a run of one second took minutes.
class SerialRegions
{
public:
  SerialRegions();
  ~SerialRegions();
  SerialRegions(const SerialRegions&) = delete;
  SerialRegions& operator=(const SerialRegions&) = delete;

private:
  int SavedLevels;
};
}
