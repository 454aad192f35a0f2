// Every invalid input in the class comment of vtkDrillHoles causes one error with the reason.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkDrillHoles.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <limits>

namespace
{
using FilterChecks::CaptureError;
using TestInputs::Circle;
using TestInputs::Curve;
using TestInputs::Loops;
using TestInputs::Rectangle;
using TestInputs::Row;

constexpr double NotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double Infinity = std::numeric_limits<double>::infinity();

/**
 * Filter with valid input, a square of side 4 and one hole. Each test makes one property invalid.
 */
class DrillHolesRefusals : public testing::Test
{
public:
  void SetUp() override
  {
    this->Filter->SetMeshSize(0.5);
    this->SetDomain(Loops({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }) }));
    this->SetRows({ { 1.0, 1.0, 1.0, 0.2 } });
  }

  /** Expects that valid input works after each failure. */
  void TearDown() override
  {
    this->SetUp();
    FilterChecks::UpdateWithoutError(this->Filter);
  }

  void SetDomain(vtkDataObject* domain) { this->Filter->SetInputData(domain); }
  void SetCurves(const std::vector<Curve>& curves) { this->SetDomain(Loops(curves)); }
  void SetRows(const std::vector<Row>& rows)
  {
    this->Filter->SetSingularitiesData(TestInputs::Singularities(rows));
  }

  void ExpectError(const std::vector<std::string>& parts)
  {
    EXPECT_EQ(CaptureError(this->Filter, parts), vtkErrorCode::UserError);
  }

  /** Sets the valid singularity with another array `name` of one or more components. */
  void SetArray(const char* name, const std::vector<double>& values)
  {
    auto singularities = TestInputs::Singularities({ { 1.0, 1.0, 1.0, 0.2 } });
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(static_cast<int>(values.size()));
    array->InsertNextTuple(values.data());
    singularities->GetPointData()->AddArray(array);
    this->Filter->SetSingularitiesData(singularities);
  }

  vtkNew<vtkDrillHoles> Filter;
};
}

TEST_F(DrillHolesRefusals, OpenCurve)
{
  this->SetDomain(TestInputs::OpenCurve(Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 })));
  this->ExpectError({ "open curve", "(0, " });
}

TEST_F(DrillHolesRefusals, BranchingCurve)
{
  auto domain = Loops({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }) });
  domain->GetLines()->InsertNextCell({ vtkIdType(0), vtkIdType(2) });
  this->SetDomain(domain);
  this->ExpectError({ "branches", "(0, 0)" });
}

TEST_F(DrillHolesRefusals, SelfCrossingCurve)
{
  this->SetCurves({ { { 0.0, 0.0 }, { 4.0, 4.0 }, { 4.0, 0.0 }, { 0.0, 5.0 } } });
  this->ExpectError({ "crosses or touches itself" });
}

TEST_F(DrillHolesRefusals, TouchingCurves)
{
  const Curve square = Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 });
  this->SetCurves({ square, { { 0.0, 2.0 }, { 1.0, 1.5 }, { 1.0, 2.5 } } });
  this->ExpectError({ "crosses or touches itself" });
  this->SetCurves({ square, { { 0.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 2.0 } } });
  this->ExpectError({ "branches" });
}

TEST_F(DrillHolesRefusals, CrossingLoops)
{
  this->SetCurves({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }), Circle(20, 1.0, { 4.0, 2.0 }) });
  this->ExpectError({ "crosses or touches itself" });
}

TEST_F(DrillHolesRefusals, SeveralOuterLoops)
{
  this->SetCurves({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }), Rectangle({ 5.0, 0.0 }, { 6.0, 1.0 }) });
  this->ExpectError({ "several outer loops" });
}

TEST_F(DrillHolesRefusals, IslandInTheIsland)
{
  this->SetCurves({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }), Rectangle({ 2.0, 2.0 }, { 3.0, 3.0 }),
    Rectangle({ 2.4, 2.4 }, { 2.6, 2.6 }) });
  this->ExpectError({ "2 parts" });
}

TEST_F(DrillHolesRefusals, LoopWithoutArea)
{
  this->SetCurves({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 0.0 } } });
  this->ExpectError({});
}

