#include "SegmentCurveConversion.h"

#include "CurveConversion.h"
#include "SegmentCells.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkAbstractArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"

#include <map>

namespace
{
namespace names = vtkCrossFieldArrayNames;

constexpr const char* FieldNames[] = { names::CurveKind, names::CurveOffset, names::CurveValues };
}

namespace SegmentCurveConversion
{
//------------------------------------------------------------------------------
crossfield::CurvesOfSegments Read(vtkDataSet* input, const DomainConversion::Domain& domain)
{
  CurveConversion::CellCurves read = CurveConversion::ReadCurves(input);
  crossfield::CurvesOfSegments result;
  if (read.curves.empty())
  {
    return result;
  }
  const auto curveOf = [&](vtkIdType cell) { return read.ofCell[cell]; };
  std::map<int, int> numbers; // of curves that segments have
  for (const std::vector<vtkIdType>& cells :
    SegmentCells::Find(input, domain, [&](vtkIdType cell) { return curveOf(cell) >= 0; }))
  {
    result.ofSegment.emplace_back();
    for (const vtkIdType cell : cells)
    {
      result.ofSegment.back().push_back(cell < 0 ? -1 : curveOf(cell));
    }
    for (const int curve : result.ofSegment.back())
    {
      numbers[curve] = -1;
    }
  }
  numbers.erase(-1);
  for (auto& [curve, number] : numbers)
  {
    number = static_cast<int>(result.curves.size());
    result.curves.push_back(read.curves[curve]);
  }
  for (std::vector<int>& curves : result.ofSegment)
  {
    for (int& curve : curves)
    {
      curve = curve < 0 ? -1 : numbers[curve];
    }
  }
  return result;
}

//------------------------------------------------------------------------------
void CopyCurves(vtkDataSet* from, vtkDataSet* to)
{
  RemoveCurves(to);
  for (const char* name : FieldNames)
  {
    if (vtkAbstractArray* array = from->GetFieldData()->GetAbstractArray(name))
    {
      to->GetFieldData()->AddArray(array);
    }
  }
}

//------------------------------------------------------------------------------
void RemoveCurves(vtkDataSet* data)
{
  for (const char* name : FieldNames)
  {
    data->GetFieldData()->RemoveArray(name);
  }
}
}
