#include "SimplifiedBoundary.h"

#include "BoundaryCorners.h"
#include "ColumnWriting.h"
#include "CurveConversion.h"
#include "SegmentCurveConversion.h"
#include "UsedPoints.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStaticPointLocator.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

namespace
{
using SimplifiedBoundary::Part;

int CountPoints(const crossfield::PlanarDomain& domain)
{
  int count = 0;
  for (const crossfield::Loop& loop : domain.loops)
  {
    count += static_cast<int>(loop.size());
  }
  return count;
}

/**
 * Copies the point arrays of the input to `points`, each from the nearest point that a cell uses.
 */
void CopyNearestArrays(vtkDataSet* input, vtkPoints* points, vtkPointData* arrays)
{
  if (input->GetPointData()->GetNumberOfArrays() == 0)
  {
    return;
  }
  const UsedPoints used(input);
  vtkNew<vtkPoints> places;
  places->SetDataTypeToDouble();
  for (const vtkIdType id : used.GetIds())
  {
    places->InsertNextPoint(input->GetPoint(id));
  }
  vtkNew<vtkPolyData> nearby;
  nearby->SetPoints(places);
  vtkNew<vtkStaticPointLocator> locator;
  locator->SetDataSet(nearby);
  locator->BuildLocator();
  arrays->CopyAllocate(input->GetPointData(), points->GetNumberOfPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const vtkIdType nearest = locator->FindClosestPoint(points->GetPoint(i));
    arrays->CopyData(input->GetPointData(), used.GetIds()[nearest], i);
  }
}

/**
 * Adds one polyline per loop of a part, or per piece of a side or a curve. `names` is absent if
 * sides have no names.
 */
void AddLoops(const Part& part, vtkPoints* points, vtkCellArray* lines, vtkStringArray* names,
  CurveConversion::CellCurves& cellCurves)
{
  const std::vector<crossfield::Loop>& loops = part.simple.domain.loops;
  const std::vector<crossfield::LoopArc> arcs(loops.begin(), loops.end());
  const crossfield::SidesAlong along(part.sides, arcs);
  const auto middle = [&](std::size_t loop, std::size_t segment)
  { return 0.5 * (arcs[loop].Start(segment) + arcs[loop].Start(segment + 1)); };
  const auto nameAt = [&](std::size_t loop, std::size_t segment)
  {
    const int side = along.At(loop, middle(loop, segment));
    return side < part.sides.given ? part.sides.names[side] : std::string();
  };
  const crossfield::CurvesAlong curvesAlong(part.boundary, arcs);
  const auto first = static_cast<int>(cellCurves.curves.size());
  const auto curveAt = [&](std::size_t loop, std::size_t segment)
  {
    const int curve = curvesAlong.At(loop, middle(loop, segment));
    return curve < 0 ? -1 : first + curve;
  };
  cellCurves.curves.insert(
    cellCurves.curves.end(), part.boundary.curves.begin(), part.boundary.curves.end());
  for (std::size_t l = 0; l < arcs.size(); ++l)
  {
    const vtkIdType start = points->GetNumberOfPoints();
    std::vector<vtkIdType> piece;
    for (std::size_t i = 0; i < loops[l].size(); ++i)
    {
      piece.push_back(points->InsertNextPoint(part.simple.plane.ToSpace(loops[l][i]).data()));
      const bool isLast = i + 1 == loops[l].size();
      if (isLast || (names != nullptr && nameAt(l, i) != nameAt(l, i + 1)) ||
        curveAt(l, i) != curveAt(l, i + 1))
      {
        piece.push_back(isLast ? start : points->GetNumberOfPoints());
        lines->InsertNextCell(static_cast<vtkIdType>(piece.size()), piece.data());
        if (names != nullptr)
        {
          names->InsertNextValue(nameAt(l, i));
        }
        cellCurves.ofCell.push_back(curveAt(l, i));
        piece.clear();
      }
    }
  }
}
}

namespace SimplifiedBoundary
{
//------------------------------------------------------------------------------
void WriteLoops(
  const std::vector<Part>& parts, const std::string& array, vtkDataSet* input, vtkDataSet* output)
{
  vtkNew<vtkStringArray> sideNames;
  sideNames->SetName(array.c_str());
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  CurveConversion::CellCurves cellCurves;
  for (const Part& part : parts)
  {
    AddLoops(part, points, lines, array.empty() ? nullptr : sideNames.Get(), cellCurves);
  }
  if (auto* curves = vtkPolyData::SafeDownCast(output))
  {
    curves->SetPoints(points);
    curves->SetLines(lines);
  }
  else if (auto* grid = vtkUnstructuredGrid::SafeDownCast(output))
  {
    grid->SetPoints(points);
    grid->SetCells(VTK_POLY_LINE, lines);
  }
  CopyNearestArrays(input, points, output->GetPointData());
  if (!array.empty())
  {
    output->GetCellData()->AddArray(sideNames);
  }
  SegmentCurveConversion::RemoveCurves(output);
  if (std::any_of(
        cellCurves.ofCell.begin(), cellCurves.ofCell.end(), [](int curve) { return curve >= 0; }))
  {
    CurveConversion::AddCurves(cellCurves, output);
  }
}

//------------------------------------------------------------------------------
void WriteChanges(const std::vector<Part>& parts, double cornerAngle, vtkDataSet* output)
{
  namespace names = vtkCrossFieldArrayNames;
  double moved = 0.0;
  std::vector<int> counts(2);
  vtkNew<vtkDoubleArray> removed;
  removed->SetName(names::BoundaryRemovedCorners);
  removed->SetNumberOfComponents(3);
  for (const Part& part : parts)
  {
    moved = std::max(moved, part.moved);
    counts[0] += CountPoints(part.given.domain);
    counts[1] += CountPoints(part.simple.domain);
    const double rounding = 1e-9 * part.given.domain.Diagonal();
    const std::vector<crossfield::Corner> after =
      crossfield::FindCorners(part.simple.domain.loops, cornerAngle);
    for (const crossfield::Corner& corner :
      crossfield::FindCorners(part.given.domain.loops, cornerAngle))
    {
      if (std::none_of(after.begin(), after.end(),
            [&](const crossfield::Corner& other)
            { return (other.position - corner.position).norm() <= rounding; }))
      {
        removed->InsertNextTuple(part.given.plane.ToSpace(corner.position).data());
      }
    }
  }
  ColumnWriting::AddNumbers(output->GetFieldData(), names::BoundaryMoved, { moved });
  ColumnWriting::AddIntegers(output->GetFieldData(), names::BoundaryPoints, counts);
  if (removed->GetNumberOfTuples() > 0)
  {
    output->GetFieldData()->AddArray(removed);
  }
}
}
