// Quads in a plane in space, with and without lines beside them.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkSmoothQuads.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace
{
/** A grid of quads in a plane in space, with points inside moved along its axes and a point array. */
vtkSmartPointer<vtkPolyData> MovedPlane(int n, double part)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> quads;
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Number");
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const bool isInside = i % n != 0 && j % n != 0;
      const double s = (i + (isInside ? part * std::sin(7.0 * i + 3.0 * j) : 0.0)) / n;
      const double t = (j + (isInside ? part * std::sin(5.0 * i - 2.0 * j) : 0.0)) / n;
      const vtkIdType id = points->InsertNextPoint(1.0 + 2.0 * s, 2.0 + 2.0 * t, 3.0 + s + 0.5 * t);
      numbers->InsertNextValue(static_cast<double>(id));
      if (i < n && j < n)
      {
        quads->InsertNextCell({ id, id + 1, id + n + 2, id + n + 1 });
      }
    }
  }
  vtkSmartPointer<vtkPolyData> mesh = vtkSmartPointer<vtkPolyData>::New();
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  mesh->GetPointData()->AddArray(numbers);
  return mesh;
}

class SmoothQuads : public testing::Test
{
public:
  double Minimum(const char* name)
  {
    return FilterChecks::RequireArray(this->Filter->GetOutput()->GetFieldData(), name)
      ->GetComponent(0, 0);
  }

  vtkNew<vtkSmoothQuads> Filter;
};
}

TEST_F(SmoothQuads, QuadsOfAPlaneInSpaceBecomeBetter)
{
  const vtkSmartPointer<vtkPolyData> mesh = MovedPlane(12, 0.4);
  this->Filter->SetInputData(mesh);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_LT(this->Minimum("ScaledJacobianRangeBefore"), 0.7);
  EXPECT_GT(this->Minimum("ScaledJacobianRange"), 0.9);
  EXPECT_EQ(this->Minimum("Inverted"), 0.0);
  vtkPointSet* output = this->Filter->GetOutput();
  EXPECT_TRUE(output->IsA("vtkPolyData"));
  EXPECT_EQ(output->GetNumberOfCells(), 144);
  vtkDataArray* jacobians = FilterChecks::RequireArray(output->GetCellData(), "ScaledJacobian");
  EXPECT_DOUBLE_EQ(jacobians->GetRange()[0], this->Minimum("ScaledJacobianRange"));
  EXPECT_NE(output->GetPointData()->GetArray("Number"), nullptr);
  const double normal[3] = { -2.0, -1.0, 4.0 }; // (2, 0, 1) × (0, 2, 1/2)
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    EXPECT_NEAR(
      normal[0] * (p[0] - 1.0) + normal[1] * (p[1] - 2.0) + normal[2] * (p[2] - 3.0), 0.0, 1e-12);
  }
}

TEST_F(SmoothQuads, PointsMoveToASurfaceAndStayOnIt)
{
  const vtkSmartPointer<vtkPolyData> mesh = MovedPlane(12, 0.4);
  vtkNew<vtkPolyData> hill;
  hill->DeepCopy(MovedPlane(30, 0.0));
  for (vtkIdType i = 0; i < hill->GetNumberOfPoints(); ++i)
  {
    double p[3];
    hill->GetPoint(i, p);
    hill->GetPoints()->SetPoint(i, p[0], p[1], p[2] + 0.3 * std::sin(p[0]) * std::sin(p[1]));
  }
  this->Filter->SetInputData(mesh);
  this->Filter->SetSurfaceData(hill);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_GT(this->Minimum("ScaledJacobianRange"), 0.85);
  vtkPointSet* output = this->Filter->GetOutput();
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    double p[3];
    output->GetPoint(i, p);
    const double height = 3.0 + 0.5 * (p[0] - 1.0) + 0.25 * (p[1] - 2.0);
    EXPECT_NEAR(p[2], height + 0.3 * std::sin(p[0]) * std::sin(p[1]), 1e-3);
  }
  // Without the surface, the quads on it are in no plane.
  vtkNew<vtkPolyData> bent;
  bent->DeepCopy(output);
  this->Filter->SetInputData(bent);
  FilterChecks::UpdateWithoutError(this->Filter);
  this->Filter->SetSurfaceData(nullptr);
  FilterChecks::CaptureError(this->Filter, { "not planar" });
}

TEST_F(SmoothQuads, KeepsLinesAndPointsThatNoQuadHas)
{
  vtkNew<vtkPolyData> mesh;
  mesh->DeepCopy(MovedPlane(6, 0.3));
  const vtkIdType single = mesh->GetPoints()->InsertNextPoint(1.0, 2.0, 3.0);
  mesh->GetPointData()->Initialize(); // the array would lack a tuple
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, single });
  mesh->SetLines(lines);
  const vtkSmartPointer<vtkUnstructuredGrid> grid = TestInputs::AsUnstructuredGrid(mesh);
  this->Filter->SetInputData(grid);
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkPointSet* output = this->Filter->GetOutput();
  EXPECT_TRUE(output->IsA("vtkUnstructuredGrid"));
  EXPECT_EQ(output->GetNumberOfCells(), 37);
  EXPECT_EQ(output->GetPoint(single)[0], 1.0);
  EXPECT_EQ(
    FilterChecks::RequireArray(output->GetCellData(), "ScaledJacobian")->GetRange()[1], 1.0);
}

TEST_F(SmoothQuads, WarnsAboutInvertedQuads)
{
  // One quad whose last corner is moved across the opposite ones: all four are on the boundary.
  const vtkSmartPointer<vtkPolyData> mesh = MovedPlane(1, 0.0);
  mesh->GetPoints()->SetPoint(0, 3.0, 3.5, 4.375);
  this->Filter->SetInputData(mesh);
  this->Filter->SlideOnBoundaryOff();
  FilterChecks::MessageRecorder recorder(this->Filter);
  this->Filter->Update();
  ASSERT_EQ(recorder.warnings.size(), 1U);
  EXPECT_NE(recorder.warnings[0].find("1 quad is inverted near"), std::string::npos);
}

TEST_F(SmoothQuads, RefusesOtherCells)
{
  this->Filter->SetInputData(TestInputs::FrameMesh());
  FilterChecks::CaptureError(
    this->Filter, { "has cells that are not quads", "give a mesh of quads" });
}

TEST_F(SmoothQuads, KeepsTheConventionsOfFilters)
{
  const vtkSmartPointer<vtkPolyData> mesh = MovedPlane(10, 0.3);
  this->Filter->SetInputData(mesh);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckRunTwice(
    this->Filter, [&] { this->Filter->UniformSizesOff(); },
    [&] { this->Filter->UniformSizesOn(); });
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter, { "SlideOnBoundary", "CornerAngle", "UniformSizes" });
  FilterChecks::CheckEmptyInput(this->Filter);
}
