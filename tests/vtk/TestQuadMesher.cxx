#include "support/DiskTest.h"
#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkQuadMesher.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <set>
#include <string>
#include <vector>

namespace
{
using Place = std::array<double, 3>;

/** Returns the points of a side of a block in the order of increasing I or J. */
std::vector<Place> PointsOfSide(vtkMultiBlockDataSet* blocks, int block, int side)
{
  auto* grid = vtkStructuredGrid::SafeDownCast(blocks->GetBlock(static_cast<unsigned int>(block)));
  int size[3];
  grid->GetDimensions(size);
  std::vector<Place> places;
  for (int j = 0; j < size[1]; ++j)
  {
    for (int i = 0; i < size[0]; ++i)
    {
      const bool on[] = { j == 0, i == size[0] - 1, j == size[1] - 1, i == 0 };
      if (on[side])
      {
        places.emplace_back();
        grid->GetPoint(j * size[0] + i, places.back().data());
      }
    }
  }
  return places;
}

class QuadMesher : public DiskTest<vtkQuadMesher>
{
public:
  void SetUp() override
  {
    DiskTest::SetUp();
    this->Filter->SetQuadSize(0.1);
  }

protected:
  vtkPolyData* Lines(int port)
  {
    return vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(port));
  }
};
}

TEST_F(QuadMesher, FollowsFilterConventions)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "QuadSize", "QuadCount", "Sizing", "SizeArray", "Merge", "MeshSize", "Clearance", "Pairs",
      "CapCorners", "RepairHolonomy", "RepairPart", "SplitSingularities", "Layers", "Periodic",
      "CornerRows", "StageSeconds" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(QuadMesher, BlocksAreTheQuadsAndShareTheirPoints)
{
  this->Filter->Update();
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(1));
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 5U);
  std::set<std::array<double, 3>> places;
  for (vtkIdType p = 0; p < quads->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> place{};
    quads->GetPoint(p, place.data());
    places.insert(place);
  }
  vtkIdType cells = 0;
  for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
  {
    auto* grid = vtkStructuredGrid::SafeDownCast(blocks->GetBlock(b));
    ASSERT_NE(grid, nullptr);
    cells += grid->GetNumberOfCells();
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      std::array<double, 3> place{};
      grid->GetPoint(p, place.data());
      EXPECT_EQ(places.count(place), 1U);
    }
  }
  EXPECT_EQ(cells, quads->GetNumberOfCells());
}

TEST_F(QuadMesher, ReportsTheBlocksOfEachMerge)
{
  const auto count = [this](const char* name)
  {
    return FilterChecks::RequireArray(this->Filter->GetOutputDataObject(8)->GetFieldData(), name)
      ->GetComponent(0, 0);
  };
  this->Filter->SetMergeToClean();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(count("BlocksUnmerged"), 5.0);
  EXPECT_EQ(count("BlocksClean"), 5.0);
  EXPECT_EQ(
    this->Filter->GetOutputDataObject(8)->GetFieldData()->GetArray("BlocksCoarse"), nullptr);
  this->Filter->SetMergeToCoarse();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(count("BlocksCoarse"), count("Blocks"));
  this->Filter->SetMergeToNone();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetOutputDataObject(8)->GetFieldData()->GetArray("BlocksClean"), nullptr);
}

/// Each side of a block has the same points as the adjacent side, in the order that
/// `NeighbourOrientation` states, and both name each other; the sides without a neighbour make up
/// the boundary.
TEST_F(QuadMesher, AdjacentBlocksNameEachOther)
{
  this->Filter->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(1));
  const auto read = [&](int block, int side)
  {
    vtkFieldData* data = blocks->GetBlock(static_cast<unsigned int>(block))->GetFieldData();
    std::array<int, 3> row{};
    const char* const columns[] = { "NeighbourBlock", "NeighbourSide", "NeighbourOrientation" };
    for (std::size_t i = 0; i < 3; ++i)
    {
      row[i] =
        static_cast<int>(FilterChecks::RequireArray(data, columns[i])->GetComponent(side, 0));
    }
    return row;
  };
  std::size_t boundaryEdges = 0;
  for (int block = 0; block < static_cast<int>(blocks->GetNumberOfBlocks()); ++block)
  {
    for (int side = 0; side < 4; ++side)
    {
      SCOPED_TRACE("block " + std::to_string(block) + ", side " + std::to_string(side));
      std::vector<Place> places = PointsOfSide(blocks, block, side);
      const auto [neighbour, itsSide, orientation] = read(block, side);
      if (neighbour < 0)
      {
        boundaryEdges += places.size() - 1;
        continue;
      }
      ASSERT_EQ(std::abs(orientation), 1);
      if (orientation < 0)
      {
        std::reverse(places.begin(), places.end());
      }
      EXPECT_EQ(places, PointsOfSide(blocks, neighbour, itsSide));
      EXPECT_EQ(read(neighbour, itsSide), (std::array<int, 3>{ block, side, orientation }));
    }
  }
  EXPECT_EQ(static_cast<vtkIdType>(boundaryEdges), this->Lines(5)->GetNumberOfCells());
}

