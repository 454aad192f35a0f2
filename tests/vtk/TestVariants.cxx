// Imprinted circles, single triangles, and the variants of vtkPerforatedCrossField for them.
#include "support/FieldReading.h"
#include "support/FilterChecks.h"
#include "support/PerforatedCrossFieldTest.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkCellData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>
#include <numeric>

namespace
{
using TestInputs::Circle;

/** Fixture with the constrained method, which all variants use. */
class Variants : public PerforatedCrossField
{
public:
  Variants() { this->Filter->SetMethodToConstrained(); }
};

constexpr double MeshSize = 0.12;

vtkSmartPointer<vtkUnstructuredGrid> Disk(int mode, const std::vector<TestInputs::Row>& rows)
{
  return TestInputs::Drill(TestInputs::Loops({ Circle(52, 1.0) }), rows, MeshSize, mode);
}

vtkSmartPointer<vtkUnstructuredGrid> Imprinted()
{
  return Disk(vtkDrillHoles::ModeImprint, TestInputs::FourOnDisk());
}

/** Returns the sum of the quarter indices that vtkCrossFieldSingularities finds. */
double SumFound(vtkUnstructuredGrid* field)
{
  vtkNew<vtkCrossFieldSingularities> filter;
  filter->SetInputData(field);
  filter->Update();
  vtkDataArray* quarters = filter->GetOutput()->GetPointData()->GetArray("QuarterIndex");
  double sum = 0.0;
  for (vtkIdType i = 0; i < quarters->GetNumberOfTuples(); ++i)
  {
    sum += quarters->GetComponent(i, 0);
  }
  return sum;
}
}

TEST(DrillModes, FollowsFilterConventions)
{
  vtkNew<vtkDrillHoles> filter;
  EXPECT_EQ(filter->GetMode(), vtkDrillHoles::ModePerforate);
  FilterChecks::CheckPrintSelf(filter, { "Mode" });
  filter->SetSingularitiesData(TestInputs::Singularities(TestInputs::FourOnDisk()));
  filter->SetMeshSize(MeshSize);
  for (const int mode : { vtkDrillHoles::ModeImprint, vtkDrillHoles::ModeTriangle })
  {
    filter->SetMode(mode);
    FilterChecks::CheckRunTwice(
      filter, [&] { filter->SetInputData(TestInputs::Loops({ Circle(52, 1.0) })); },
      [&] { filter->SetInputData(TestInputs::Loops({ Circle(40, 1.5) })); });
    FilterChecks::CheckInputUntouched(filter);
    FilterChecks::CheckProgressAndAbort(filter);
  }
  FilterChecks::CheckEmptyInput(filter);
}

TEST(DrillModes, WriteLinesOfKindFour)
{
  for (const int mode : { vtkDrillHoles::ModeImprint, vtkDrillHoles::ModeTriangle })
  {
    auto rows = TestInputs::FourOnDisk();
    rows[2][2] = -1.0;
    const MeshReading mesh(Disk(mode, rows));
    EXPECT_NEAR(mesh.Area(), 26.0 * std::sin(std::acos(-1.0) / 26.0),
      1e-9); // area of the polygon without holes
    for (int row = 0; row < 4; ++row)
    {
      const auto lines = mesh.OrderedLoop(4, row);
      EXPECT_EQ(lines.size() == 3, mode == vtkDrillHoles::ModeTriangle);
      for (const std::size_t line : lines)
      {
        EXPECT_EQ(mesh.lines[line].quarterIndex, row == 2 ? -1 : 1);
        // Each imprinted line has a triangle on either side.
        const auto& [from, to] = mesh.lines[line].points;
        EXPECT_EQ(mesh.sides.count({ from, to }), 1u);
        EXPECT_EQ(mesh.sides.count({ to, from }), 1u);
      }
    }
  }
}

TEST(DrillModes, RejectInvalidSingularities)
{
  vtkNew<vtkDrillHoles> filter;
  filter->SetInputData(TestInputs::Loops({ Circle(52, 1.0) }));
  filter->SetModeToTriangle();
  filter->SetSingularitiesData(TestInputs::Singularities({ { 0.0, 0.0, 2.0, 0.1 } }));
  FilterChecks::CaptureError(filter, { "quarter index 2", "1 or -1 only" });
  filter->SetSingularitiesData(
    TestInputs::Singularities({ { 0.1, 0.1, 1.0, 0.1 }, { 0.1, 0.1, 1.0, 0.1 } }));
  FilterChecks::CaptureError(filter, { "share an edge" });
  filter->SetSingularitiesData(TestInputs::Singularities({ { 2.0, 0.0, 1.0, 0.1 } }));
  FilterChecks::CaptureError(filter, { "outside the domain" });
}

TEST_F(Variants, Defaults)
{
  EXPECT_FALSE(this->Filter->GetGlobalConstraint());
  EXPECT_EQ(this->Filter->GetEpsilon(), 0.0);
  FilterChecks::CheckPrintSelf(this->Filter, { "UnitHoleRows", "GlobalConstraint", "Epsilon" });
}

