#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkPerforatedCrossField.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace
{
using TestInputs::Circle;
using TestInputs::Rectangle;

/** Returns the Ginzburg-Landau field on a domain without holes, in the plane z = const. */
vtkSmartPointer<vtkUnstructuredGrid> FieldOn(
  const std::vector<TestInputs::Curve>& curves, double meshSize, double z = 0.0)
{
  vtkNew<vtkGinzburgLandauCrossField> solver;
  solver->SetInputData(TestInputs::Drill(TestInputs::Loops(curves, z), {}, meshSize));
  FilterChecks::UpdateWithoutError(solver);
  return solver->GetOutput();
}

class CrossFieldSingularities : public testing::Test
{
public:
  vtkPolyData* Read(vtkUnstructuredGrid* field)
  {
    this->Filter->SetInputData(field);
    const FilterChecks::MessageRecorder messages(this->Filter);
    this->Filter->Update(); // the output may be empty
    EXPECT_TRUE(messages.errors.empty() && messages.warnings.empty());
    EXPECT_EQ(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
    return this->Filter->GetOutput();
  }

  /** Returns a value of a point array of the output. */
  double At(const char* name, vtkIdType point)
  {
    return FilterChecks::RequireArray(this->Filter->GetOutput()->GetPointData(), name)
      ->GetComponent(point, 0);
  }

  vtkNew<vtkCrossFieldSingularities> Filter;
};

TEST_F(CrossFieldSingularities, Defaults)
{
  EXPECT_FALSE(this->Filter->GetIncludeCorners());
  EXPECT_FALSE(this->Filter->GetIncludeHoles());
  EXPECT_EQ(this->Filter->GetCornerAngle(), 30.0);
}

TEST_F(CrossFieldSingularities, FollowsFilterConventions)
{
  const auto disk = FieldOn({ Circle(42, 1.0) }, 0.15);
  const auto larger = FieldOn({ Circle(42, 1.1) }, 0.15);
  this->Filter->SetInputData(disk);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckRunTwice(
    this->Filter, [&] { this->Filter->SetInputData(disk); },
    [&] { this->Filter->SetInputData(larger); });
  FilterChecks::CheckPrintSelf(this->Filter, { "IncludeCorners", "IncludeHoles", "CornerAngle" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(CrossFieldSingularities, FindsFourInADisk)
{
  vtkPolyData* output = this->Read(FieldOn({ Circle(42, 1.0) }, 0.15, 2.5));
  ASSERT_EQ(output->GetNumberOfPoints(), 4);
  EXPECT_EQ(output->GetNumberOfVerts(), 4);
  EXPECT_EQ(output->GetPointData()->GetArray("Radius"), nullptr);
  EXPECT_EQ(output->GetPointData()->GetArray("QuarterIndex")->GetDataType(), VTK_INT);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(this->At("QuarterIndex", i), 1.0);
    EXPECT_EQ(this->At("BoundaryKind", i), 0.0);
    EXPECT_EQ(this->At("BoundaryId", i), -1.0);
    const double* place = output->GetPoint(i);
    EXPECT_NEAR(std::hypot(place[0], place[1]), 0.82, 0.05);
    EXPECT_EQ(place[2], 2.5);
  }
}

TEST_F(CrossFieldSingularities, OutputCanBeDrilled)
{
  const auto domain = TestInputs::Loops({ Circle(42, 1.0) });
  vtkNew<vtkPolyData> found;
  found->DeepCopy(this->Read(FieldOn({ Circle(42, 1.0) }, 0.15)));
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputData(domain);
  drill->SetSingularitiesData(found);
  drill->SetMeshSize(0.08);
  vtkNew<vtkPerforatedCrossField> solver;
  solver->SetInputConnection(drill->GetOutputPort());
  FilterChecks::UpdateWithoutError(solver);
  EXPECT_EQ(this->Read(solver->GetOutput())->GetNumberOfPoints(), 0);

  // The singularities are in the holes and are included on request.
  this->Filter->IncludeHolesOn();
  vtkPolyData* holes = this->Read(solver->GetOutput());
  ASSERT_EQ(holes->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(this->At("QuarterIndex", i), 1.0);
    EXPECT_EQ(this->At("BoundaryKind", i), 3.0);
    // Without given radii a hole has a third of the distance to the boundary, a polygon of 42
    // sides.
    const double distance = 1.0 - std::hypot(holes->GetPoint(i)[0], holes->GetPoint(i)[1]);
    EXPECT_LE(this->At("Radius", i), distance / 3.0 + 1e-9);
    EXPECT_GE(this->At("Radius", i), (distance - 0.003) / 3.0);
    const auto row = static_cast<vtkIdType>(this->At("BoundaryId", i));
    EXPECT_NEAR(holes->GetPoint(i)[0], found->GetPoint(row)[0], 1e-9);
    EXPECT_NEAR(holes->GetPoint(i)[1], found->GetPoint(row)[1], 1e-9);
  }
}

TEST_F(CrossFieldSingularities, IncludesCornersOnRequest)
{
  const auto field = FieldOn({ Rectangle({ 0.0, 0.0 }, { 2.0, 1.0 }) }, 0.2);
  EXPECT_EQ(this->Read(field)->GetNumberOfPoints(), 0);
  this->Filter->IncludeCornersOn();
  ASSERT_EQ(this->Read(field)->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(this->At("QuarterIndex", i), 1.0);
    EXPECT_EQ(this->At("BoundaryKind", i), 1.0);
    EXPECT_EQ(this->At("BoundaryId", i), 0.0);
  }
}

TEST_F(CrossFieldSingularities, RejectsInputWithoutField)
{
  const auto field = FieldOn({ Circle(42, 1.0) }, 0.15);
  vtkNew<vtkUnstructuredGrid> spoiled;
  spoiled->DeepCopy(field);
  spoiled->GetCellData()->GetArray("CrossFieldCR")->Fill(std::numeric_limits<double>::quiet_NaN());
  this->Filter->SetInputData(spoiled);
  FilterChecks::CaptureError(this->Filter, { "not finite" });
  vtkNew<vtkUnstructuredGrid> bare;
  bare->DeepCopy(field);
  bare->GetCellData()->RemoveArray("CrossFieldCR");
  this->Filter->SetInputData(bare);
  FilterChecks::CaptureError(this->Filter, { "no cell array 'CrossFieldCR'" });
}
}
