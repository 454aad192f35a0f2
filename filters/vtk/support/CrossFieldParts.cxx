#include "vtkCrossFieldParts.h"

#include "Parts.h"
#include "ThreadLimit.h"
#include "ThreadsOfVtk.h"

namespace vtkCrossFieldParts
{
void Run(std::size_t parts, const std::function<void(std::size_t)>& function)
{
  const crossfield::WithThreadLimit threads(ThreadsOfVtk());
  crossfield::ForParts(parts, function);
}
}
