// Quads of order 2 and 3 from the outputs of vtkQuadMesher and from one grid.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkQuadMesher.h"
#include "vtkQuadsToHigherOrder.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTriangle.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{
class QuadsToHigherOrder : public testing::Test
{
public:
  void SetUp() override
  {
    this->Mesher->SetInputData(TestInputs::Loops(
      { TestInputs::Rectangle({ -2.0, -2.0 }, { 2.0, 2.0 }), TestInputs::Circle(12, 1.0) }, 0.5));
    this->Mesher->SetQuadCount(100);
    this->Mesher->SetCurves("auto");
    this->Filter->SetInputConnection(this->Mesher->GetOutputPort());
    this->Filter->SetBoundaryConnection(this->Mesher->GetOutputPort(5));
  }

  double Value(const char* name)
  {
    return FilterChecks::RequireArray(this->Filter->GetOutput()->GetFieldData(), name)
      ->GetTuple1(0);
  }

  vtkNew<vtkQuadMesher> Mesher;
  vtkNew<vtkQuadsToHigherOrder> Filter;
};

/** Returns the area of a cell as a fan of small triangles between points of its parametric square. */
double AreaOf(vtkCell* cell)
{
  constexpr int Parts = 24;
  std::vector<std::array<double, 3>> places;
  std::vector<double> weights(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  for (int j = 0; j <= Parts; ++j)
  {
    for (int i = 0; i <= Parts; ++i)
    {
      const double at[3] = { static_cast<double>(i) / Parts, static_cast<double>(j) / Parts, 0.0 };
      int sub = 0;
      places.emplace_back();
      cell->EvaluateLocation(sub, at, places.back().data(), weights.data());
    }
  }
  double area = 0.0;
  for (int j = 0; j < Parts; ++j)
  {
    for (int i = 0; i < Parts; ++i)
    {
      const auto at = [&](int a, int b)
      { return places[static_cast<std::size_t>((j + b) * (Parts + 1) + i + a)].data(); };
      area += vtkTriangle::TriangleArea(at(0, 0), at(1, 0), at(1, 1)) +
        vtkTriangle::TriangleArea(at(0, 0), at(1, 1), at(0, 1));
    }
  }
  return area;
}
}

TEST_F(QuadsToHigherOrder, FollowsFilterConventions)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter, { "Order" });
  FilterChecks::CheckRunTwice(
    this->Filter, [&] { this->Filter->SetOrder(2); }, [&] { this->Filter->SetOrder(3); });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(QuadsToHigherOrder, CellsHaveVtksTypesAndOrders)
{
  for (const int order : { 2, 3 })
  {
    this->Filter->SetOrder(order);
    FilterChecks::UpdateWithoutError(this->Filter);
    vtkUnstructuredGrid* output = this->Filter->GetOutput();
    vtkDataArray* curves = FilterChecks::RequireArray(output->GetCellData(), "Curve");
    double area = 0.0;
    int onCurve = 0;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      const int type = output->GetCellType(cell);
      if (output->GetCell(cell)->GetCellDimension() == 2)
      {
        EXPECT_EQ(type, order == 2 ? VTK_BIQUADRATIC_QUAD : VTK_LAGRANGE_QUADRILATERAL);
        area += AreaOf(output->GetCell(cell));
        continue;
      }
      EXPECT_EQ(type, order == 2 ? VTK_QUADRATIC_EDGE : VTK_LAGRANGE_CURVE);
      output->GetCellPoints(cell, ids);
      ASSERT_EQ(ids->GetNumberOfIds(), order + 1);
      for (vtkIdType i = 0; i <= order; ++i)
      {
        const double* place = output->GetPoint(ids->GetId(i));
        EXPECT_EQ(place[2], 0.5);
        if (curves->GetTuple1(cell) >= 0.0)
        {
          ++onCurve;
          EXPECT_NEAR(std::hypot(place[0], place[1]), 1.0, 1e-14);
        }
      }
    }
    // Wrong orders of nodes would fold the cells and change their area.
    EXPECT_NEAR(area, 16.0 - vtkMath::Pi(), 5e-4);
    EXPECT_GT(onCurve, 8);
    EXPECT_EQ(this->Value("Order"), order);
    EXPECT_EQ(this->Value("CurvedInverted"), 0.0);
    EXPECT_GT(this->Value("JacobianRatioMin"), 0.3);
  }
}

