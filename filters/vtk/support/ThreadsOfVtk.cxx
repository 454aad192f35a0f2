#include "ThreadsOfVtk.h"

#include "vtkSMP.h"
#include "vtkSMPTools.h"

#include <cstdlib>
#include <limits>
#include <string>

int ThreadsOfVtk()
{
  if (vtkSMPTools::IsParallelScope())
  {
    return 1;
  }
  const bool isSequential = std::string(vtkSMPTools::GetBackend()) == "Sequential";
  const bool isBuiltSequential = VTK_SMP_DEFAULT_IMPLEMENTATION_SEQUENTIAL != 0;
  if (!isSequential || !isBuiltSequential || std::getenv("VTK_SMP_BACKEND_IN_USE") != nullptr)
  {
    return vtkSMPTools::GetEstimatedNumberOfThreads();
  }
  const char* const maximum = std::getenv("VTK_SMP_MAX_THREADS");
  const int threads = maximum != nullptr ? std::atoi(maximum) : 0;
  return threads > 0 ? threads : std::numeric_limits<int>::max();
}