TEST_F(Variants, FollowsFilterConventions)
{
  this->Filter->SetEpsilon(0.2);
  this->Filter->SetInputData(Imprinted());
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Filter->SetInputData(Imprinted()); },
    [this] { this->Filter->SetInputData(TestInputs::DrilledDisk()); });
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(Variants, FieldContinuesInsideImprintedCircles)
{
  const FieldReading field(this->Solve(Imprinted()));
  EXPECT_NEAR(this->Value("Energy"), field.Energy(), 1e-9 * field.Energy());
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_EQ(this->Value("DegreesReached"), 1.0);
  EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
  EXPECT_EQ(this->Value("EulerCharacteristic"), 1.0);
  EXPECT_EQ(this->Value("GivenInteriorQuarters"), 4.0);
  vtkFieldData* report = this->Filter->GetOutput()->GetFieldData();
  ExpectArray(report, "HoleDegree", VTK_INT, 1, 4);
  ExpectArray(report, "HoleNormRange", VTK_DOUBLE, 2, 4);
  EXPECT_EQ(report->GetArray("Epsilon"), nullptr);
  EXPECT_EQ(SumFound(this->Filter->GetOutput()), 4.0);
  for (std::size_t line = 0; line < field.lines.size(); ++line)
  {
    // The value on a line is the value at that edge of both triangles.
    const auto& [from, to] = field.lines[line].points;
    const auto& [triangle, side] = field.sides.at({ from, to });
    EXPECT_EQ(field.OnLine(line), field.At(field.triangles[triangle].cell)[side]);
  }

  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputData(this->Filter->GetOutput());
  FilterChecks::UpdateWithoutError(check);
  vtkFieldData* checked = check->GetOutput()->GetFieldData();
  EXPECT_EQ(FilterChecks::RequireArray(checked, "Consistent")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(FilterChecks::RequireArray(checked, "UnwantedSingularities")->GetComponent(0, 0), 0.0);
}

TEST_F(Variants, GinzburgLandauIgnoresImprintedCircles)
{
  vtkNew<vtkGinzburgLandauCrossField> reference;
  reference->SetEpsilon(0.15);
  reference->SetInputData(Imprinted());
  FilterChecks::UpdateWithoutError(reference);
  EXPECT_EQ(SumFound(reference->GetOutput()), 4.0);
}

TEST_F(Variants, UnitHolesAreChosenByRow)
{
  this->Filter->AddUnitHole(2);
  this->Filter->AddUnitHole(0);
  this->Solve(Imprinted());
  EXPECT_EQ(this->Value("UnitHoles"), 1.0);
  vtkDataArray* norms =
    FilterChecks::RequireArray(this->Filter->GetOutput()->GetFieldData(), "HoleNormRange");
  for (int row = 0; row < 4; ++row)
  {
    const bool unit =
      norms->GetComponent(row, 0) > 1.0 - 1e-9 && norms->GetComponent(row, 1) < 1.0 + 1e-9;
    EXPECT_EQ(unit, row == 0 || row == 2) << row;
  }
  this->Filter->RemoveAllUnitHoles();
  this->Solve(Imprinted());
  EXPECT_EQ(this->Value("UnitHoles"), 0.0);
  this->Filter->AddUnitHole(4);
  FilterChecks::CaptureError(this->Filter, { "hole 4" });
}

TEST_F(Variants, GlobalConstraintDoesNotIncreaseTheEnergy)
{
  this->Solve(TestInputs::DrilledDisk());
  const double each = this->Value("Energy");
  this->Filter->GlobalConstraintOn();
  this->Solve(TestInputs::DrilledDisk());
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_EQ(this->Value("DegreesReached"), 1.0);
  EXPECT_LE(this->Value("Energy"), each * (1.0 + 1e-9));
  EXPECT_GT(this->Value("Energy"), 0.99 * each);
}

TEST_F(Variants, PenaltyAllowsAnySumAndReportsOtherSingularities)
{
  const auto five = Disk(vtkDrillHoles::ModePerforate,
    { { 0.6, 0.0, 1.0, 0.1 }, { 0.18, 0.57, 1.0, 0.1 }, { -0.49, 0.35, 1.0, 0.1 },
      { -0.49, -0.35, 1.0, 0.1 }, { 0.18, -0.57, 1.0, 0.1 } });
  this->Filter->SetInputData(five);
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "add up to 5", "requires 4" }),
    vtkCrossFieldErrorCodes::Inconsistent);
  this->Filter->SetEpsilon(0.1);
  this->Solve(five);
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_EQ(this->Value("DegreesReached"), 1.0);
  EXPECT_EQ(this->Value("Consistent"), 0.0);
  EXPECT_EQ(this->Value("UnwantedSingularities"), 1.0);
  EXPECT_EQ(this->Value("Epsilon"), 0.1);
  EXPECT_NEAR(this->Value("GradientEnergy") + this->Value("PenaltyEnergy"), this->Value("Energy"),
    1e-9 * this->Value("Energy"));
  EXPECT_EQ(SumFound(this->Filter->GetOutput()), -1.0);

  // Field data of earlier options is removed from the report.
  const auto field = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPerforatedCrossField> plain;
  this->Solve(TestInputs::DrilledDisk());
  field->DeepCopy(this->Filter->GetOutput());
  EXPECT_NE(field->GetFieldData()->GetArray("PenaltyEnergy"), nullptr);
  plain->SetInputData(field);
  FilterChecks::UpdateWithoutError(plain);
  EXPECT_EQ(plain->GetOutput()->GetFieldData()->GetArray("PenaltyEnergy"), nullptr);
}

TEST_F(Variants, RejectsInvalidCombinations)
{
  this->Filter->SetMethodToUnitNorm();
  this->Filter->SetInputData(Imprinted());
  FilterChecks::CaptureError(this->Filter, { "needs holes" });
  this->Filter->SetMethodToConstrained();
  this->Filter->SetEpsilon(0.1);
  this->Filter->UnitHolesOn();
  FilterChecks::CaptureError(this->Filter, { "cannot be combined" });
}
