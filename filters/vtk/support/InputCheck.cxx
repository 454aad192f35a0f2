#include "InputCheck.h"

#include "CellLoop.h"
#include "Error.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVersionMacros.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace
{
using crossfield::Error;

/** Returns whether all lists of cells are as long as their offsets require. */
bool HasValidLists(vtkDataSet* input)
{
  if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    return surface->GetVerts()->IsValid() && surface->GetLines()->IsValid() &&
      surface->GetPolys()->IsValid() && surface->GetStrips()->IsValid();
  }
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (grid == nullptr || grid->GetCells() == nullptr)
  {
    return true; // cells defined by a structure, or none
  }
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 6, 0)
  const vtkDataArray* types = grid->GetCellTypes();
#else
  const vtkDataArray* types = grid->GetCellTypesArray();
#endif
  return grid->GetCells()->IsValid() && types != nullptr &&
    types->GetNumberOfValues() == grid->GetCells()->GetNumberOfCells();
}

/** Returns the number of points of a cell of this type; 0 if it varies. */
vtkIdType PointCountOfType(int type)
{
  switch (type)
  {
  case VTK_VERTEX:
    return 1;
  case VTK_LINE:
    return 2;
  case VTK_TRIANGLE:
    return 3;
  case VTK_QUAD:
  case VTK_PIXEL:
    return 4;
  default:
    return 0;
  }
}

template <class Points>
void RequirePoints(vtkIdType cell, const Points& points, vtkIdType count)
{
  for (const auto point : points)
  {
    if (point < 0 || point >= count)
    {
      throw Error("Cell " + std::to_string(cell) + " uses point " + std::to_string(point) + " of " +
        std::to_string(count) + "; the data is damaged, make it again.");
    }
  }
}

/** Checks the cells in the lists, since VTK 9.1 crashes in GetCellPoints of an empty polygon. */
void RequireCells(vtkPolyData* input)
{
  const std::array<std::pair<vtkCellArray*, vtkIdType>, 4> lists = { { { input->GetVerts(), 1 },
    { input->GetLines(), 1 }, { input->GetPolys(), 3 }, { input->GetStrips(), 3 } } };
  vtkIdType first = 0;
  for (const auto& entry : lists)
  {
    const vtkIdType minimum = entry.second;
    CellLoop::ForEachInList(entry.first,
      [&](vtkIdType i, const auto& points)
      {
        if (points.Size() < minimum)
        {
          throw Error("Cell " + std::to_string(first + i) + " has " +
            std::to_string(points.Size()) + " points instead of " + std::to_string(minimum) +
            " or more; the data is damaged, make it again.");
        }
        RequirePoints(first + i, points, input->GetNumberOfPoints());
      });
    first += entry.first->GetNumberOfCells();
  }
}

void RequireCells(vtkDataSet* input)
{
  const vtkIdType count = input->GetNumberOfPoints();
  CellLoop::ForEachCell(input,
    [count](vtkIdType cell, int type, const auto& points)
    {
      const vtkIdType expected = PointCountOfType(type);
      if (expected > 0 && points.Size() != expected)
      {
        throw Error("Cell " + std::to_string(cell) + " has " + std::to_string(points.Size()) +
          " points instead of " + std::to_string(expected) +
          "; the data is damaged, make it again.");
      }
      RequirePoints(cell, points, count);
    });
}

void RequireArrays(vtkDataSetAttributes* attributes, vtkIdType count, const std::string& what)
{
  for (int i = 0; i < attributes->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = attributes->GetAbstractArray(i);
    if (array->GetNumberOfTuples() < count)
    {
      throw Error("The array '" + std::string(array->GetName() != nullptr ? array->GetName() : "") +
        "' has " + std::to_string(array->GetNumberOfTuples()) + " entries for " +
        std::to_string(count) + " " + what + "; the data is damaged, make it again.");
    }
  }
}
}

namespace InputCheck
{
//------------------------------------------------------------------------------
void Require(vtkDataSet* input)
{
  if (!HasValidLists(input))
  {
    throw Error(
      "The list of cells ends before the last of them; the data is damaged, make it again.");
  }
  if (auto* surface = vtkPolyData::SafeDownCast(input))
  {
    RequireCells(surface);
  }
  else
  {
    RequireCells(input);
  }
  RequireArrays(input->GetPointData(), input->GetNumberOfPoints(), "points");
  RequireArrays(input->GetCellData(), input->GetNumberOfCells(), "cells");
}

//------------------------------------------------------------------------------
void RequireFinite(const double* place, vtkIdType point)
{
  if (!std::isfinite(place[0]) || !std::isfinite(place[1]) || !std::isfinite(place[2]))
  {
    throw Error("Point " + std::to_string(point) +
      " of the domain has coordinates that are not finite numbers; correct or remove it.");
  }
}
}
