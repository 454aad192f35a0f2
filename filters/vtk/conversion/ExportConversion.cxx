#include "ExportConversion.h"

#include "Error.h"
#include "HigherOrderConversion.h"
#include "InputCheck.h"
#include "PeriodicConversion.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <map>

namespace names = vtkCrossFieldArrayNames;

namespace
{
using crossfield::Error;
using crossfield::ExportMesh;

/** Returns the order of a quad or line by its type and number of points, 0 for other cells. */
int OrderOf(int type, vtkIdType points)
{
  switch (type)
  {
  case VTK_QUAD:
  case VTK_LINE:
    return 1;
  case VTK_BIQUADRATIC_QUAD:
  case VTK_QUADRATIC_EDGE:
    return 2;
  case VTK_LAGRANGE_QUADRILATERAL:
    return points == 16 ? 3 : 0;
  case VTK_LAGRANGE_CURVE:
    return points == 4 ? 3 : 0;
  default:
    return 0;
  }
}

bool IsLine(int type)
{
  return type == VTK_LINE || type == VTK_QUADRATIC_EDGE || type == VTK_LAGRANGE_CURVE;
}

int SideOf(const std::string& name, std::map<std::string, int>& numbers, ExportMesh& mesh)
{
  const auto [side, isNew] = numbers.emplace(name, static_cast<int>(mesh.sideNames.size()));
  if (isNew)
  {
    mesh.sideNames.push_back(name);
  }
  return side->second;
}
}

namespace ExportConversion
{
//------------------------------------------------------------------------------
ExportMesh ReadMesh(vtkUnstructuredGrid* mesh)
{
  ExportMesh result;
  result.order = 0;
  result.regionNames = { "domain" };
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    InputCheck::RequireFinite(mesh->GetPoint(i), i);
    result.points.emplace_back(mesh->GetPoint(i));
  }
  auto* sides = vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray(names::Side));
  std::map<std::string, int> numbers;
  std::vector<int> lattice; // per node in VTK's order, its position in the lattice
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const int type = mesh->GetCellType(cell);
    mesh->GetCellPoints(cell, ids);
    const int order = OrderOf(type, ids->GetNumberOfIds());
    if (order == 0 || (result.order != 0 && order != result.order))
    {
      throw Error(
        "The mesh has other cells than quads and lines of one order; give the quads of a Quad "
        "Mesher or of Quads To Higher Order.");
    }
    if (result.order == 0)
    {
      result.order = order;
      for (const std::size_t position : HigherOrderConversion::LatticeOrder(order))
      {
        lattice.push_back(static_cast<int>(position));
      }
    }
    if (IsLine(type))
    {
      if (sides == nullptr)
      {
        throw Error(
          "The boundary edges have no cell array Side of strings; give the quads of a Quad Mesher.");
      }
      result.faces.push_back(static_cast<int>(ids->GetId(0)));
      result.faces.push_back(static_cast<int>(ids->GetId(1)));
      result.side.push_back(SideOf(sides->GetValue(cell), numbers, result));
      continue;
    }
    const std::size_t first = result.cells.size();
    result.cells.resize(first + lattice.size());
    for (std::size_t node = 0; node < lattice.size(); ++node)
    {
      result.cells[first + static_cast<std::size_t>(lattice[node])] =
        static_cast<int>(ids->GetId(static_cast<vtkIdType>(node)));
    }
    result.region.push_back(0);
  }
  if (result.region.empty())
  {
    throw Error("The mesh has no quads; give the quads of a Quad Mesher.");
  }
  if (result.side.empty())
  {
    throw Error(
      "The quads have no boundary edges; in ParaView, join them with the output Boundary by Quads To "
      "Higher Order, whose Order may be 1.");
  }
  result.periodic = PeriodicConversion::Read(mesh->GetFieldData(), result.sideNames);
  return result;
}
}