TEST_F(DrillHolesRefusals, DomainOutOfThePlane)
{
  auto domain = Loops({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }) });
  domain->GetPoints()->SetPoint(2, 4.0, 4.0, 1.5);
  this->SetDomain(domain);
  this->ExpectError({ "not planar", "0.37391", "5.85235" }); // the deviation and the size
}

TEST_F(DrillHolesRefusals, DomainWithoutCurves)
{
  this->SetDomain(TestInputs::Singularities({ { 1.0, 1.0, 1.0, 0.2 } }));
  this->ExpectError({ "no boundary lines" });
}

TEST_F(DrillHolesRefusals, NumbersOfTheDomainThatAreNotFinite)
{
  for (double bad : { NotANumber, Infinity, -Infinity })
  {
    for (int coordinate = 0; coordinate < 3; ++coordinate)
    {
      auto domain = Loops({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }) });
      double point[3];
      domain->GetPoint(1, point);
      point[coordinate] = bad;
      domain->GetPoints()->SetPoint(1, point);
      this->SetDomain(domain);
      this->ExpectError({ "Point 1 ", "not finite" });
    }
  }
}

TEST_F(DrillHolesRefusals, NonManifoldMesh)
{
  auto mesh = TestInputs::FrameMesh();
  const vtkIdType tip = mesh->GetPoints()->InsertNextPoint(0.7, 0.3, 0.0);
  mesh->GetPolys()->InsertNextCell({ vtkIdType(0), vtkIdType(8), tip });
  this->SetDomain(mesh);
  this->ExpectError({ "more than two cells" });
}

TEST_F(DrillHolesRefusals, MeshFoldedOver)
{
  // Two triangles on the same side of their common edge, whose boundary is still a loop.
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(4.0, 0.0, 0.0);
  points->InsertNextPoint(2.0, 4.0, 0.0);
  points->InsertNextPoint(2.0, 1.0, 0.0);
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ vtkIdType(0), vtkIdType(1), vtkIdType(2) });
  cells->InsertNextCell({ vtkIdType(1), vtkIdType(0), vtkIdType(3) });
  vtkNew<vtkPolyData> mesh;
  mesh->SetPoints(points);
  mesh->SetPolys(cells);
  this->SetDomain(mesh);
  this->ExpectError({ "add up to 10", "encloses 6", "fold over" });
}

TEST_F(DrillHolesRefusals, Cells3D)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 1.0);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  const vtkIdType ids[4] = { 0, 1, 2, 3 };
  grid->InsertNextCell(VTK_TETRA, 4, ids);
  this->SetDomain(grid);
  this->ExpectError({ "vtkTetra" });
}

TEST_F(DrillHolesRefusals, HoleOutside)
{
  this->SetRows({ { 1.0, 1.0, 1.0, 0.2 }, { 7.0, 1.0, 1.0, 0.2 } });
  this->ExpectError({ "singularity 2 at (7, 1)", "outside" });
  // The inside of an island is outside the domain.
  this->SetCurves({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }), Rectangle({ 2.0, 2.0 }, { 3.0, 3.0 }) });
  this->SetRows({ { 2.5, 2.5, 1.0, 0.2 } });
  this->ExpectError({ "singularity 1 at (2.5, 2.5)", "outside" });
}

TEST_F(DrillHolesRefusals, HoleCutsTheBoundary)
{
  this->SetRows({ { 1.0, 0.1, 1.0, 0.2 } });
  this->ExpectError({ "singularity 1 at (1, 0.1)", "cuts the boundary", "0.2" });
  this->SetRows({ { 1.0, 0.25, 1.0, 0.25 } }); // touches the boundary
  this->ExpectError({ "cuts the boundary" });
}

TEST_F(DrillHolesRefusals, HoleAroundAnIsland)
{
  this->SetCurves({ Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }), Circle(16, 0.1, { 2.0, 2.0 }) });
  this->SetRows({ { 2.3, 2.0, 1.0, 0.5 } });
  this->ExpectError({ "cuts the boundary" });
}

