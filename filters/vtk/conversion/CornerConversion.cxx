#include "CornerConversion.h"

#include "ColumnWriting.h"
#include "Error.h"
#include "InputCheck.h"
#include "QuarterIndexRange.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace
{
namespace names = vtkCrossFieldArrayNames;
using ColumnWriting::AddColumn;
using ColumnWriting::WritePlaces;
}

namespace CornerConversion
{
//------------------------------------------------------------------------------
void WriteCorners(const crossfield::CornerClassification& classification,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  using Corner = crossfield::ClassifiedCorner;
  const auto& corners = classification.corners;
  WritePlaces(corners, plane, output);
  vtkFieldData* data = output->GetPointData();
  const auto addInteger = [&](const char* name, auto value)
  { AddColumn<vtkIntArray>(data, name, corners, value); };
  AddColumn<vtkDoubleArray>(
    data, names::Angle, corners, [](const Corner& corner) { return corner.angle; });
  addInteger(names::QuarterIndex, [](const Corner& corner) { return corner.quarterIndex; });
  addInteger(names::QuarterIndexScarce, [](const Corner& corner) { return corner.scarce; });
  addInteger(names::QuarterIndexBalanced, [](const Corner& corner) { return corner.balanced; });
  addInteger(names::QuarterIndexExcess, [](const Corner& corner) { return corner.excess; });
  addInteger(
    names::QuarterIndexConventional, [](const Corner& corner) { return corner.conventional; });
  AddColumn<vtkDoubleArray>(
    data, names::CornerEnergy, corners, [](const Corner& corner) { return corner.energy; });
  addInteger(names::Cancellable, [](const Corner& corner) { return corner.Cancellable() ? 1 : 0; });
  addInteger(names::Tied, [](const Corner& corner) { return corner.tied ? 1 : 0; });
  addInteger(names::Overridden, [](const Corner& corner) { return corner.overridden ? 1 : 0; });

  const auto& only = { classification };
  vtkFieldData* report = output->GetFieldData();
  AddColumn<vtkStringArray>(report, names::Scenario, only,
    [](const auto& result) { return crossfield::ScenarioName(result.scenario); });
  AddColumn<vtkDoubleArray>(
    report, names::Energy, only, [](const auto& result) { return result.energy; });
  AddColumn<vtkIntArray>(report, names::InteriorQuarters, only,
    [](const auto& result) { return result.interiorQuarters; });
  WriteAmbiguous(static_cast<int>(std::count_if(corners.begin(), corners.end(),
                   [](const Corner& corner) {
                     return !corner.overridden &&
                       crossfield::IsTie(corner.Turning(), crossfield::AmbiguousAngle);
                   })),
    report);
}

//------------------------------------------------------------------------------
void WriteAmbiguous(int count, vtkFieldData* report)
{
  if (count > 0)
  {
    ColumnWriting::AddIntegers(report, names::AmbiguousCorners, { count });
  }
}

//------------------------------------------------------------------------------
void WriteScenarios(const crossfield::CornerClassification& classification, vtkTable* output)
{
  const std::vector<int> rows = { 0, 1, 2 };
  vtkFieldData* data = output->GetRowData();
  const auto cost = [&](int row) -> const crossfield::ScenarioCost&
  { return classification.scenarios[row]; };
  AddColumn<vtkStringArray>(data, names::Scenario, rows,
    [](int row) { return crossfield::ScenarioName(static_cast<crossfield::Scenario>(row)); });
  AddColumn<vtkIntArray>(data, names::Sum, rows, [&](int row) { return cost(row).sum; });
  AddColumn<vtkDoubleArray>(data, names::Energy, rows, [&](int row) { return cost(row).energy; });
  AddColumn<vtkIntArray>(
    data, names::Feasible, rows, [&](int row) { return cost(row).feasible ? 1 : 0; });
  AddColumn<vtkIntArray>(data, names::Chosen, rows,
    [&](int row) { return static_cast<int>(classification.scenario) == row ? 1 : 0; });
}

//------------------------------------------------------------------------------
void WriteCountedCorners(const std::vector<crossfield::CountedCorner>& corners,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  using Corner = crossfield::CountedCorner;
  WritePlaces(corners, plane, output);
  vtkFieldData* data = output->GetPointData();
  AddColumn<vtkDoubleArray>(
    data, names::Angle, corners, [](const Corner& corner) { return corner.angle; });
  AddColumn<vtkIntArray>(
    data, names::QuarterIndex, corners, [](const Corner& corner) { return corner.quarterIndex; });
  AddColumn<vtkIntArray>(data, names::Cancellable, corners,
    [](const Corner& corner) { return corner.Cancellable() ? 1 : 0; });
}

//------------------------------------------------------------------------------
void WriteChoices(const std::vector<crossfield::CornerChoice>& choices,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  WritePlaces(choices, plane, output);
  AddColumn<vtkIntArray>(output->GetPointData(), names::QuarterIndex, choices,
    [](const crossfield::CornerChoice& choice) { return choice.quarterIndex; });
}

//------------------------------------------------------------------------------
void WriteLoopTable(const crossfield::PoincareHopfCount& count,
  const std::vector<double>& holonomyDefects, vtkTable* output)
{
  std::vector<int> rows;
  for (std::size_t i = 0; i < count.loops.size(); ++i)
  {
    rows.push_back(static_cast<int>(i));
  }
  vtkFieldData* data = output->GetRowData();
  const auto part = [&](int row) -> const crossfield::LoopCount& { return count.loops[row]; };
  AddColumn<vtkIntArray>(data, names::BoundaryLoop, rows, [](int row) { return row; });
  AddColumn<vtkDoubleArray>(data, names::Valence, rows, [&](int row) { return part(row).valence; });
  AddColumn<vtkDoubleArray>(
    data, names::TangentTurning, rows, [&](int row) { return part(row).tangentTurning; });
  AddColumn<vtkIntArray>(
    data, names::CornerQuarters, rows, [&](int row) { return part(row).cornerQuarters; });
  AddColumn<vtkIntArray>(data, names::RequiredPart, rows,
    [&](int row) { return (row == 0 ? 4 : -4) - part(row).cornerQuarters; });
  // The outer loop has no defect, and the list is empty if defects were not computed.
  const auto defect = [&](int row)
  {
    const auto inner = static_cast<std::size_t>(row) - 1;
    return row > 0 && inner < holonomyDefects.size() ? holonomyDefects[inner] : std::nan("");
  };
  AddColumn<vtkDoubleArray>(data, names::HolonomyDefect, rows, defect);
}

//------------------------------------------------------------------------------
std::vector<crossfield::CornerChoice> ReadCorners(
  vtkDataSet* input, const crossfield::DomainPlane& plane)
{
  std::vector<crossfield::CornerChoice> choices;
  if (input == nullptr || input->GetNumberOfPoints() == 0)
  {
    return choices;
  }
  InputCheck::Require(input);
  vtkDataArray* quarters = input->GetPointData()->GetArray(names::QuarterIndex);
  if (quarters == nullptr || quarters->GetNumberOfComponents() != 1)
  {
    throw crossfield::Error("The corners have no point array 'QuarterIndex' with one component; "
                            "give the output of the corner classifier.");
  }
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    const int quarterIndex = crossfield::RequireQuarterIndex(
      quarters->GetTuple1(i), "The quarter index of corner " + std::to_string(i + 1), "1 or 0");
    choices.push_back({ plane.RequireInPlane(Eigen::Vector3d(input->GetPoint(i)),
                          "The corner " + std::to_string(i + 1)),
      quarterIndex });
  }
  return choices;
}
}
