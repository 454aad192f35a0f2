#include "vtkCrossFieldParts.h"

#include "Parts.h"

namespace vtkCrossFieldParts
{
void Run(std::size_t parts, const std::function<void(std::size_t)>& function)
{
  crossfield::ForParts(parts, function);
}
}
