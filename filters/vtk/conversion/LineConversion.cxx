#include "LineConversion.h"

#include "CellOutline.h"
#include "Error.h"
#include "SideConversion.h"

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointSet.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace LineConversion
{
//------------------------------------------------------------------------------
Lines Find(vtkDataSet* input, const std::string& array, const std::vector<std::string>& lines,
  const std::vector<std::string>& open)
{
  Lines result;
  std::vector<std::string> wanted = lines;
  wanted.insert(wanted.end(), open.begin(), open.end());
  if (wanted.empty())
  {
    return result;
  }
  const std::vector<std::string> names = SideConversion::NamesOfCells(input, array);
  result.ofCell.assign(names.size(), -1);
  CellOutline::ForEachCell(input,
    [&](vtkIdType cell, int type, const CellLoop::Points&)
    {
      const auto index = static_cast<std::size_t>(cell);
      const bool isLine = type == VTK_LINE || type == VTK_POLY_LINE;
      if (!isLine || index >= names.size() ||
        std::find(wanted.begin(), wanted.end(), names[index]) == wanted.end())
      {
        return;
      }
      const auto known = std::find(result.names.begin(), result.names.end(), names[index]);
      result.ofCell[index] = static_cast<int>(known - result.names.begin());
      if (known == result.names.end())
      {
        result.names.push_back(names[index]);
      }
    });
  for (const std::string& name : lines)
  {
    if (std::find(result.names.begin(), result.names.end(), name) == result.names.end())
    {
      throw crossfield::Error("No line of the domain has the name '" + name +
        "'; give names that its lines have in the array of sides (SideNameArray, --names).");
    }
  }
  return result;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> Without(vtkDataSet* input, const Lines& lines)
{
  auto* points = vtkPointSet::SafeDownCast(input);
  if (lines.names.empty() || points == nullptr)
  {
    return input;
  }
  auto rest = vtkSmartPointer<vtkUnstructuredGrid>::New();
  rest->SetPoints(points->GetPoints());
  rest->AllocateEstimate(input->GetNumberOfCells(), 2);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    if (lines.ofCell[static_cast<std::size_t>(cell)] < 0)
    {
      input->GetCellPoints(cell, ids);
      rest->InsertNextCell(input->GetCellType(cell), ids);
    }
  }
  return rest;
}

//------------------------------------------------------------------------------
std::vector<crossfield::SegmentOnLine> Read(
  vtkDataSet* input, const Lines& lines, const crossfield::DomainPlane& plane)
{
  std::vector<crossfield::SegmentOnLine> segments;
  const auto at = [&](vtkIdType point)
  { return plane.ToPlane(Eigen::Vector3d(input->GetPoint(point))); };
  CellOutline::ForEachCell(input,
    [&](vtkIdType cell, int, const CellLoop::Points& points)
    {
      const int name = lines.ofCell.empty() ? -1 : lines.ofCell[static_cast<std::size_t>(cell)];
      for (vtkIdType i = 1; name >= 0 && i < points.Size(); ++i)
      {
        segments.push_back({ at(points[i - 1]), at(points[i]), name });
      }
    });
  return segments;
}
}
