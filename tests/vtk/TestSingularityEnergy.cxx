#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularityEnergy.h"

#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{
std::vector<TestInputs::Row> Square(double distance, double radius = 0.05)
{
  const double x = distance / std::sqrt(2.0);
  return { { x, x, 1.0, radius }, { -x, x, 1.0, radius }, { -x, -x, 1.0, radius },
    { x, -x, 1.0, radius } };
}

class SingularityEnergy : public testing::Test
{
public:
  void SetUp() override
  {
    this->Domain->SetEdgeLength(0.1);
    this->Filter->SetInputConnection(this->Domain->GetOutputPort());
    this->Filter->SetMeshSize(0.1);
    this->Filter->AddConfigurationData(TestInputs::Singularities(Square(0.6)));
  }

  double Value(vtkIdType row, const char* name)
  {
    return this->Filter->GetOutput()->GetValueByName(row, name).ToDouble();
  }

  vtkNew<vtkPlanarDomainSource> Domain;
  vtkNew<vtkSingularityEnergy> Filter;
};
}

TEST_F(SingularityEnergy, FollowsFilterConventions)
{
  this->Domain->SetWidth(2.4);
  this->Domain->SetHeight(2.2);
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Domain->SetDomainName("disk"); },
    [this] { this->Domain->SetDomainName("ellipse"); });
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter, { "MeshSize" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(SingularityEnergy, RowsAreSortedAndComplete)
{
  this->Filter->AddConfigurationData(TestInputs::Singularities({ { 0.0, 0.0, 3.0, 0.05 } }));
  this->Filter->AddConfigurationData(TestInputs::Singularities(Square(0.85)));
  this->Filter->AddConfigurationData(TestInputs::Singularities({ { 0.0, 0.0, 4.0, 0.05 } }));
  FilterChecks::MessageRecorder messages(this->Filter);
  this->Filter->Update();
  EXPECT_TRUE(messages.errors.empty());
  vtkTable* table = this->Filter->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 4);
  const int order[4] = { 2, 0, 3, 1 };
  for (vtkIdType row = 0; row < 4; ++row)
  {
    EXPECT_EQ(this->Value(row, "Configuration"), order[row]);
    EXPECT_EQ(this->Value(row, "Consistent"), row < 3 ? 1.0 : 0.0);
  }
  for (vtkIdType row = 0; row < 3; ++row)
  {
    EXPECT_LT(this->Value(row, "EnergyLowerBound"), this->Value(row, "Energy"));
    EXPECT_LT(this->Value(row, "Energy"), this->Value(row, "EnergyUpperBound"));
    EXPECT_LT(this->Value(row, "EnergyDegreeOnlyLowerBound"), this->Value(row, "EnergyDegreeOnly"));
    EXPECT_LT(this->Value(row, "EnergyDegreeOnly"), this->Value(row, "EnergyDegreeOnlyUpperBound"));
    EXPECT_EQ(this->Value(row, "HolonomyDefect"), 0.0);
  }
  EXPECT_TRUE(std::isnan(this->Value(3, "Energy")));
  EXPECT_TRUE(std::isnan(this->Value(3, "RenormalizedEnergy")));
  // Value of the circle; that of its polygon of 63 sides is lower by O(h²).
  EXPECT_NEAR(this->Value(1, "RenormalizedEnergy"), 2.0498, 0.05);
  EXPECT_NEAR(this->Value(0, "LogarithmCoefficient"), 4.0 * vtkMath::Pi(), 1e-9);
  // One centred hole: π d² log(1/ρ) with both definitions.
  const double exact = 16.0 * vtkMath::Pi() * std::log(1.0 / 0.05);
  EXPECT_NEAR(this->Value(2, "EnergyDegreeOnly"), exact, 0.005 * exact);
  EXPECT_NEAR(this->Value(2, "RenormalizedEnergy"), 0.0, 0.05);

  auto* gradients = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(1));
  ASSERT_EQ(gradients->GetNumberOfPoints(), 9);
  vtkDataArray* gradient = gradients->GetPointData()->GetArray("Gradient");
  ASSERT_EQ(gradient->GetNumberOfComponents(), 3);
  EXPECT_EQ(gradients->GetPointData()->GetArray("Configuration")->GetTuple1(4), 0.0);
  EXPECT_EQ(gradients->GetPointData()->GetArray("QuarterIndex")->GetTuple1(8), 4.0);
  // At radius 0.6 the singularities move outwards.
  const double* place = gradients->GetPoint(4);
  EXPECT_LT(gradient->GetComponent(4, 0) * place[0] + gradient->GetComponent(4, 1) * place[1], 0.0);
}

TEST_F(SingularityEnergy, KeepMeshReusesTheMesh)
{
  this->Filter->KeepMeshOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  // Values of the circle, as above; there are no holes.
  EXPECT_NEAR(this->Value(0, "RenormalizedEnergy"), 2.0498, 0.05);
  EXPECT_NEAR(this->Value(0, "LogarithmCoefficient"), 4.0 * vtkMath::Pi(), 1e-9);
  EXPECT_NEAR(this->Value(0, "EnergyAtCoreRadius"),
    this->Value(0, "RenormalizedEnergy") -
      this->Value(0, "LogarithmCoefficient") * std::log(this->Value(0, "CoreRadius")),
    1e-12);
  EXPECT_TRUE(std::isnan(this->Value(0, "Energy")));
  EXPECT_TRUE(std::isnan(this->Value(0, "EnergyDegreeOnlyUpperBound")));
  const auto move = [this](double distance)
  {
    this->Filter->RemoveAllConfigurations();
    this->Filter->AddConfigurationData(TestInputs::Singularities(Square(distance)));
    FilterChecks::UpdateWithoutError(this->Filter);
    return this->Value(0, "RenormalizedEnergy");
  };
  // Four of index 1 at distance r: W = -4π [log(4r³) + log(1 - r⁸)] (docs/method.md §9).
  const auto exact = [](double r)
  { return -4.0 * vtkMath::Pi() * std::log(4.0 * std::pow(r, 3) * (1.0 - std::pow(r, 8))); };
  EXPECT_NEAR(move(0.5) - move(0.7), exact(0.5) - exact(0.7), 0.05);
  this->Filter->RemoveAllConfigurations();
  this->Filter->AddConfigurationData(TestInputs::Singularities({ { 3.0, 0.0, 4.0, 0.05 } }));
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "(3, 0)", "outside the domain" }),
    vtkErrorCode::UserError);
}

TEST_F(SingularityEnergy, RejectsInvalidInput)
{
  this->Filter->AddConfigurationData(TestInputs::Singularities({ { 3.0, 0.0, 4.0, 0.05 } }));
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "(3, 0)", "outside the domain" }),
    vtkErrorCode::UserError);
  this->Filter->RemoveAllConfigurations();
  this->Filter->AddConfigurationData(TestInputs::Singularities({ { 0.9, 0.0, 4.0, 0.2 } }));
  EXPECT_EQ(
    FilterChecks::CaptureError(this->Filter, { "cuts the boundary" }), vtkErrorCode::UserError);
}
