// Invalid meshes and inconsistent configurations for vtkPerforatedCrossField.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkPerforatedCrossField.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace
{
using FilterChecks::CaptureError;

class PerforatedCrossFieldRefusals : public testing::Test
{
public:
  /** Expects that valid input works after each failure. */
  void TearDown() override
  {
    this->Filter->SetInputData(TestInputs::DrilledDisk());
    FilterChecks::UpdateWithoutError(this->Filter);
  }

  /** Returns the drilled disk with the cells for which `isSelected` is true. */
  vtkSmartPointer<vtkUnstructuredGrid> Select(const std::function<bool(vtkIdType)>& isSelected)
  {
    const auto mesh = TestInputs::DrilledDisk();
    auto result = vtkSmartPointer<vtkUnstructuredGrid>::New();
    result->SetPoints(mesh->GetPoints());
    result->Allocate(mesh->GetNumberOfCells());
    vtkCellData* data = result->GetCellData();
    data->CopyAllocate(mesh->GetCellData());
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      if (isSelected(cell))
      {
        mesh->GetCellPoints(cell, ids);
        data->CopyData(
          mesh->GetCellData(), cell, result->InsertNextCell(mesh->GetCellType(cell), ids));
      }
    }
    return result;
  }

  /** Expects the message in the text for a view as well. */
  void ExpectError(vtkUnstructuredGrid* mesh, const std::vector<std::string>& parts,
    unsigned long code = vtkErrorCode::UserError)
  {
    this->Filter->SetInputData(mesh);
    EXPECT_EQ(CaptureError(this->Filter, parts), code);
    const auto [text, isAlarm] = FilterChecks::TextForView(this->Filter, 1, "Summary");
    EXPECT_TRUE(isAlarm);
    for (const std::string& part : parts)
    {
      EXPECT_NE(text.find(part), std::string::npos) << text;
    }
  }

  /** Sets an array to a value on the cells that have another given value. */
  static void Replace(vtkUnstructuredGrid* mesh, const char* name, int before, int after)
  {
    vtkDataArray* array = mesh->GetCellData()->GetArray(name);
    for (vtkIdType cell = 0; cell < array->GetNumberOfTuples(); ++cell)
    {
      if (mesh->GetCellType(cell) == VTK_LINE && array->GetTuple1(cell) == before)
      {
        array->SetTuple1(cell, after);
      }
    }
  }

  vtkNew<vtkPerforatedCrossField> Filter;
};
}

TEST_F(PerforatedCrossFieldRefusals, InconsistentConfiguration)
{
  const auto disk = TestInputs::Loops({ TestInputs::Circle(64, 1.0) });
  this->ExpectError(
    TestInputs::Drill(disk, { { 0.5, 0.0, 1.0, 0.1 }, { -0.5, 0.0, 2.0, 0.1 } }, 0.2),
    { "add up to 3", "requires 4" }, vtkCrossFieldErrorCodes::Inconsistent);
  this->ExpectError(TestInputs::Drill(disk, {}, 0.2), { "add up to 0", "requires 4" },
    vtkCrossFieldErrorCodes::Inconsistent);
}

TEST_F(PerforatedCrossFieldRefusals, ErrorCodesAreStable)
{
  EXPECT_EQ(int(vtkCrossFieldErrorCodes::BadInput), 40000);
  EXPECT_EQ(int(vtkCrossFieldErrorCodes::Inconsistent), 40001);
  EXPECT_EQ(int(vtkPerforatedCrossField::InconsistentError), 40001);
}

TEST_F(PerforatedCrossFieldRefusals, MeshWithoutArraysOfDrillHoles)
{
  for (const char* name : { "BoundaryKind", "BoundaryId", "QuarterIndex" })
  {
    const auto mesh = TestInputs::DrilledDisk();
    mesh->GetCellData()->RemoveArray(name);
    this->ExpectError(mesh, { "'" + std::string(name) + "'" });
  }
  const auto bare = TestInputs::DrilledDisk();
  bare->GetCellData()->Initialize();
  this->ExpectError(bare, { "'BoundaryKind'" });
}

TEST_F(PerforatedCrossFieldRefusals, CellsOfOtherTypes)
{
  const auto mesh = TestInputs::DrilledDisk();
  const vtkIdType last = mesh->GetNumberOfCells() - 1;
  const auto withoutLastLine = this->Select([last](vtkIdType cell) { return cell != last; });
  this->ExpectError(withoutLastLine, {});
  const auto withoutLines =
    this->Select([&mesh](vtkIdType cell) { return mesh->GetCellType(cell) == VTK_TRIANGLE; });
  this->ExpectError(withoutLines, {});
  const auto withoutTriangle = this->Select([](vtkIdType cell) { return cell != 0; });
  this->ExpectError(withoutTriangle, {});
  const auto onlyLines =
    this->Select([&mesh](vtkIdType cell) { return mesh->GetCellType(cell) == VTK_LINE; });
  this->ExpectError(onlyLines, {});

  const auto quadrilateral = this->Select([](vtkIdType) { return true; });
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  quadrilateral->InsertNextCell(VTK_QUAD, 4, ids);
  for (const char* name : { "BoundaryKind", "BoundaryId", "QuarterIndex" })
  {
    quadrilateral->GetCellData()->GetArray(name)->InsertNextTuple1(0);
  }
  this->ExpectError(quadrilateral, { "Cell " + std::to_string(last + 1) });
}

TEST_F(PerforatedCrossFieldRefusals, CodesOutOfRange)
{
  const auto kind = TestInputs::DrilledDisk();
  Replace(kind, "BoundaryKind", 3, 7);
  this->ExpectError(kind, { "BoundaryKind" });
  const auto joined = TestInputs::DrilledDisk();
  Replace(joined, "BoundaryId", 1, 0); // two loops with the same id
  this->ExpectError(joined, { "do not form one closed loop" });
}

TEST_F(PerforatedCrossFieldRefusals, HoleWithTooFewEdges)
{
  const auto mesh = TestInputs::DrilledDisk();
  // 4 = 1 + 1 + 40 − 38, on polygons with about 32 edges.
  vtkDataArray* quarters = mesh->GetCellData()->GetArray("QuarterIndex");
  vtkDataArray* kinds = mesh->GetCellData()->GetArray("BoundaryKind");
  vtkDataArray* rows = mesh->GetCellData()->GetArray("BoundaryId");
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    if (kinds->GetTuple1(cell) == 3 && rows->GetTuple1(cell) >= 2)
    {
      quarters->SetTuple1(cell, rows->GetTuple1(cell) == 2 ? 40 : -38);
    }
  }
  this->Filter->SetMethodToConstrained();
  this->ExpectError(mesh, { "edges", "quarter index" });
}

TEST_F(PerforatedCrossFieldRefusals, PointsThatAreNotFinite)
{
  const auto mesh = TestInputs::DrilledDisk();
  mesh->GetPoints()->SetPoint(0, std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  this->ExpectError(mesh, { "Point 0", "not finite" });
}

TEST_F(PerforatedCrossFieldRefusals, TriangleWithoutArea)
{
  const auto mesh = TestInputs::DrilledDisk();
  vtkNew<vtkIdList> ids;
  mesh->GetCellPoints(0, ids);
  mesh->GetPoints()->SetPoint(ids->GetId(0), mesh->GetPoint(ids->GetId(1)));
  this->ExpectError(mesh, {});
}
