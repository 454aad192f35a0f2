// Method, initial field and additional constraints of vtkPerforatedCrossField.

#include "support/FieldReading.h"
#include "support/FilterChecks.h"
#include "support/PerforatedCrossFieldTest.h"
#include "support/TestInputs.h"

#include <algorithm>
#include <cmath>

namespace
{
using Complex = std::complex<double>;
using PerforatedCrossFieldMethods = PerforatedCrossField;
}

TEST_F(PerforatedCrossFieldMethods, ConstrainedFollowsFilterConventions)
{
  this->Filter->SetMethodToConstrained();
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Filter->SetInputData(TestInputs::DrilledDisk()); },
    [this] { this->Filter->SetInputData(TestInputs::DrilledDisk(0.2)); });
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(PerforatedCrossFieldMethods, UnitNormIsTheDefault)
{
  EXPECT_EQ(
    vtkNew<vtkPerforatedCrossField>()->GetMethod(), vtkPerforatedCrossField::MethodUnitNorm);
}

TEST_F(PerforatedCrossFieldMethods, UnwantedSingularitiesAreAWarning)
{
  // The holes beside the island are far from the singularities of the relaxed field.
  this->Filter->SetStartToHarmonic();
  this->Filter->SetInputData(TestInputs::DrilledIsland());
  for (const bool unitNorm : { false, true })
  {
    this->Filter->SetMethod(unitNorm ? vtkPerforatedCrossField::MethodUnitNorm
                                     : vtkPerforatedCrossField::MethodConstrained);
    FilterChecks::MessageRecorder messages(this->Filter);
    this->Filter->Update();
    EXPECT_TRUE(messages.errors.empty());
    EXPECT_EQ(messages.warnings.empty(), unitNorm);
    EXPECT_EQ(this->Value("UnwantedSingularities") == 0.0, unitNorm);
    const auto [text, isAlarm] = FilterChecks::TextForView(this->Filter, 1, "Summary");
    EXPECT_EQ(isAlarm, !unitNorm);
    const std::string number =
      unitNorm ? "No" : std::to_string(static_cast<int>(this->Value("UnwantedSingularities")));
    EXPECT_EQ(text.find(number + " unwanted"), 0U) << text;
  }
}

TEST_F(PerforatedCrossFieldMethods, UnitNormIsUnitAndTurnsAsPrescribed)
{
  this->Filter->SetMethodToUnitNorm();
  for (const auto& mesh : { TestInputs::DrilledDisk(), TestInputs::DrilledIsland() })
  {
    const FieldReading field(this->Solve(mesh));
    double energy = 0.0;
    double deviation = 0.0;
    for (std::size_t t = 0; t < field.triangles.size(); ++t)
    {
      for (const Complex& u : field.At(field.triangles[t].cell))
      {
        deviation = std::max(deviation, std::abs(std::abs(u) - 1.0));
      }
      energy += field.PhaseEnergy(t);
    }
    EXPECT_LT(deviation, 1e-12);
    EXPECT_NEAR(this->Value("Energy"), energy, 1e-9 * energy);
    EXPECT_EQ(field.CountSingular(), 0);
    EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
    EXPECT_EQ(this->Value("Converged"), 1.0);
    EXPECT_LT(this->Value("Residual"), 1e-9);
    vtkDataArray* degrees =
      FilterChecks::RequireArray(this->Filter->GetOutput()->GetFieldData(), "HoleDegree");
    for (int row = 0; row < degrees->GetNumberOfTuples(); ++row)
    {
      const int prescribed = field.lines[field.OrderedLoop(3, row).front()].quarterIndex;
      EXPECT_NEAR(field.Degree(row), prescribed, 1e-12);
      EXPECT_EQ(degrees->GetComponent(row, 0), prescribed);
    }
  }
  // One inner loop, the island.
  vtkFieldData* report = this->Filter->GetOutput()->GetFieldData();
  ExpectArray(report, "HolonomyDefect", VTK_DOUBLE, 1, 1);
  EXPECT_LE(std::abs(this->Value("HolonomyDefect")), std::acos(-1.0));
}

TEST_F(PerforatedCrossFieldMethods, StartsLeadToMinima)
{
  this->Filter->SetMethodToConstrained();
  this->Filter->SetStartToHarmonic();
  this->Solve(TestInputs::DrilledDisk());
  const double harmonic = this->Value("Energy");
  this->Filter->SetStartToUnitNorm();
  this->Solve(TestInputs::DrilledDisk());
  EXPECT_EQ(this->Value("StartedFromUnitNorm"), 1.0);
  EXPECT_NEAR(this->Value("Energy"), harmonic, 1e-9 * harmonic);
  this->Filter->SetStartToBest();
  this->Solve(TestInputs::DrilledDisk());
  EXPECT_NEAR(this->Value("Energy"), harmonic, 1e-9 * harmonic);
  // Fields with values in the plane include those of unit norm.
  this->Filter->SetMethodToUnitNorm();
  this->Solve(TestInputs::DrilledDisk());
  EXPECT_GT(this->Value("Energy"), harmonic);
}

TEST_F(PerforatedCrossFieldMethods, UnitHolesHaveUnitCrosses)
{
  this->Filter->SetMethodToConstrained();
  this->Solve(TestInputs::DrilledDisk());
  const double free = this->Value("Energy");
  EXPECT_EQ(this->Value("UnitHoles"), 0.0);
  this->Filter->UnitHolesOn();
  const FieldReading field(this->Solve(TestInputs::DrilledDisk()));
  EXPECT_EQ(this->Value("UnitHoles"), 1.0);
  EXPECT_GT(this->Value("Energy"), free);
  for (int row = 0; row < 4; ++row)
  {
    EXPECT_NEAR(field.Degree(row), 1.0, 1e-12);
    for (std::size_t line : field.OrderedLoop(3, row))
    {
      EXPECT_NEAR(std::abs(field.OnLine(line)), 1.0, 1e-8);
    }
  }
}
