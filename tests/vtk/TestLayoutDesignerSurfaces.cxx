// Surfaces in space in vtkLayoutDesigner.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkLayoutDesigner.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
using FilterChecks::RequireArray;
using FilterChecks::UpdateWithoutError;

class LayoutDesignerSurfaces : public testing::Test
{
public:
  void SetUp() override
  {
    this->Filter->SetInputData(TestInputs::BlownUpCube(12));
    this->Filter->SetQuadCount(400);
  }

  /** Sets singularities at the corners of a cube turned by an angle. */
  void SetEight(double turn = 0.4)
  {
    for (int i = 0; i < 8; ++i)
    {
      const double angle = 0.25 * 3.14159265358979 * (2 * (i % 4) + 1) + turn;
      const double z = i < 4 ? 0.577 : -0.577;
      this->Filter->SetSingularity(i, 0.816 * std::cos(angle), 0.816 * std::sin(angle), 1, z);
    }
  }

  double Value(const char* name)
  {
    return RequireArray(this->Filter->GetOutput()->GetFieldData(), name)->GetComponent(0, 0);
  }

  vtkDataSet* Output(int port)
  {
    return vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(port));
  }

  std::string Reason() { return FilterChecks::TextForView(this->Filter, 4, "Summary").first; }

  vtkNew<vtkLayoutDesigner> Filter;
};
}

TEST_F(LayoutDesignerSurfaces, FollowsFilterConventions)
{
  this->SetEight();
  UpdateWithoutError(this->Filter);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->SetEight(0.4); }, [this] { this->SetEight(0.1); });
  FilterChecks::CheckPrintSelf(this->Filter, { "FeatureAngle" });
}

TEST_F(LayoutDesignerSurfaces, HaveSeparatricesPatchesAndQuads)
{
  this->SetEight();
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Stale"), 0);
  EXPECT_EQ(this->Value("Faces"),
    RequireArray(this->Output(1)->GetFieldData(), "Faces")->GetComponent(0, 0));
  EXPECT_EQ(RequireArray(this->Output(1)->GetFieldData(), "Lines")->GetComponent(0, 0), 24);
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetArray("RenormalizedEnergy"), nullptr);
  EXPECT_NEAR(static_cast<double>(this->Output(3)->GetNumberOfCells()), 400, 80);
  for (const int port : { 0, 1, 2, 3 })
  {
    vtkDataSet* data = this->Output(port);
    ASSERT_GT(data->GetNumberOfPoints(), 0) << port;
    for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
    {
      const double* place = data->GetPoint(p);
      EXPECT_NEAR(std::hypot(place[0], place[1], place[2]), 1.0, 0.02) << port;
    }
  }
  vtkDataArray* shades = RequireArray(this->Output(0)->GetCellData(), "Shade");
  for (vtkIdType i = 0; i < shades->GetNumberOfTuples(); ++i)
  {
    EXPECT_EQ(shades->GetTuple1(i), 1.0) << "all start at an index of 1";
  }
  ASSERT_EQ(this->Filter->GetRows()->GetNumberOfTuples(), 8);
  EXPECT_EQ(this->Filter->GetRows()->GetComponent(7, 3), -0.577);
  EXPECT_EQ(this->Reason().find("energy"), std::string::npos) << this->Reason();
}

TEST_F(LayoutDesignerSurfaces, FollowAHandle)
{
  this->SetEight();
  this->Filter->DraggingOn();
  this->Filter->SetInputData(TestInputs::BlownUpCube(40)); // 19,200 triangles
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Output(3)->GetNumberOfCells(), 0) << "quads are made when it is released";
  EXPECT_EQ(this->Filter->GetTriangles()->GetNumberOfComponents(), 9);
  EXPECT_NEAR(static_cast<double>(this->Filter->GetTriangles()->GetNumberOfTuples()), 4000, 10);
  this->SetEight(0.35);
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Stale"), 0);
  EXPECT_GT(this->Output(1)->GetNumberOfCells(), 1000);
  this->Filter->SetSingularity(0, 0.1, 0.0, 2, 0.995);
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Stale"), 1);
  EXPECT_GT(this->Output(1)->GetNumberOfCells(), 1000) << "of the last layout";
  EXPECT_NE(this->Reason().find("needs 8"), std::string::npos) << this->Reason();
}

TEST_F(LayoutDesignerSurfaces, ApplyCommands)
{
  UpdateWithoutError(this->Filter);
  vtkDoubleArray* rows = this->Filter->GetRows();
  ASSERT_EQ(rows->GetNumberOfTuples(), 8) << "chosen";
  ASSERT_EQ(this->Filter->GetRequiredSum()->GetNumberOfValues(), 1);
  EXPECT_EQ(this->Filter->GetRequiredSum()->GetValue(0), 8);
  EXPECT_EQ(this->Filter->GetNumberOfSingularities(), 0);
  this->SetEight();
  this->Filter->SetSingularity(0, 0.0, 0.0, 1, 1.0);
  this->Filter->Optimise();
  UpdateWithoutError(this->Filter);
  EXPECT_GT(std::hypot(rows->GetComponent(0, 0), rows->GetComponent(0, 1)), 0.1) << "moved";
  this->Filter->Undo();
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(rows->GetComponent(0, 0), 0.0);
  this->Filter->RemoveSingularity(0);
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(rows->GetNumberOfTuples(), 7);
  EXPECT_EQ(this->Value("Stale"), 1);
  this->Filter->Propose();
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(rows->GetNumberOfTuples(), 8);
  EXPECT_EQ(this->Value("Stale"), 0);
}

TEST_F(LayoutDesignerSurfaces, RefuseWhatConcernsPlanes)
{
  this->SetEight();
  UpdateWithoutError(this->Filter);
  this->Filter->SetMeshSize(0.1);
  UpdateWithoutError(this->Filter);
  EXPECT_NE(this->Reason().find("mesh size"), std::string::npos) << this->Reason();
  EXPECT_EQ(this->Value("Stale"), 1);
  this->Filter->SetMeshSize(0.0);
  this->Filter->Snap();
  UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Stale"), 0);
  auto* events = vtkStringArray::SafeDownCast(
    this->Filter->GetOutput()->GetFieldData()->GetAbstractArray("Events"));
  ASSERT_NE(events, nullptr);
  EXPECT_NE(events->GetValue(0).find("do not work on a surface"), std::string::npos);
}
