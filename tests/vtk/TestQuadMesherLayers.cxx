#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkQuadMesher.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
class QuadMesherLayers : public testing::Test
{
protected:
  void SetUp() override
  {
    this->Filter->SetInputData(
      TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 2.0, 1.0 }) }));
    this->Filter->SetQuadSize(0.1);
  }

  /** Returns a value of the report. */
  double Report(const char* name, vtkIdType tuple = 0, int component = 0)
  {
    vtkFieldData* data = this->Filter->GetOutputDataObject(8)->GetFieldData();
    return FilterChecks::RequireArray(data, name)->GetComponent(tuple, component);
  }

  vtkNew<vtkQuadMesher> Filter;
};
}

TEST_F(QuadMesherLayers, AreReported)
{
  this->Filter->SetLayers("outer0:1e-3,1.25; outer2:2e-3,1.3,12");
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkFieldData* data = this->Filter->GetOutputDataObject(8)->GetFieldData();
  auto* sides = vtkStringArray::SafeDownCast(data->GetAbstractArray("LayerSide"));
  ASSERT_NE(sides, nullptr);
  ASSERT_EQ(sides->GetNumberOfValues(), 2);
  EXPECT_EQ(sides->GetValue(0), "outer0");
  EXPECT_EQ(sides->GetValue(1), "outer2");
  EXPECT_EQ(this->Report("LayerRows", 1), 12.0);
  const double first[] = { 1e-3, 2e-3 };
  const double growth[] = { 1.25, 1.3 };
  for (vtkIdType i = 0; i < 2; ++i)
  {
    EXPECT_EQ(this->Report("LayerFirst", i), first[i]);
    EXPECT_NEAR(this->Report("LayerHeightRange", i, 0), first[i], 1e-9);
    EXPECT_NEAR(this->Report("LayerHeightRange", i, 1), first[i], 1e-9);
    EXPECT_EQ(this->Report("LayerInBounds", i), 1.0);
    EXPECT_LE(this->Report("LayerGrowth", i), growth[i] + 1e-9);
    EXPECT_GE(this->Report("LayerRatio", i), this->Report("LayerGrowth", i) - 1e-12);
    EXPECT_NEAR(this->Report("LayerThickness", i), 0.1 * this->Report("LayerReplaced", i), 1e-9);
  }
  // Rows of both layers, and those between them.
  const double rows = this->Report("LayerRows", 0) + this->Report("LayerRows", 1) + 10.0 -
    this->Report("LayerReplaced", 0) - this->Report("LayerReplaced", 1);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 20.0 * rows);
  EXPECT_EQ(this->Report("Blocks"), 3.0);
  EXPECT_EQ(
    vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(1))->GetNumberOfBlocks(),
    3U);
}

TEST_F(QuadMesherLayers, NewBoundaryEdgesHaveTheirSide)
{
  this->Filter->SetLayers("outer0:1e-3");
  FilterChecks::UpdateWithoutError(this->Filter);
  auto* boundary = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(5));
  auto* sides = vtkStringArray::SafeDownCast(boundary->GetCellData()->GetAbstractArray("Side"));
  ASSERT_NE(sides, nullptr);
  int upright = 0;
  for (vtkIdType i = 0; i < sides->GetNumberOfValues(); ++i)
  {
    upright += sides->GetValue(i) == "outer1" ? 1 : 0;
  }
  EXPECT_EQ(upright, 10 - this->Report("LayerReplaced") + this->Report("LayerRows"));
}

TEST_F(QuadMesherLayers, WithoutLayersThereIsNoReport)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(
    this->Filter->GetOutputDataObject(8)->GetFieldData()->GetAbstractArray("LayerSide"), nullptr);
}

TEST_F(QuadMesherLayers, CornersAreTreated)
{
  // An L-shape whose rows leave the inner corner has no irregular node; if they turn, it has one.
  this->Filter->SetInputData(TestInputs::Loops(
    { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 1.0 }, { 1.0, 2.0 }, { 0.0, 2.0 } } }));
  const auto nodes = [this](const char* rows)
  {
    this->Filter->SetCornerRows(rows);
    FilterChecks::UpdateWithoutError(this->Filter);
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(6))->GetNumberOfPoints();
  };
  EXPECT_EQ(nodes("1,1:turn"), 1);
  EXPECT_EQ(nodes("1,1,0:leave"), 0);
  EXPECT_EQ(nodes("260-280:turn"), 1);
  EXPECT_EQ(nodes("outer2:turn"), 1);
}

TEST_F(QuadMesherLayers, RefusesWhatIsImpossible)
{
  this->Filter->SetLayers("lid:1e-3");
  FilterChecks::CaptureError(this->Filter, { "no side 'lid'", "'outer0'" });
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
  this->Filter->SetLayers("outer0");
  FilterChecks::CaptureError(this->Filter, { "no colon" });
  this->Filter->SetLayers("");
  this->Filter->SetCornerRows("0,0:turn");
  FilterChecks::CaptureError(this->Filter, { "an angle of 90°", "let them end" });
}
