#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkBoundaryCornerClassifier.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkDrillHoles.h"
#include "vtkPerforatedCrossField.h"
#include "vtkPlanarDomainSource.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <cmath>

#include <sstream>

namespace
{
class PoincareHopfCheck : public testing::Test
{
public:
  void SetUp() override
  {
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
    this->Filter->SetSingularitiesData(TestInputs::Singularities(TestInputs::FourOnDisk()));
  }

  vtkFieldData* Field() { return FilterChecks::Output(this->Filter)->GetFieldData(); }
  double Value(const char* name) { return this->Field()->GetArray(name)->GetTuple1(0); }
  std::string Reason()
  {
    auto* reason = vtkStringArray::SafeDownCast(this->Field()->GetAbstractArray("Reason"));
    return reason == nullptr ? "" : std::string(reason->GetValue(0));
  }
  vtkTable* Loops() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)); }
  std::string Summary()
  {
    auto* table = vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(3));
    return table->GetNumberOfRows() == 1 ? table->GetValueByName(0, "Summary").ToString() : "";
  }
  vtkPolyData* Corners() { return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(2)); }

  vtkNew<vtkPlanarDomainSource> Source;
  vtkNew<vtkPoincareHopfCheck> Filter;
};
}

TEST_F(PoincareHopfCheck, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Source->SetDomainName("disk"); },
    [this] { this->Source->SetDomainName("ellipse"); });
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter, { "CornerAngle", "Holonomy" });
  this->Source->SetDomainName("ring");
  this->Filter->SetSingularitiesData(
    TestInputs::Singularities({ { 0.7, 0.0, 1.0, 0.05 }, { -0.7, 0.0, -1.0, 0.05 } }));
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(PoincareHopfCheck, ConsistentOnTheDisk)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("EulerCharacteristic"), 1.0);
  EXPECT_EQ(this->Value("Valence"), 0.0);
  EXPECT_NEAR(this->Value("TangentTurning"), 1.0, 1e-12);
  EXPECT_EQ(this->Value("RequiredInteriorQuarters"), 4.0);
  EXPECT_EQ(this->Value("GivenInteriorQuarters"), 4.0);
  EXPECT_EQ(this->Value("Consistent"), 1.0);
  EXPECT_EQ(this->Field()->GetArray("HolonomyDefect"), nullptr);
  EXPECT_NE(this->Reason().find("as the Poincaré-Hopf theorem requires"), std::string::npos);
  EXPECT_EQ(this->Summary().rfind("Consistent\n", 0), 0u);
  // The domain passes through.
  vtkPolyData* domain = this->Source->GetOutput();
  EXPECT_EQ(FilterChecks::Output(this->Filter)->GetNumberOfPoints(), domain->GetNumberOfPoints());
  EXPECT_EQ(domain->GetFieldData()->GetNumberOfArrays(), 0);
}

TEST_F(PoincareHopfCheck, InconsistencyIsNotAnError)
{
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 0.0, 0.0, 1.0, 0.1 } }));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Consistent"), 0.0);
  EXPECT_NE(this->Reason().find("add up to 1 "), std::string::npos);
  EXPECT_NE(this->Reason().find("; add singularities of total 3."), std::string::npos);
  // The summary has the same content in short lines.
  std::istringstream lines(this->Summary());
  std::string joined;
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "Inconsistent");
  while (std::getline(lines, line))
  {
    EXPECT_LE(line.size(), 60u);
    joined += (joined.empty() ? "" : " ") + line;
  }
  EXPECT_EQ(joined, this->Reason());
}

TEST_F(PoincareHopfCheck, SingularitiesAreOptional)
{
  this->Filter->SetSingularitiesConnection(nullptr);
  this->Source->SetDomainName("l-shape");
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Consistent"), 1.0);
  EXPECT_EQ(this->Value("GivenInteriorQuarters"), 0.0);
  EXPECT_EQ(this->Corners()->GetNumberOfPoints(), 6);
}