TEST_F(QuadMesher, HasTheRequestedValences)
{
  this->Filter->Update();
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  vtkDataArray* valence = FilterChecks::RequireArray(quads->GetPointData(), "Valence");
  vtkDataArray* irregular = FilterChecks::RequireArray(quads->GetPointData(), "Irregular");
  vtkDataArray* side = FilterChecks::RequireArray(quads->GetPointData(), "BoundarySide");
  int singular = 0;
  for (vtkIdType p = 0; p < quads->GetNumberOfPoints(); ++p)
  {
    const double regular = side->GetComponent(p, 0) < 0.0 ? 4.0 : 2.0;
    EXPECT_EQ(valence->GetComponent(p, 0), regular - irregular->GetComponent(p, 0));
    singular += irregular->GetComponent(p, 0) != 0.0 ? 1 : 0;
  }
  EXPECT_EQ(singular, 4);
  // Five blocks have 20 sides; the middle one shares each of its four with another one, and these
  // share four among them.
  EXPECT_EQ(this->Lines(2)->GetNumberOfLines(), 12);
}

/// Along a strip the columns follow h(x) = 0.1 · 2^(x/3): there are ∫ dx / h of them, 30 (1 − 1/2)
/// / log 2 = 21.6, and ∫ dx / h over a column is nearly constant, as far as shapes allow. Sizes are
/// given along curves and on a surface.
TEST_F(QuadMesher, FollowsTheSizesOfAnArray)
{
  const int columns = 60; // values are linear along the segments between
  TestInputs::Curve strip;
  for (int i = 0; i <= 2 * columns + 1; ++i)
  {
    strip.push_back(
      { 3.0 * (i <= columns ? i : 2 * columns + 1 - i) / columns, i <= columns ? 0.0 : 0.3 });
  }
  const auto curves = TestInputs::Loops({ strip });
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Length");
  for (const TestInputs::Place& place : strip)
  {
    lengths->InsertNextValue(0.1 * std::exp2(place[0] / 3.0));
  }
  curves->GetPointData()->AddArray(lengths);
  vtkNew<vtkPolyData> surface;
  surface->SetPoints(curves->GetPoints());
  surface->GetPointData()->AddArray(lengths);
  vtkNew<vtkCellArray> cells;
  for (vtkIdType i = 0; i < columns; ++i)
  {
    cells->InsertNextCell({ i, i + 1, 2 * columns - i, 2 * columns + 1 - i });
  }
  surface->SetPolys(cells);
  this->Filter->SetSingularitiesData(TestInputs::Singularities({}));
  this->Filter->SetQuadSize(1.0);
  this->Filter->SetSizingToField();
  this->Filter->SetSizeArray("Length");
  for (vtkPolyData* domain : { curves.Get(), surface.Get() })
  {
    this->Filter->SetInputData(domain);
    FilterChecks::UpdateWithoutError(this->Filter);
    vtkUnstructuredGrid* quads = this->Filter->GetOutput();
    std::set<double> bottom;
    for (vtkIdType p = 0; p < quads->GetNumberOfPoints(); ++p)
    {
      const double* place = quads->GetPoint(p);
      if (place[1] == 0.0)
      {
        bottom.insert(-30.0 * std::exp2(-place[0] / 3.0) / std::log(2.0)); // ∫ dx / h
      }
    }
    ASSERT_EQ(bottom.size(), 23U);
    for (auto next = std::next(bottom.begin()); next != bottom.end(); ++next)
    {
      EXPECT_NEAR(*next - *std::prev(next), 21.64 / 22.0, 0.12);
    }
  }
  this->Filter->SetSizeArray("Other");
  EXPECT_EQ(FilterChecks::CaptureError(
              this->Filter, { "no point array 'Other'", "name one with the target length" }),
    vtkCrossFieldErrorCodes::BadInput);
  lengths->SetValue(7, 0.0);
  lengths->Modified();
  this->Filter->SetSizeArray("Length");
  EXPECT_EQ(FilterChecks::CaptureError(
              this->Filter, { "size at point 7", "not a positive number", "correct the array" }),
    vtkCrossFieldErrorCodes::BadInput);
}

TEST_F(QuadMesher, RefusesMoreQuadsThanTheMaximum)
{
  this->Filter->SetQuadSize(5e-5); // about 1e9 quads
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter,
              { "A mesh of quads of size 5e-05 would have more than the maximum of 5e+07 quads",
                "; use a larger size." }),
    vtkCrossFieldErrorCodes::BadInput);
  this->Filter->SetQuadSize(0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
}
