// Curves of sides in vtkQuadMesher and vtkBoundarySimplifier: declared, recognised, given as arrays.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkBoundarySimplifier.h"
#include "vtkQuadMesher.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
/** Returns the largest distance of the boundary nodes of a mesher from the unit circle. */
double DistanceFromCircle(vtkQuadMesher* mesher)
{
  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5));
  double largest = 0.0;
  for (vtkIdType i = 0; i < boundary->GetNumberOfPoints(); ++i)
  {
    const double* place = boundary->GetPoint(i);
    largest = std::max(largest, std::abs(std::hypot(place[0], place[1]) - 1.0));
  }
  return largest;
}

/** Adds a circle of a radius as the curve of all lines of a domain, with the values of a reader. */
void AddCircle(vtkPolyData* domain, double radius)
{
  vtkNew<vtkIntArray> curve;
  curve->SetName("Curve");
  for (vtkIdType i = 0; i < domain->GetNumberOfCells(); ++i)
  {
    curve->InsertNextValue(0);
  }
  domain->GetCellData()->AddArray(curve);
  vtkNew<vtkStringArray> kind;
  kind->SetName("CurveKind");
  kind->InsertNextValue("circle");
  vtkNew<vtkIdTypeArray> offset;
  offset->SetName("CurveOffset");
  offset->InsertNextValue(0);
  offset->InsertNextValue(4);
  vtkNew<vtkDoubleArray> values;
  values->SetName("CurveValues");
  for (const double value : { 0.0, 0.0, radius, 0.0 })
  {
    values->InsertNextValue(value);
  }
  domain->GetFieldData()->AddArray(kind);
  domain->GetFieldData()->AddArray(offset);
  domain->GetFieldData()->AddArray(values);
}

class QuadMesherCurves : public testing::Test
{
public:
  void SetUp() override
  {
    this->Domain = TestInputs::Loops({ TestInputs::Circle(16, 1.0) });
    this->Mesher->SetInputData(this->Domain);
    this->Mesher->SetQuadCount(150);
  }

  vtkSmartPointer<vtkPolyData> Domain;
  vtkNew<vtkQuadMesher> Mesher;
};
}

TEST_F(QuadMesherCurves, PlaceNodesOnDeclaredAndRecognisedCircles)
{
  FilterChecks::UpdateWithoutError(this->Mesher);
  EXPECT_GT(DistanceFromCircle(this->Mesher), 1e-3);
  for (const char* curves : { "outer0:circle", "auto", " auto ; ", "outer0:ellipse" })
  {
    this->Mesher->SetCurves(curves);
    FilterChecks::UpdateWithoutError(this->Mesher);
    EXPECT_LT(DistanceFromCircle(this->Mesher), 1e-14) << curves;
  }
  this->Mesher->SetCurves("auto; outer0:line");
  FilterChecks::UpdateWithoutError(this->Mesher);
  EXPECT_GT(DistanceFromCircle(this->Mesher), 1e-3);
}

TEST_F(QuadMesherCurves, FollowFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Mesher, [&] { this->Mesher->SetCurves("auto"); }, [&] { this->Mesher->SetCurves(""); });
  FilterChecks::CheckInputUntouched(this->Mesher);
  FilterChecks::CheckPrintSelf(this->Mesher, { "Curves" });
}

TEST_F(QuadMesherCurves, AreWrittenToTheBoundaryAndToTheMesh)
{
  this->Mesher->SetCurves("auto");
  FilterChecks::UpdateWithoutError(this->Mesher);
  vtkNew<vtkUnstructuredGrid> mesh;
  this->Mesher->CopyMesh(mesh);
  auto* boundary = vtkDataSet::SafeDownCast(this->Mesher->GetOutputDataObject(5));
  for (vtkDataSet* data : { boundary, static_cast<vtkDataSet*>(mesh) })
  {
    EXPECT_EQ(
      FilterChecks::RequireArray(data->GetFieldData(), "CurveValues")->GetNumberOfTuples(), 4);
    vtkDataArray* curves = FilterChecks::RequireArray(data->GetCellData(), "Curve");
    for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
    {
      EXPECT_EQ(curves->GetTuple1(cell), data->GetCell(cell)->GetCellDimension() == 1 ? 0.0 : -1.0);
    }
  }
  vtkFieldData* report = this->Mesher->GetOutputDataObject(8)->GetFieldData();
  EXPECT_EQ(
    FilterChecks::RequireArray(report, "CurveEdges")->GetTuple1(0), boundary->GetNumberOfCells());
  EXPECT_NEAR(FilterChecks::RequireArray(report, "CurveMoved")->GetTuple1(0),
    1.0 - std::cos(vtkMath::Pi() / 16.0), 2e-3);
}