TEST_F(PoincareHopfCheck, ReportsLoopsAndCorners)
{
  this->Source->SetDomainName("angular-hole");
  this->Filter->SetSingularitiesConnection(nullptr);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RequiredInteriorQuarters"), -2.0);
  vtkTable* loops = this->Loops();
  ASSERT_EQ(loops->GetNumberOfRows(), 2);
  EXPECT_NEAR(loops->GetValueByName(0, "Valence").ToDouble(), 0.5, 1e-12);
  EXPECT_EQ(loops->GetValueByName(0, "CornerQuarters").ToInt(), 2);
  EXPECT_EQ(loops->GetValueByName(0, "RequiredPart").ToInt(), 2);
  EXPECT_NEAR(loops->GetValueByName(1, "TangentTurning").ToDouble(), -1.0, 1e-12);
  EXPECT_EQ(loops->GetValueByName(1, "RequiredPart").ToInt(), -4);
  double cancellable = 0.0;
  for (vtkIdType i = 0; i < this->Corners()->GetNumberOfPoints(); ++i)
  {
    cancellable += this->Corners()->GetPointData()->GetArray("Cancellable")->GetTuple1(i);
  }
  EXPECT_EQ(cancellable, 4.0);
}

TEST_F(PoincareHopfCheck, ReportsHolonomyOfARing)
{
  this->Source->SetDomainName("ring");
  this->Filter->SetSingularitiesData(
    TestInputs::Singularities({ { 0.7, 0.0, 1.0, 0.05 }, { 0.2, 0.65, -1.0, 0.05 } }));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Consistent"), 1.0);
  ASSERT_NE(this->Field()->GetArray("HolonomyDefect"), nullptr);
  const double defect = this->Value("HolonomyDefect");
  EXPECT_NEAR(defect, -std::atan2(0.65, 0.2), 1e-3); // Σ k_j arg b_j
  EXPECT_EQ(this->Loops()->GetValueByName(1, "HolonomyDefect").ToDouble(), defect);
  EXPECT_TRUE(std::isnan(this->Loops()->GetValueByName(0, "HolonomyDefect").ToDouble()));
  EXPECT_NE(this->Reason().find("inner loop 1"), std::string::npos) << this->Reason();
  this->Filter->HolonomyOff();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Field()->GetArray("HolonomyDefect"), nullptr);
}

TEST_F(PoincareHopfCheck, ChosenCornersChangeTheSum)
{
  // The exact minimiser for the hexagon with two sharp corners has the sum 4.
  this->Source->SetDomainName("angular-negative");
  this->Filter->SetSingularitiesConnection(nullptr);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RequiredInteriorQuarters"), -2.0);
  vtkNew<vtkBoundaryCornerClassifier> classifier;
  classifier->SetInputConnection(this->Source->GetOutputPort());
  this->Filter->SetCornersConnection(classifier->GetOutputPort());
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RequiredInteriorQuarters"),
    classifier->GetOutput()->GetFieldData()->GetArray("InteriorQuarters")->GetTuple1(0));
  EXPECT_EQ(this->Value("RequiredInteriorQuarters"), 0.0);
}

TEST_F(PoincareHopfCheck, ChosenCornersReachTheSolver)
{
  this->Source->SetDomainName("angular-negative");
  vtkNew<vtkBoundaryCornerClassifier> classifier;
  classifier->SetInputConnection(this->Source->GetOutputPort());
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(this->Source->GetOutputPort());
  drill->SetSingularitiesData(
    TestInputs::Singularities({ { -0.5, 0.0, 1.0, 0.05 }, { 0.5, 0.0, -1.0, 0.05 } }));
  vtkNew<vtkPerforatedCrossField> solver;
  solver->SetInputConnection(drill->GetOutputPort());
  solver->SetMethodToUnitNorm();
  EXPECT_EQ(
    FilterChecks::CaptureError(solver, { "requires -2" }), vtkCrossFieldErrorCodes::Inconsistent);
  solver->SetCornersConnection(classifier->GetOutputPort());
  FilterChecks::UpdateWithoutError(solver);
  vtkFieldData* report = solver->GetOutput()->GetFieldData();
  EXPECT_EQ(report->GetArray("UnwantedSingularities")->GetTuple1(0), 0.0);
  EXPECT_EQ(report->GetArray("RequiredInteriorQuarters")->GetTuple1(0), 0.0);

  // The field has the prescribed indices.
  this->Filter->SetInputConnection(solver->GetOutputPort());
  this->Filter->SetCornersConnection(classifier->GetOutputPort());
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Consistent"), 1.0) << this->Reason();
  vtkPolyData* prescribed = classifier->GetOutput();
  vtkPolyData* counted = this->Corners();
  ASSERT_EQ(counted->GetNumberOfPoints(), prescribed->GetNumberOfPoints());
  for (vtkIdType i = 0; i < prescribed->GetNumberOfPoints(); ++i)
  {
    double point[3];
    prescribed->GetPoint(i, point);
    const vtkIdType match = counted->FindPoint(point);
    EXPECT_EQ(counted->GetPointData()->GetArray("QuarterIndex")->GetTuple1(match),
      prescribed->GetPointData()->GetArray("QuarterIndex")->GetTuple1(i));
  }
}

