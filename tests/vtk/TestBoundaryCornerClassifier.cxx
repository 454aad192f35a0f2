#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkBoundaryCornerClassifier.h"
#include "vtkPlanarDomainSource.h"

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
#include <limits>

namespace
{
const double Pi = std::acos(-1.0);

class BoundaryCornerClassifier : public testing::Test
{
public:
  void SetUp() override
  {
    this->Source->SetDomainName("l-shape");
    this->Filter->SetInputConnection(this->Source->GetOutputPort());
  }

  double Value(const char* name, vtkIdType point)
  {
    return this->Filter->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(point);
  }
  /** Returns the corner at a position. Expects that there is one. */
  vtkIdType CornerAt(double x, double y)
  {
    vtkPolyData* corners = this->Filter->GetOutput();
    for (vtkIdType i = 0; i < corners->GetNumberOfPoints(); ++i)
    {
      if (std::hypot(corners->GetPoint(i)[0] - x, corners->GetPoint(i)[1] - y) < 1e-12)
      {
        return i;
      }
    }
    ADD_FAILURE() << "no corner at " << x << ", " << y;
    return 0;
  }
  vtkTable* Scenarios() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)); }
  vtkPolyData* Split() { return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(2)); }
  double Field(const char* name)
  {
    return this->Filter->GetOutput()->GetFieldData()->GetArray(name)->GetTuple1(0);
  }

  vtkNew<vtkPlanarDomainSource> Source;
  vtkNew<vtkBoundaryCornerClassifier> Filter;
};
}

TEST_F(BoundaryCornerClassifier, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Source->SetDomainName("star"); },
    [this] { this->Source->SetDomainName("l-shape"); });
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter, false);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "CornerAngle", "PrintedCoefficient", "SplitHalves", "Overrides", "PointOverrides" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(BoundaryCornerClassifier, LShapeIsBalanced)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 6);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfVerts(), 6);
  const vtkIdType inner = this->CornerAt(1.0, 1.0);
  for (vtkIdType i = 0; i < 6; ++i)
  {
    const int index = i == inner ? -1 : 1;
    EXPECT_NEAR(this->Value("Angle", i), i == inner ? 1.5 * Pi : 0.5 * Pi, 1e-12);
    for (const char* name : { "QuarterIndex", "QuarterIndexScarce", "QuarterIndexBalanced",
           "QuarterIndexExcess", "QuarterIndexConventional" })
    {
      EXPECT_EQ(this->Value(name, i), index) << name;
    }
    EXPECT_NEAR(this->Value("CornerEnergy", i), 0.0, 1e-14);
    EXPECT_EQ(this->Value("Cancellable", i), 0.0);
    EXPECT_EQ(this->Value("Tied", i), 0.0);
  }
  EXPECT_NEAR(this->Field("Energy"), 0.0, 1e-14);
  EXPECT_EQ(this->Field("InteriorQuarters"), 0.0);
  vtkTable* table = this->Scenarios();
  ASSERT_EQ(table->GetNumberOfRows(), 3);
  const char* scenarios[3] = { "scarce", "balanced", "excess" };
  for (vtkIdType row = 0; row < 3; ++row)
  {
    EXPECT_EQ(table->GetValueByName(row, "Scenario").ToString(), scenarios[row]);
    EXPECT_EQ(table->GetValueByName(row, "Sum").ToInt(), 4);
    EXPECT_EQ(table->GetValueByName(row, "Feasible").ToInt(), 1);
    EXPECT_EQ(table->GetValueByName(row, "Chosen").ToInt(), row == 1 ? 1 : 0);
  }
  EXPECT_EQ(this->Split()->GetNumberOfPoints(), 0);
}

TEST_F(BoundaryCornerClassifier, FlatAnglesAreCancellable)
{
  this->Source->SetDomainName("angular-balanced");
  FilterChecks::UpdateWithoutError(this->Filter);
  int flat = 0;
  for (vtkIdType i = 0; i < this->Filter->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const bool isFlat = this->Value("Angle", i) >= 0.75 * Pi;
    EXPECT_EQ(this->Value("Cancellable", i), isFlat ? 1.0 : 0.0);
    EXPECT_EQ(this->Value("QuarterIndex", i), isFlat ? 0.0 : 1.0);
    flat += isFlat ? 1 : 0;
  }
  EXPECT_EQ(flat, 2);
  auto* scenario = vtkStringArray::SafeDownCast(
    this->Filter->GetOutput()->GetFieldData()->GetAbstractArray("Scenario"));
  ASSERT_NE(scenario, nullptr);
  EXPECT_EQ(scenario->GetValue(0), "balanced");
}

TEST_F(BoundaryCornerClassifier, TiesAreReported)
{
  // The seven corners of a heptagon are equal; any four of them can have index 1.
  this->Filter->SetInputData(TestInputs::Loops({ TestInputs::Circle(7, 1.0) }));
  FilterChecks::UpdateWithoutError(this->Filter);
  double sum = 0.0;
  for (vtkIdType i = 0; i < 7; ++i)
  {
    EXPECT_EQ(this->Value("Tied", i), 1.0);
    sum += this->Value("QuarterIndex", i);
  }
  EXPECT_EQ(sum, 4.0);
}

