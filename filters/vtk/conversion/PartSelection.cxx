#include "PartSelection.h"

#include "DomainConversion.h"
#include "DomainParts.h"
#include "Error.h"
#include "SegmentSearch.h"
#include "SideConversion.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <set>
#include <vector>

namespace
{
using crossfield::Error;

/** Distance from a part, relative to its diagonal, at which its cells are: points are merged within it. */
constexpr double Rounding = 1e-8;

/** Returns the middle of a line's first segment, or of the corners of a surface cell, in the plane. */
crossfield::Point PlaceOf(vtkCell* cell, const crossfield::DomainPlane& plane)
{
  const vtkIdType count = cell->GetCellDimension() == 1 ? 2 : cell->GetNumberOfPoints();
  crossfield::Point sum = crossfield::Point::Zero();
  for (vtkIdType i = 0; i < count; ++i)
  {
    double place[3];
    cell->GetPoints()->GetPoint(i, place);
    sum += plane.ToPlane(Eigen::Vector3d(place));
  }
  return sum / static_cast<double>(count);
}

/** Returns the part of each cell, −1 for vertices and cells in none. */
std::vector<int> PartsOf(vtkDataSet* input, const std::vector<crossfield::PlanarDomain>& parts,
  const crossfield::DomainPlane& plane)
{
  std::vector<crossfield::SegmentSearch> searches(parts.begin(), parts.end());
  std::vector<int> result(static_cast<std::size_t>(input->GetNumberOfCells()), -1);
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    vtkCell* cell = input->GetCell(i);
    for (std::size_t part = 0; cell->GetCellDimension() > 0 && part < parts.size(); ++part)
    {
      if (searches[part].SignedDistance(PlaceOf(cell, plane)) >= -Rounding * parts[part].Diagonal())
      {
        result[static_cast<std::size_t>(i)] = static_cast<int>(part);
        break;
      }
    }
  }
  return result;
}

/** Returns the only part that has cells with a name. */
int PartNamed(const std::string& name, vtkDataSet* input, const std::vector<int>& partOf,
  const std::string& sideNameArray)
{
  const std::string array = SideConversion::FindArray(input, sideNameArray);
  vtkAbstractArray* names =
    array.empty() ? nullptr : input->GetCellData()->GetAbstractArray(array.c_str());
  std::set<int> found;
  for (vtkIdType i = 0; names != nullptr && i < input->GetNumberOfCells(); ++i)
  {
    if (names->GetVariantValue(i).ToString() == name)
    {
      found.insert(partOf[static_cast<std::size_t>(i)]);
    }
  }
  found.erase(-1);
  if (found.size() != 1)
  {
    throw Error((found.empty() ? "No part of the domain has a side '"
                               : "Several parts of the domain have a side '") +
      name + "'; give largest, or a number from 1 for the largest part.");
  }
  return *found.begin();
}

/** Returns the cells of one part. */
template <class DataSet>
vtkSmartPointer<vtkDataSet> CellsOf(DataSet* input, const std::vector<int>& partOf, int part)
{
  auto result = vtkSmartPointer<DataSet>::New();
  result->SetPoints(input->GetPoints());
  result->AllocateEstimate(input->GetNumberOfCells(), 2);
  result->GetPointData()->ShallowCopy(input->GetPointData());
  result->GetFieldData()->ShallowCopy(input->GetFieldData());
  result->GetCellData()->CopyAllocate(input->GetCellData(), input->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < input->GetNumberOfCells(); ++i)
  {
    if (partOf[static_cast<std::size_t>(i)] == part)
    {
      input->GetCellPoints(i, ids);
      const vtkIdType cell = result->InsertNextCell(input->GetCellType(i), ids);
      result->GetCellData()->CopyData(input->GetCellData(), i, cell);
    }
  }
  return result;
}
}

namespace PartSelection
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkDataSet> Select(
  vtkDataSet* input, const std::string& part, const std::string& sideNameArray)
{
  if (part.empty())
  {
    return input;
  }
  const DomainConversion::Boundary boundary = DomainConversion::ReadLoops(input);
  const std::vector<crossfield::PlanarDomain> parts = crossfield::SplitParts(boundary.loops);
  const std::vector<int> partOf = PartsOf(input, parts, boundary.plane);
  const int numbered = crossfield::PartOf(part, parts.size());
  const int chosen = numbered >= 0 ? numbered : PartNamed(part, input, partOf, sideNameArray);
  auto* lines = vtkPolyData::SafeDownCast(input);
  return lines != nullptr ? CellsOf(lines, partOf, chosen)
                          : CellsOf(vtkUnstructuredGrid::SafeDownCast(input), partOf, chosen);
}
}
