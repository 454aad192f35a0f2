#include "CellOutline.h"

#include <cmath>

namespace
{
/** Orders of the nodes of a cell with `corners` corners and `between` nodes on each edge. */
std::vector<vtkIdType> Around(vtkIdType corners, vtkIdType between, bool reversesLastEdges)
{
  std::vector<vtkIdType> order;
  for (vtkIdType edge = 0; edge < corners; ++edge)
  {
    order.push_back(edge);
    for (vtkIdType i = 0; i < between; ++i)
    {
      // Nodes of Lagrange quadrilaterals are numbered by increasing coordinates on all edges.
      const vtkIdType along = reversesLastEdges && edge > 1 ? between - 1 - i : i;
      order.push_back(corners + edge * between + along);
    }
  }
  return order;
}

/** Returns the numbers of the nodes along a line or around a cell in order; none for other types. */
std::vector<vtkIdType> OrderOf(int type, vtkIdType count)
{
  switch (type)
  {
  case VTK_QUADRATIC_EDGE:
  case VTK_CUBIC_LINE:
  case VTK_LAGRANGE_CURVE:
  {
    std::vector<vtkIdType> order = { 0 };
    for (vtkIdType i = 2; i < count; ++i)
    {
      order.push_back(i);
    }
    order.push_back(1);
    return order;
  }
  case VTK_QUADRATIC_TRIANGLE:
  case VTK_BIQUADRATIC_TRIANGLE:
    return Around(3, 1, false);
  case VTK_QUADRATIC_QUAD:
  case VTK_BIQUADRATIC_QUAD:
    return Around(4, 1, false);
  case VTK_LAGRANGE_TRIANGLE: // (p + 1)(p + 2) / 2 nodes
    return Around(
      3, std::lround(0.5 * (std::sqrt(8.0 * static_cast<double>(count) + 1.0) - 3.0)) - 1, false);
  case VTK_LAGRANGE_QUADRILATERAL: // (p + 1)² nodes
    return Around(4, std::lround(std::sqrt(static_cast<double>(count))) - 2, true);
  default:
    return {};
  }
}
}

namespace CellOutline
{
//------------------------------------------------------------------------------
Outline Of(int type, const CellLoop::Points& points)
{
  Outline outline;
  const std::vector<vtkIdType> order = OrderOf(type, points.Size());
  const bool isLine =
    type == VTK_QUADRATIC_EDGE || type == VTK_CUBIC_LINE || type == VTK_LAGRANGE_CURVE;
  outline.type = isLine ? VTK_POLY_LINE : VTK_POLYGON;
  for (const vtkIdType i : order)
  {
    if (i >= points.Size()) // other orders along both coordinates
    {
      return {};
    }
    outline.points.push_back(points[i]);
  }
  return outline;
}
}