TEST_F(QuadMesherCurves, OfTheDomainAreUsedAndReplaced)
{
  AddCircle(this->Domain, 1.0);
  FilterChecks::UpdateWithoutError(this->Mesher);
  EXPECT_LT(DistanceFromCircle(this->Mesher), 1e-14);
  this->Mesher->SetCurves("outer0:line");
  FilterChecks::UpdateWithoutError(this->Mesher);
  EXPECT_GT(DistanceFromCircle(this->Mesher), 1e-3);
  EXPECT_FALSE(this->Mesher->GetOutputDataObject(5)->GetFieldData()->HasArray("CurveKind"));

  this->Mesher->SetCurves("");
  AddCircle(this->Domain, 1.001);
  this->Domain->Modified();
  FilterChecks::CaptureError(
    this->Mesher, { "Curve 0 of the domain misses the point", "by 0.001" });
  this->Domain->GetFieldData()->RemoveArray("CurveKind");
  this->Domain->Modified();
  FilterChecks::CaptureError(this->Mesher, { "The curves of the domain are damaged" });
}

TEST_F(QuadMesherCurves, SurviveTheSimplificationOfTheBoundary)
{
  vtkNew<vtkBoundarySimplifier> simplifier;
  simplifier->SetInputData(TestInputs::Loops({ TestInputs::Circle(2000, 1.0) }));
  simplifier->SetThinningLength(0.02);
  simplifier->SetCurves("outer0:spline");
  FilterChecks::UpdateWithoutError(simplifier);
  FilterChecks::CheckInputUntouched(simplifier);
  FilterChecks::CheckPrintSelf(simplifier, { "Curves" });
  vtkDataSet* simple = FilterChecks::Output(simplifier);
  EXPECT_LT(simple->GetNumberOfPoints(), 1000);
  EXPECT_GT(FilterChecks::RequireArray(simple->GetFieldData(), "CurveValues")->GetNumberOfTuples(),
    2000 * 9); // fitted to all points
  this->Mesher->SetInputConnection(simplifier->GetOutputPort());
  FilterChecks::UpdateWithoutError(this->Mesher);
  EXPECT_LT(DistanceFromCircle(this->Mesher), 1e-11);

  // Nothing is removed, but the curves are added; given ones pass.
  simplifier->SetInputData(this->Domain);
  simplifier->SetCurves("auto");
  FilterChecks::UpdateWithoutError(this->Mesher);
  EXPECT_LT(DistanceFromCircle(this->Mesher), 1e-14);
  vtkSmartPointer<vtkPolyData> many = TestInputs::Loops({ TestInputs::Circle(2000, 1.0) });
  AddCircle(many, 1.0);
  simplifier->SetInputData(many);
  simplifier->SetCurves("");
  FilterChecks::UpdateWithoutError(this->Mesher);
  EXPECT_LT(FilterChecks::Output(simplifier)->GetNumberOfPoints(), 1000);
  EXPECT_LT(DistanceFromCircle(this->Mesher), 1e-14);
}

TEST_F(QuadMesherCurves, RefuseTextsAndSidesThatAreNotValid)
{
  this->Mesher->SetCurves("outer0:oval");
  FilterChecks::CaptureError(this->Mesher, { "The curve 'outer0:oval' is not of the form" });
  this->Mesher->SetCurves("hole:circle");
  FilterChecks::CaptureError(this->Mesher, { "no side 'hole' for a curve", "outer0" });
  this->Mesher->SetInputData(TestInputs::Loops({ TestInputs::Rectangle({ 0, 0 }, { 1, 1 }) }));
  this->Mesher->SetCurves("outer0:circle");
  FilterChecks::CaptureError(
    this->Mesher, { "Side 'outer0' is declared as circle", "three points" });
  vtkNew<vtkBoundarySimplifier> simplifier;
  simplifier->SetInputData(this->Domain);
  simplifier->SetCurves("outer0:oval");
  FilterChecks::CaptureError(simplifier, { "The curve 'outer0:oval' is not of the form" });
}
