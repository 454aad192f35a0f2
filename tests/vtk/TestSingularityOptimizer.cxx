#include "support/DiskTest.h"
#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkPerforatedCrossField.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularityOptimizer.h"
#include "vtkSingularitySource.h"

#include "vtkCallbackCommand.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{
class SingularityOptimizer : public DiskTest<vtkSingularityOptimizer>
{
public:
  std::string Reason()
  {
    return vtkStringArray::SafeDownCast(
      this->Filter->GetOutput()->GetFieldData()->GetAbstractArray("Reason"))
      ->GetValue(0);
  }
  vtkTable* History() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(1)); }
};
}

TEST_F(SingularityOptimizer, FollowsFilterConventions)
{
  this->Domain->SetWidth(2.4);
  this->Domain->SetHeight(2.2);
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Domain->SetDomainName("disk"); },
    [this] { this->Domain->SetDomainName("ellipse"); });
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "MeshSize", "MaximumIterations", "Tolerance", "Clearance", "KeepAll", "UniformSizes",
      "Sizing", "SizeArray", "Pairs" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(SingularityOptimizer, MovesFourToTheAnalyticRadius)
{
  this->Filter->SetMeshSize(0.05);
  this->Domain->SetEdgeLength(0.05);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_NEAR(this->Value("RenormalizedEnergyBefore"), 2.0498, 0.02);
  EXPECT_NEAR(this->Value("RenormalizedEnergyAfter"), -7.2962, 0.02);
  vtkPolyData* output = this->Filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double* place = output->GetPoint(i);
    EXPECT_NEAR(std::hypot(place[0], place[1]), std::pow(3.0 / 11.0, 0.125), 1e-3);
    EXPECT_EQ(output->GetPointData()->GetArray("QuarterIndex")->GetTuple1(i), 1.0);
    EXPECT_EQ(output->GetPointData()->GetArray("Radius")->GetTuple1(i), 0.1);
  }
  vtkTable* history = this->History();
  ASSERT_EQ(history->GetNumberOfRows(), this->Value("Iterations") + 1.0);
  const vtkIdType last = history->GetNumberOfRows() - 1;
  EXPECT_EQ(history->GetValueByName(last, "Iteration").ToInt(), last);
  EXPECT_LT(history->GetValueByName(last, "GradientNorm").ToDouble(), 1e-6);
  EXPECT_EQ(history->GetValueByName(0, "StepLength").ToDouble(), 0.0);
  for (vtkIdType row = 1; row <= last; ++row)
  {
    EXPECT_LE(history->GetValueByName(row, "RenormalizedEnergy").ToDouble(),
      history->GetValueByName(row - 1, "RenormalizedEnergy").ToDouble() + 1e-9);
  }
}

TEST_F(SingularityOptimizer, UniformSizesReduceTheSpread)
{
  this->Domain->SetDomainName("ellipse");
  this->Domain->SetWidth(3.2);
  this->Domain->SetHeight(2.2);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetArray("SizeSpreadAfter"), nullptr);
  this->Filter->UniformSizesOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_GT(this->Value("SizeSpreadAfter"), 0.0);
  EXPECT_LT(this->Value("SizeSpreadAfter"), this->Value("SizeSpreadBefore"));
}

TEST_F(SingularityOptimizer, AddsPairsAndReportsTheFront)
{
  // A channel whose width doubles.
  this->Filter->SetInputData(TestInputs::Loops(
    { { { 0.0, 0.0 }, { 6.0, 0.0 }, { 6.0, 2.0 }, { 4.0, 2.0 }, { 2.0, 1.0 }, { 0.0, 1.0 } } }));
  this->Filter->SetSingularitiesData(TestInputs::Singularities({}));
  this->Filter->SetPairs(1);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 2);
  vtkFieldData* data = this->Filter->GetOutput()->GetFieldData();
  for (const char* name :
    { "FrontSingularities", "FrontSizeSpread", "FrontRenormalizedEnergy", "FrontHolonomyDefect" })
  {
    ASSERT_EQ(FilterChecks::RequireArray(data, name)->GetNumberOfTuples(), 3) << name;
  }
  EXPECT_EQ(data->GetArray("FrontSingularities")->GetTuple1(2), 2.0);
  EXPECT_LT(data->GetArray("FrontSizeSpread")->GetTuple1(2),
    0.5 * data->GetArray("FrontSizeSpread")->GetTuple1(1));
  EXPECT_EQ(data->GetArray("FrontSizeSpread")->GetTuple1(2), this->Value("SizeSpreadAfter"));
}