TEST_F(QuadsToHigherOrder, ArraysFollowTheCellsAndPoints)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* output = this->Filter->GetOutput();
  vtkNew<vtkUnstructuredGrid> mesh;
  this->Mesher->CopyMesh(mesh);
  ASSERT_EQ(output->GetNumberOfCells(), mesh->GetNumberOfCells());
  for (const char* name : { "BlockId", "BoundaryKind", "BoundaryId", "Curve", "ScaledJacobian" })
  {
    vtkDataArray* before = FilterChecks::RequireArray(mesh->GetCellData(), name);
    vtkDataArray* after = FilterChecks::RequireArray(output->GetCellData(), name);
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(before->GetTuple1(cell), after->GetTuple1(cell)) << name;
    }
  }
  EXPECT_NE(output->GetCellData()->GetAbstractArray("Side"), nullptr);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < 3; ++c)
    {
      EXPECT_EQ(output->GetPoint(i)[c], mesh->GetPoint(i)[c]);
    }
  }
  vtkDataArray* valences = FilterChecks::RequireArray(output->GetPointData(), "Valence");
  vtkDataArray* sides = FilterChecks::RequireArray(output->GetPointData(), "BoundarySide");
  vtkNew<vtkIdList> cells;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    output->GetPointCells(i, cells);
    int quads = 0;
    for (vtkIdType c = 0; c < cells->GetNumberOfIds(); ++c)
    {
      quads += output->GetCell(cells->GetId(c))->GetCellDimension() == 2 ? 1 : 0;
    }
    EXPECT_EQ(valences->GetTuple1(i), quads);
    EXPECT_EQ(sides->GetTuple1(i) >= 0.0, quads < cells->GetNumberOfIds());
  }
}

TEST_F(QuadsToHigherOrder, PointArraysAreInterpolated)
{
  vtkNew<vtkUnstructuredGrid> mesh;
  this->Mesher->Update();
  this->Mesher->CopyMesh(mesh);
  vtkNew<vtkDoubleArray> linear;
  linear->SetName("Linear");
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    linear->InsertNextValue(7.0);
  }
  mesh->GetPointData()->AddArray(linear);
  this->Filter->RemoveAllInputConnections(1);
  this->Filter->SetInputData(mesh); // with its lines
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkDataArray* array =
    FilterChecks::RequireArray(this->Filter->GetOutput()->GetPointData(), "Linear");
  ASSERT_EQ(array->GetNumberOfTuples(), this->Filter->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    EXPECT_NEAR(array->GetTuple1(i), 7.0, 1e-14);
  }
}

TEST_F(QuadsToHigherOrder, WithoutCurvesEdgesAreStraight)
{
  this->Mesher->SetCurves("");
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_FALSE(this->Filter->GetOutput()->GetCellData()->HasArray("Curve"));
  EXPECT_FALSE(this->Filter->GetOutput()->GetFieldData()->HasArray("CurveSagitta"));
}

TEST_F(QuadsToHigherOrder, RefusesMeshesThatAreNotOfTheMesher)
{
  this->Filter->RemoveAllInputConnections(1);
  FilterChecks::UpdateWithoutError(this->Filter); // finds the boundary of the mesher
  vtkNew<vtkUnstructuredGrid> alone;
  alone->ShallowCopy(this->Mesher->GetOutput());
  this->Filter->SetInputData(alone);
  FilterChecks::CaptureError(this->Filter, { "The quads have no boundary edges", "Quad Mesher" });
  this->Filter->SetInputConnection(this->Mesher->GetOutputPort());
  this->Filter->SetBoundaryConnection(this->Mesher->GetOutputPort(2));
  FilterChecks::CaptureError(
    this->Filter, { "The inputs are not the quads and the boundary of one mesh" });
  this->Filter->RemoveAllInputConnections(1);
  this->Filter->SetInputData(TestInputs::DrilledDisk());
  FilterChecks::CaptureError(this->Filter, { "other cells than quads and lines" });
  vtkNew<vtkUnstructuredGrid> mesh;
  this->Mesher->CopyMesh(mesh);
  mesh->GetFieldData()->RemoveArray("CurveValues");
  this->Filter->SetInputData(mesh);
  FilterChecks::CaptureError(this->Filter, { "The curves of the domain are damaged" });
}