TEST_F(BoundaryCornerClassifier, OverridesReplaceIndices)
{
  this->Filter->AddOverride(0.1, -0.1, 0); // nearest to the origin
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("QuarterIndex", this->CornerAt(0.0, 0.0)), 0.0);
  EXPECT_EQ(this->Value("Overridden", this->CornerAt(0.0, 0.0)), 1.0);
  EXPECT_EQ(this->Value("Overridden", this->CornerAt(2.0, 0.0)), 0.0);
  this->Filter->SetOverride(0, 2.0, 0.0, 2);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("QuarterIndex", this->CornerAt(2.0, 0.0)), 2.0);
  EXPECT_EQ(this->Value("Overridden", this->CornerAt(0.0, 0.0)), 0.0);
  this->Filter->RemoveAllOverrides();

  // Point 3 of the input is the inner corner, at (1, 1).
  this->Filter->AddPointOverride(3, 0);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("QuarterIndex", this->CornerAt(1.0, 1.0)), 0.0);
  this->Filter->RemoveAllPointOverrides();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("QuarterIndex", this->CornerAt(1.0, 1.0)), -1.0);
}

TEST_F(BoundaryCornerClassifier, SplitHalvesAddsInteriorSingularities)
{
  this->Filter->SetInputData(TestInputs::Loops({ { { 0.0, 0.0 }, { 4.0, 0.0 }, { 4.0, 1.0 } } }));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("QuarterIndex", this->CornerAt(0.0, 0.0)), 2.0);
  const double interior = this->Field("InteriorQuarters");
  this->Filter->SplitHalvesOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("QuarterIndex", this->CornerAt(0.0, 0.0)), 1.0);
  EXPECT_EQ(this->Field("InteriorQuarters"), interior + 1.0);
  ASSERT_EQ(this->Split()->GetNumberOfPoints(), 1);
  EXPECT_EQ(this->Split()->GetPointData()->GetArray("QuarterIndex")->GetTuple1(0), 1.0);
  const double* place = this->Split()->GetPoint(0);
  EXPECT_TRUE(place[0] > 0.0 && place[0] < 2.0 && place[1] > 0.0 && place[1] < place[0] / 4.0);
}

TEST_F(BoundaryCornerClassifier, AcceptsMeshesAndAnyPlane)
{
  this->Filter->SetInputData(TestInputs::Loops({ TestInputs::Rectangle({ 0, 0 }, { 3, 1 }) }, 7.0));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetPoint(0)[2], 7.0);
  const auto frame = TestInputs::FrameMesh();
  this->Filter->SetInputData(TestInputs::AsUnstructuredGrid(frame));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 8);
  EXPECT_EQ(this->Field("InteriorQuarters"), 0.0);
}

TEST_F(BoundaryCornerClassifier, CornerAngleSeparatesCornersFromCurves)
{
  this->Filter->SetInputData(TestInputs::Loops({ TestInputs::Circle(16, 1.0) }));
  this->Filter->Update(); // turns of 22.5°: a curve without corners, which is not an error
  EXPECT_EQ(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Field("InteriorQuarters"), 4.0);
  this->Filter->SetCornerAngle(20.0);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 16);
  this->Filter->SetCornerAngle(90.0);
  EXPECT_EQ(this->Filter->GetCornerAngle(), 45.0);
}

TEST_F(BoundaryCornerClassifier, RejectsInvalidInput)
{
  const auto expectError = [this](const std::vector<std::string>& parts)
  {
    EXPECT_EQ(FilterChecks::CaptureError(this->Filter, parts), vtkErrorCode::UserError);
    EXPECT_EQ(this->Scenarios()->GetNumberOfRows(), 0);
  };
  for (const double bad : { 0.5, std::numeric_limits<double>::quiet_NaN() })
  {
    this->Filter->AddOverride(0.0, 0.0, bad);
    expectError({ "not an integer" });
    this->Filter->RemoveAllOverrides();
  }
  this->Filter->AddPointOverride(6, 1);
  expectError({ "point 6", "below 6" });
  this->Filter->SetPointOverride(0, -1, 1);
  expectError({ "no such point" });
  this->Filter->RemoveAllPointOverrides();

  this->Source->SetDomainName("disk");
  this->Filter->AddOverride(0.0, 0.0, 1);
  expectError({ "no corners" });
  this->Filter->RemoveAllOverrides();

  this->Filter->SetInputData(TestInputs::OpenCurve({ { 0, 0 }, { 1, 0 }, { 1, 1 } }));
  expectError({ "open curve" });
  this->Filter->SetInputConnection(this->Source->GetOutputPort());
  this->Source->SetDomainName("square");
  FilterChecks::UpdateWithoutError(this->Filter);
}
