#ifndef vtkCrossFieldParts_h
#define vtkCrossFieldParts_h

#include "vtkCrossFieldFiltersModule.h" // for the export macro

#include <cstddef>
#include <functional> // for the parameter

#ifndef __VTK_WRAP__ // a function of C++ only
namespace vtkCrossFieldParts
{
/// Calls function(0), ..., function(parts - 1) in as many threads as the filters use (docs/limits.md,
/// Threads). Returns when all have finished. If calls throw, the exception of the first of these parts is rethrown.
VTKCROSSFIELDFILTERS_EXPORT void Run(
  std::size_t parts, const std::function<void(std::size_t)>& function);
}
#endif

#endif