TEST_F(SingularityOptimizer, SizesFollowAnArrayOfTheDomain)
{
  // A straight channel needs no singularities, and its sizes are uniform.
  const auto channel =
    TestInputs::Loops({ { { 0.0, 0.0 }, { 6.0, 0.0 }, { 6.0, 1.5 }, { 0.0, 1.5 } } });
  const auto setTargetSizes = [&](const std::vector<double>& lengths)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName("Length");
    for (const double length : lengths)
    {
      array->InsertNextValue(length);
    }
    channel->GetPointData()->AddArray(array);
    this->Filter->SetInputData(channel);
    this->Filter->Modified();
  };
  setTargetSizes({ 3.0, 3.0, 3.0, 3.0 });
  this->Filter->SetSingularitiesData(TestInputs::Singularities({}));
  this->Filter->UniformSizesOn();
  this->Filter->SetSizingToField();
  this->Filter->SetSizeArray("Length");
  FilterChecks::MessageRecorder messages(this->Filter);
  this->Filter->Update();
  EXPECT_LT(this->Value("SizeSpreadAfter"), 1e-9);

  // Twice the size at the right needs a pair: log s is linear along the channel with slope 1/6 log
  // 2, and its standard deviation is log 2 / sqrt(12).
  setTargetSizes({ 0.1, 0.2, 0.2, 0.1 });
  this->Filter->SetPairs(1);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_NEAR(this->Value("SizeSpreadBefore"), std::log(2.0) / std::sqrt(12.0), 0.01);
  EXPECT_LT(this->Value("SizeSpreadAfter"), 0.5 * this->Value("SizeSpreadBefore"));
  vtkPolyData* output = this->Filter->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 2);
  EXPECT_NE(this->Reason().find("closest to the target sizes"), std::string::npos);
  const auto x = [output](double quarters)
  {
    const vtkIdType i =
      output->GetPointData()->GetArray("QuarterIndex")->GetTuple1(0) == quarters ? 0 : 1;
    return output->GetPoint(i)[0];
  };
  EXPECT_LT(x(1.0), x(-1.0)); // rows of quads end where quads become large

  this->Filter->SetSizingToUniform();
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_LT(this->Value("SizeSpreadAfter"), 1e-9);

  EXPECT_TRUE(messages.errors.empty());
  EXPECT_TRUE(messages.warnings.empty());

  this->Filter->SetSizingToField();
  this->Filter->SetSizeArray("Width");
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "no point array 'Width'", "name one" }),
    vtkErrorCode::UserError);
  this->Filter->SetSizeArray(std::string());
  EXPECT_EQ(
    FilterChecks::CaptureError(this->Filter, { "No size array is chosen", "choose a point array" }),
    vtkErrorCode::UserError);
  this->Filter->SetSizeArray("Length");
  setTargetSizes({ 0.1, 0.0, 0.2, 0.1 });
  EXPECT_EQ(
    FilterChecks::CaptureError(this->Filter, { "target size at point 1", "not a positive number" }),
    vtkErrorCode::UserError);
}

TEST_F(SingularityOptimizer, ReportsEvents)
{
  this->Domain->SetDomainName("l-shape");
  this->Filter->SetSingularitiesData(
    TestInputs::Singularities({ { 0.3, 0.3, 1.0, 0.05 }, { 0.7, 0.2, -1.0, 0.05 } }));
  FilterChecks::MessageRecorder messages(this->Filter);
  this->Filter->Update();
  EXPECT_TRUE(messages.errors.empty());
  EXPECT_TRUE(messages.warnings.empty());
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 0);
  vtkDataArray* pairs = this->Filter->GetOutput()->GetFieldData()->GetArray("Annihilation");
  ASSERT_EQ(pairs->GetNumberOfTuples(), 1);
  EXPECT_EQ(pairs->GetComponent(0, 0), 0.0);
  EXPECT_EQ(pairs->GetComponent(0, 1), 1.0);
  auto* events = vtkStringArray::SafeDownCast(
    this->Filter->GetOutput()->GetFieldData()->GetAbstractArray("Events"));
  ASSERT_TRUE(events);
  ASSERT_EQ(events->GetNumberOfValues(), 1);
  EXPECT_NE(events->GetValue(0).find("which have opposite signs, met at"), std::string::npos);

  this->Filter->KeepAllOn();
  this->Filter->SetClearance(0.04);
  FilterChecks::UpdateWithoutError(this->Filter);
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 2);
  EXPECT_NEAR(
    std::hypot(
      this->Filter->GetOutput()->GetPoint(0)[0] - this->Filter->GetOutput()->GetPoint(1)[0],
      this->Filter->GetOutput()->GetPoint(0)[1] - this->Filter->GetOutput()->GetPoint(1)[1]),
    1.15 * 0.04, 0.1 * 0.04);
}

TEST_F(SingularityOptimizer, AbortReturnsTheBestConfiguration)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  const double after = this->Value("RenormalizedEnergyAfter");
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(
    [](vtkObject* caller, unsigned long, void*, void*)
    {
      auto* filter = static_cast<vtkAlgorithm*>(caller);
      filter->SetAbortExecute(filter->GetProgress() > 0.21 ? 1 : 0);
    });
  const unsigned long tag = this->Filter->AddObserver(vtkCommand::ProgressEvent, command);
  this->Filter->Modified();
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
  ASSERT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), 4);
  EXPECT_EQ(this->Value("Converged"), 0.0);
  EXPECT_NE(this->Reason().find("aborted"), std::string::npos);
  EXPECT_LT(this->Value("RenormalizedEnergyAfter"), this->Value("RenormalizedEnergyBefore"));
  this->Filter->RemoveObserver(tag);
  this->Filter->SetAbortExecute(0); // since VTK 9.2 the flag is not reset by a run
  this->Filter->Modified();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RenormalizedEnergyAfter"), after);
}

TEST_F(SingularityOptimizer, RejectsInvalidInput)
{
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 0.0, 0.0, 3.0, 0.1 } }));
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "add up to 3", "requires 4" }),
    vtkCrossFieldErrorCodes::Inconsistent);
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 2.0, 0.0, 4.0, 0.1 } }));
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "(2, 0)", "outside the domain" }),
    vtkErrorCode::UserError);
}