TEST_F(PoincareHopfCheck, ChecksASolvedField)
{
  for (const bool unitNorm : { false, true })
  {
    vtkNew<vtkPerforatedCrossField> solver;
    solver->SetInputData(TestInputs::DrilledDisk());
    solver->SetMethod(unitNorm ? vtkPerforatedCrossField::MethodUnitNorm
                               : vtkPerforatedCrossField::MethodConstrained);
    this->Filter->SetInputConnection(solver->GetOutputPort());
    this->Filter->SetSingularitiesConnection(nullptr);
    FilterChecks::UpdateWithoutError(this->Filter);
    EXPECT_EQ(this->Value("Consistent"), 1.0);
    EXPECT_EQ(this->Value("RequiredInteriorQuarters"), 4.0);
    EXPECT_EQ(this->Value("GivenInteriorQuarters"), 4.0);
    EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
    vtkDataArray* degrees = this->Field()->GetArray("HoleDegree");
    ASSERT_EQ(degrees->GetNumberOfTuples(), 4);
    for (vtkIdType i = 0; i < 4; ++i)
    {
      EXPECT_EQ(degrees->GetTuple1(i), 1.0);
    }
    // The mesh of the field passes through.
    EXPECT_NE(FilterChecks::Output(this->Filter)->GetCellData()->GetArray("CrossFieldCR"), nullptr);

    // The same field with other prescribed degrees.
    vtkNew<vtkUnstructuredGrid> other;
    other->DeepCopy(solver->GetOutput());
    vtkDataArray* quarters = other->GetCellData()->GetArray("QuarterIndex");
    vtkDataArray* ids = other->GetCellData()->GetArray("BoundaryId");
    for (vtkIdType cell = 0; cell < other->GetNumberOfCells(); ++cell)
    {
      if (quarters->GetTuple1(cell) != 0.0)
      {
        quarters->SetTuple1(cell, ids->GetTuple1(cell) == 0.0 ? 2 : 1);
      }
    }
    this->Filter->SetInputData(other);
    FilterChecks::UpdateWithoutError(this->Filter);
    EXPECT_EQ(this->Value("Consistent"), 0.0);
    EXPECT_NE(this->Reason().find("degree 1 instead of 2 on hole 1"), std::string::npos)
      << this->Reason();
  }
}

TEST_F(PoincareHopfCheck, RejectsInvalidInput)
{
  const auto expectError = [this](const std::vector<std::string>& parts)
  {
    EXPECT_EQ(FilterChecks::CaptureError(this->Filter, parts), vtkErrorCode::UserError);
    EXPECT_EQ(this->Loops()->GetNumberOfRows(), 0);
    EXPECT_EQ(this->Corners()->GetNumberOfPoints(), 0);
    // A view must not show an outdated text.
    EXPECT_EQ(this->Summary().rfind("Not checked\n", 0), 0u) << this->Summary();
  };
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 3.0, 0.0, 4.0, 0.1 } }));
  expectError({ "singularity 1", "(3, 0)", "outside" });
  auto bare = TestInputs::Singularities({ { 0.0, 0.0, 4.0, 0.1 } });
  bare->GetPointData()->RemoveArray("QuarterIndex");
  this->Filter->SetSingularitiesData(bare);
  expectError({ "'QuarterIndex'" });
  this->Filter->SetSingularitiesConnection(nullptr);
  this->Filter->SetCornersData(bare);
  expectError({ "corners", "'QuarterIndex'" });
  this->Filter->SetCornersData(TestInputs::Singularities({ { 0.1, 0.0, 1.0, 0.0 } }));
  expectError({ "(0.1, 0)", "not a vertex" });
  this->Filter->SetCornersConnection(nullptr);
  this->Filter->SetInputData(TestInputs::OpenCurve({ { 0, 0 }, { 1, 0 }, { 1, 1 } }));
  expectError({ "open curve" });
  this->Filter->SetInputConnection(this->Source->GetOutputPort());
  FilterChecks::UpdateWithoutError(this->Filter);
}
