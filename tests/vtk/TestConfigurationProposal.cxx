#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkConfigurationProposal.h"
#include "vtkDrillHoles.h"
#include "vtkPlanarDomainSource.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
class ConfigurationProposalFilter : public testing::Test
{
public:
  void SetUp() override { this->Filter->SetInputConnection(this->Source->GetOutputPort()); }

  double Quarters(vtkIdType point)
  {
    return this->Filter->GetOutput()->GetPointData()->GetArray("QuarterIndex")->GetTuple1(point);
  }

  vtkNew<vtkPlanarDomainSource> Source;
  vtkNew<vtkConfigurationProposal> Filter;
};
}

TEST_F(ConfigurationProposalFilter, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Source->SetDomainName("disk"); },
    [this] { this->Source->SetDomainName("star"); });
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter, false);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "CornerAngle", "CancelFlatCorners", "CapCorners", "Automatic", "MeshSize", "Clearance",
      "KeepAll" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(ConfigurationProposalFilter, IsAcceptedByPoincareHopfCheckAndDrillHoles)
{
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputConnection(this->Source->GetOutputPort());
  check->SetSingularitiesConnection(this->Filter->GetOutputPort());
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(this->Source->GetOutputPort());
  drill->SetSingularitiesConnection(this->Filter->GetOutputPort());
  for (const char* name : { "disk", "star", "angular-hole", "angular-positive" })
  {
    this->Source->SetDomainName(name);
    FilterChecks::UpdateWithoutError(check);
    EXPECT_EQ(
      FilterChecks::Output(check)->GetFieldData()->GetArray("Consistent")->GetTuple1(0), 1.0);
    FilterChecks::UpdateWithoutError(drill);
  }
}

TEST_F(ConfigurationProposalFilter, KeepsGivenSingularitiesAndCancelsFlatCorners)
{
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 0.1, 0.2, 3.0, 0.07 } }));
  FilterChecks::UpdateWithoutError(this->Filter);
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_EQ(this->Quarters(0), 3.0);
  EXPECT_EQ(this->Quarters(1), 1.0);
  EXPECT_EQ(this->Filter->GetOutput()->GetPoint(0)[0], 0.1);
  EXPECT_EQ(this->Filter->GetOutput()->GetPointData()->GetArray("Radius")->GetTuple1(0), 0.07);

  this->Filter->SetSingularitiesConnection(nullptr);
  this->Source->SetDomainName("angular-balanced");
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
  this->Filter->CancelFlatCornersOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_EQ(this->Quarters(0), 1.0);
  EXPECT_EQ(this->Quarters(1), -1.0);
}

TEST_F(ConfigurationProposalFilter, AutomaticOptimisesAndReportsIt)
{
  this->Filter->AutomaticOn();
  this->Filter->SetMeshSize(0.1);
  this->Source->SetEdgeLength(0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkPolyData* output = this->Filter->GetOutput();
  // The minimum of W on the unit disk: four +1 at 0.8505 of the radius (docs/method.md §5.4).
  ASSERT_EQ(output->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    EXPECT_EQ(this->Quarters(i), 1.0);
    EXPECT_NEAR(std::hypot(output->GetPoint(i)[0], output->GetPoint(i)[1]), 0.85, 0.01);
  }
  EXPECT_EQ(output->GetPointData()->GetArray("Radius"), nullptr);
  vtkFieldData* data = output->GetFieldData();
  EXPECT_EQ(FilterChecks::RequireArray(data, "Converged")->GetTuple1(0), 1.0);
  ASSERT_NE(data->GetAbstractArray("Events"), nullptr);
  EXPECT_GE(data->GetAbstractArray("Events")->GetNumberOfTuples(), 1);
}

TEST_F(ConfigurationProposalFilter, KeepsTheClearance)
{
  this->Filter->AutomaticOn();
  this->Filter->SetMeshSize(0.1);
  this->Source->SetEdgeLength(0.1);
  const auto distance = [this]
  {
    FilterChecks::UpdateWithoutError(this->Filter);
    double farthest = 0.0;
    for (vtkIdType i = 0; i < this->Filter->GetOutput()->GetNumberOfPoints(); ++i)
    {
      const double* place = this->Filter->GetOutput()->GetPoint(i);
      farthest = std::max(farthest, std::hypot(place[0], place[1]));
    }
    return 1.0 - farthest;
  };
  EXPECT_NEAR(distance(), 0.15, 0.01); // where the energy is minimal
  this->Filter->SetClearance(0.3);
  EXPECT_NEAR(distance(), 0.33, 0.03); // the barrier adds a little
}

TEST_F(ConfigurationProposalFilter, OutputsPrescribedCorners)
{
  this->Source->SetDomainName("quarter-disk");
  this->Filter->SetCornersData(TestInputs::Singularities({ { 0.0, 0.0, 1.0, 0.1 } }));
  for (const bool automatic : { false, true })
  {
    this->Filter->SetAutomatic(automatic);
    FilterChecks::UpdateWithoutError(this->Filter);
    auto* corners = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
    ASSERT_EQ(corners->GetNumberOfPoints(), 1);
    EXPECT_EQ(corners->GetPointData()->GetArray("QuarterIndex")->GetTuple1(0), 1.0);
  }
}

TEST_F(ConfigurationProposalFilter, ListsAlternatives)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  auto* table = vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2));
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  this->Filter->SetAlternatives(3);
  FilterChecks::UpdateWithoutError(this->Filter);
  table = vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(2));
  ASSERT_GT(table->GetNumberOfRows(), 1);
  auto* points = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(3));
  vtkDataArray* numbers = points->GetPointData()->GetArray("Alternative");
  vtkDataArray* quarters = points->GetPointData()->GetArray("QuarterIndex");
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const double radius = table->GetValueByName(row, "CoreRadius").ToDouble();
    EXPECT_NEAR(table->GetValueByName(row, "EnergyAtCoreRadius").ToDouble(),
      table->GetValueByName(row, "RenormalizedEnergy").ToDouble() -
        table->GetValueByName(row, "LogarithmCoefficient").ToDouble() * std::log(radius),
      1e-9);
    EXPECT_GT(table->GetValueByName(row, "SizeSpread").ToDouble(), 0.05);
    EXPECT_LT(table->GetValueByName(row, "SizeSpread").ToDouble(), 1.0);
    double sum = 0.0;
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      sum += numbers->GetTuple1(i) == static_cast<double>(row) ? quarters->GetTuple1(i) : 0.0;
    }
    EXPECT_EQ(sum, 4.0) << "on the disk";
  }
}

TEST_F(ConfigurationProposalFilter, Refusals)
{
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 3.0, 0.0, 1.0, 0.1 } }));
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "outside" }), vtkErrorCode::UserError);
  this->Filter->SetSingularitiesConnection(nullptr);
  this->Filter->SetCornersData(TestInputs::Singularities({ { 0.0, 0.0, 1.0, 0.0 } }));
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "not a vertex" }), vtkErrorCode::UserError);
  this->Filter->SetCornersConnection(nullptr);
  FilterChecks::UpdateWithoutError(this->Filter);
}
