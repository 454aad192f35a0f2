#include "InputCheck.h"

#include "Error.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <string>
#include <utility>

namespace
{
using crossfield::Error;

/** What a filter can walk along: all lists of cells are as long as they say. */
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
    return true; // cells that follow from a structure, or none
  }
  return grid->GetCells()->IsValid() && grid->GetCellTypesArray() != nullptr &&
    grid->GetCellTypesArray()->GetNumberOfValues() == grid->GetCells()->GetNumberOfCells();
}

/** The number of points of a cell of this type; 0: any. */
vtkIdType PointsOf(int type)
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

void RequirePoints(vtkIdType cell, vtkIdList* ids, vtkIdType count)
{
  for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
  {
    if (ids->GetId(i) < 0 || ids->GetId(i) >= count)
    {
      throw Error("Cell " + std::to_string(cell) + " uses point " + std::to_string(ids->GetId(i)) +
        " of " + std::to_string(count) + "; the data is damaged, make it again.");
    }
  }
}

/** Cell by cell in the lists: VTK 9.1 crashes when it is asked for the points of an empty polygon. */
void RequireCells(vtkPolyData* input)
{
  const std::array<std::pair<vtkCellArray*, vtkIdType>, 4> lists = { { { input->GetVerts(), 1 },
    { input->GetLines(), 1 }, { input->GetPolys(), 3 }, { input->GetStrips(), 3 } } };
  vtkNew<vtkIdList> ids;
  vtkIdType cell = 0;
  for (const auto& [list, least] : lists)
  {
    for (vtkIdType i = 0; i < list->GetNumberOfCells(); ++i, ++cell)
    {
      list->GetCellAtId(i, ids);
      if (ids->GetNumberOfIds() < least)
      {
        throw Error("Cell " + std::to_string(cell) + " has " +
          std::to_string(ids->GetNumberOfIds()) + " points instead of " + std::to_string(least) +
          " or more; the data is damaged, make it again.");
      }
      RequirePoints(cell, ids, input->GetNumberOfPoints());
    }
  }
}

void RequireCells(vtkDataSet* input)
{
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    const vtkIdType expected = PointsOf(input->GetCellType(cell));
    if (expected > 0 && ids->GetNumberOfIds() != expected)
    {
      throw Error("Cell " + std::to_string(cell) + " has " + std::to_string(ids->GetNumberOfIds()) +
        " points instead of " + std::to_string(expected) + "; the data is damaged, make it again.");
    }
    RequirePoints(cell, ids, input->GetNumberOfPoints());
  }
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
}