TEST_F(DrillHolesRefusals, OverlappingHoles)
{
  this->SetRows({ { 1.0, 1.0, 1.0, 0.2 }, { 3.0, 3.0, 1.0, 0.2 }, { 1.3, 1.0, 1.0, 0.15 } });
  this->ExpectError({ "singularity 1 at (1, 1)", "singularity 3 at (1.3, 1)", "overlap" });
  this->SetRows({ { 1.0, 1.0, 1.0, 0.2 }, { 1.0, 1.0, 1.0, 0.2 } });
  this->ExpectError({ "overlap" });
  this->SetRows({ { 2.0, 2.0, 1.0, 1.0 }, { 2.1, 2.0, 1.0, 0.1 } }); // one inside the other
  this->ExpectError({ "overlap" });
}

TEST_F(DrillHolesRefusals, RadiusThatIsNotPositive)
{
  this->SetRows({ { 1.0, 1.0, 1.0, -0.2 } });
  this->ExpectError({ "singularity 1", "not positive" });
  this->SetRows({ { 1.0, 1.0, 1.0, 0.0 } });
  this->ExpectError({ "singularity 1", "not positive" });
}

TEST_F(DrillHolesRefusals, NumbersOfTheSingularitiesThatAreNotFinite)
{
  for (double bad : { NotANumber, Infinity, -Infinity })
  {
    this->SetRows({ { bad, 1.0, 1.0, 0.2 } });
    this->ExpectError({ "Row 1", "not a finite number" });
    this->SetRows({ { 1.0, bad, 1.0, 0.2 } });
    this->ExpectError({ "Row 1", "not a finite number" });
    this->SetRows({ { 1.0, 1.0, 1.0, bad } });
    this->ExpectError({ "radius" });
    this->SetArray("QuarterIndex", { bad });
    this->ExpectError({ "quarter index of singularity 1", "not an integer" });
  }
}

TEST_F(DrillHolesRefusals, QuarterIndexThatIsNotAnInteger)
{
  this->SetArray("QuarterIndex", { 0.25 });
  this->ExpectError({ "quarter index of singularity 1", "not an integer" });
  this->SetArray("QuarterIndex", { NotANumber });
  this->ExpectError({ "quarter index of singularity 1", "not an integer" });
}

TEST_F(DrillHolesRefusals, QuarterIndexBeyondTheLargest)
{
  for (double bad : { 1001.0, -1001.0, 2147483647.0, -2147483648.0, 1e300 })
  {
    this->SetArray("QuarterIndex", { bad });
    this->ExpectError({ "quarter index of singularity 1", "beyond 1000" });
  }
}

TEST_F(DrillHolesRefusals, DomainTooFarFromTheOrigin)
{
  this->SetDomain(Loops({ Rectangle({ 1e13, 0.0 }, { 1e13 + 4.0, 4.0 }) }));
  this->SetRows({});
  this->ExpectError({ "move the domain to the origin" });
}

TEST_F(DrillHolesRefusals, PointsThatCountAsOne)
{
  // A slit of width 1e-10, whose end points are merged so that the loop is no longer closed.
  this->SetDomain(Loops(
    { Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }), Rectangle({ 2.0, 2.0 }, { 3.0, 2.0 + 1e-10 }) }));
  this->ExpectError({ "count as one" });
}

TEST_F(DrillHolesRefusals, ArraysThatAreMissingOrHaveTheWrongSize)
{
  vtkNew<vtkPolyData> bare;
  bare->CopyStructure(TestInputs::Singularities({ { 1.0, 1.0, 1.0, 0.2 } }));
  this->Filter->SetSingularitiesData(bare);
  this->ExpectError({ "'QuarterIndex'" });
  this->SetArray("QuarterIndex", { 1.0, 1.0 });
  this->ExpectError({ "'QuarterIndex'" });
  this->SetArray("Radius", { 0.2, 0.2 });
  this->ExpectError({ "'Radius'" });
}

TEST_F(DrillHolesRefusals, MeshSizeThatIsNotALength)
{
  for (double bad : { -0.1, NotANumber, Infinity })
  {
    this->Filter->SetMeshSize(bad);
    this->ExpectError({ "mesh size" });
  }
}
