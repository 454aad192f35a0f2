#include "DiskTest.h"
#include "FilterChecks.h"
#include "TestInputs.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkPlanarDomainSource.h"
#include "vtkQuadMesher.h"
#include "vtkSingularitySource.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
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
/**
 * Returns the number of sentences in an array of the field data of a mesh; −1 without the array.
 */
vtkIdType FieldStrings(vtkQuadMesher* mesher, const char* name)
{
  vtkAbstractArray* array = mesher->GetOutput()->GetFieldData()->GetAbstractArray(name);
  return array == nullptr ? -1 : array->GetNumberOfTuples();
}

using Place = std::array<double, 3>;

/** Returns the data of an output port that holds singularities or corners. */
vtkPolyData* UsedPoints(vtkQuadMesher* mesher, int port)
{
  return vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(port));
}

Place PositionOf(vtkDataSet* points, vtkIdType i)
{
  Place position{};
  points->GetPoint(i, position.data());
  return position;
}

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
};
}

TEST_F(QuadMesher, FollowsFilterConventions)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "QuadSize", "QuadCount", "Sizing", "SizeArray", "Coarse", "MeshSize", "Clearance", "Pairs",
      "CapCorners", "RepairHolonomy", "StageSeconds" });
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
  const auto count = static_cast<vtkIdType>(
    FilterChecks::RequireArray(quads->GetFieldData(), "Quads")->GetComponent(0, 0));
  EXPECT_EQ(cells, count);
  EXPECT_GT(quads->GetNumberOfCells(), count); // and the boundary's lines
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
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  const double count =
    FilterChecks::RequireArray(quads->GetFieldData(), "Quads")->GetComponent(0, 0);
  EXPECT_EQ(
    static_cast<double>(boundaryEdges), static_cast<double>(quads->GetNumberOfCells()) - count);
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
  EXPECT_EQ(
    vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(2))->GetNumberOfLines(), 24);
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
      { 3.0 * (i <= columns ? i : 2 * columns + 1 - i) / columns, i <= columns ? 0.0 : 0.2 });
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

TEST_F(QuadMesher, RefusesMoreQuadsThanMemory)
{
  this->Filter->SetQuadSize(1e-6);
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter,
              { "This number of quads would need about",
                "GiB available; use a larger size or fewer quads." }),
    vtkCrossFieldErrorCodes::BadInput);
  this->Filter->SetQuadSize(0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
}

TEST_F(QuadMesher, OutputsGivenSingularitiesAsTheyAre)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  auto* given = this->Singularities->GetOutput();
  vtkPolyData* used = UsedPoints(this->Filter, 3);
  ASSERT_EQ(used->GetNumberOfPoints(), given->GetNumberOfPoints());
  for (vtkIdType i = 0; i < given->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(PositionOf(used, i), PositionOf(given, i));
    for (const char* name : { "QuarterIndex", "Radius" })
    {
      EXPECT_EQ(FilterChecks::RequireArray(used->GetPointData(), name)->GetTuple1(i),
        FilterChecks::RequireArray(given->GetPointData(), name)->GetTuple1(i));
    }
  }
  EXPECT_EQ(used->GetFieldData()->GetAbstractArray("Events"), nullptr);
  EXPECT_EQ(UsedPoints(this->Filter, 4)->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetStageSeconds()[6], 0.0);
}

TEST_F(QuadMesher, OutputsAllCornersWithTheirIndices)
{
  this->Domain->SetDomainName("star");
  this->Filter->SetSingularitiesConnection(nullptr);
  FilterChecks::UpdateWithoutError(this->Filter);
  double sum = 0.0;
  for (const int port : { 3, 4 })
  {
    vtkPolyData* used = UsedPoints(this->Filter, port);
    for (vtkIdType i = 0; i < used->GetNumberOfPoints(); ++i)
    {
      const double quarters =
        FilterChecks::RequireArray(used->GetPointData(), "QuarterIndex")->GetTuple1(i);
      EXPECT_LE(quarters, 1.0);
      sum += quarters;
    }
  }
  EXPECT_EQ(UsedPoints(this->Filter, 4)->GetNumberOfPoints(), 10);
  EXPECT_EQ(sum, 4.0);
}

TEST_F(QuadMesher, OutputsPositionsAfterRepair)
{
  this->Domain->SetDomainName("ring");
  std::vector<TestInputs::Row> rows;
  for (int i = 0; i < 4; ++i)
  {
    const double turn = 0.5 * vtkMath::Pi() * i;
    rows.push_back({ 0.8 * std::cos(turn + 0.25), 0.8 * std::sin(turn + 0.25), 1.0, 0.02 });
    rows.push_back({ 0.55 * std::cos(turn + 0.1), 0.55 * std::sin(turn + 0.1), -1.0, 0.02 });
  }
  this->Filter->SetSingularitiesData(TestInputs::Singularities(rows));
  this->Filter->RepairHolonomyOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkFieldData* field = this->Filter->GetOutput()->GetFieldData();
  vtkDataArray* repaired = FilterChecks::RequireArray(field, "RepairedPositions");
  vtkPolyData* used = UsedPoints(this->Filter, 3);
  ASSERT_EQ(used->GetNumberOfPoints(), 8);
  double largest = 0.0;
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const Place position = PositionOf(used, i);
    const TestInputs::Row& row = rows[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(position[static_cast<std::size_t>(axis)], repaired->GetComponent(i, axis));
    }
    largest = std::max(largest, std::hypot(position[0] - row[0], position[1] - row[1]));
  }
  EXPECT_NEAR(FilterChecks::RequireArray(field, "RepairDistance")->GetTuple1(0), largest, 1e-14);
  EXPECT_GT(largest, 0.01);
}

TEST_F(QuadMesher, MakesTheSameMeshOfWhatItChose)
{
  // On an ellipse, sizes at the minimum of the energy are not far from uniform.
  constexpr int Count = 40;
  TestInputs::Curve ellipse;
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Length");
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / Count;
    ellipse.push_back({ 0.8 * std::cos(angle), 0.5 * std::sin(angle) });
    lengths->InsertNextValue(1.0 + 0.4 * std::cos(angle));
  }
  const auto domain = TestInputs::Loops({ ellipse });
  domain->GetPointData()->AddArray(lengths);
  std::set<double> abscissas;
  for (const int sizing :
    { vtkQuadMesher::SizingConformal, vtkQuadMesher::SizingUniform, vtkQuadMesher::SizingField })
  {
    vtkNew<vtkQuadMesher> chosen;
    vtkNew<vtkQuadMesher> given;
    for (vtkQuadMesher* mesher : { chosen.Get(), given.Get() })
    {
      mesher->SetInputData(domain);
      mesher->SetMeshSize(0.15);
      mesher->SetQuadSize(0.1);
      mesher->SetSizing(sizing);
      mesher->SetSizeArray("Length");
    }
    given->SetSingularitiesConnection(chosen->GetOutputPort(3));
    given->SetCornersConnection(chosen->GetOutputPort(4));
    FilterChecks::UpdateWithoutError(given);
    EXPECT_EQ(FieldStrings(given, "Events"), 0);
    EXPECT_GT(FieldStrings(chosen, "Events"), 0);
    vtkPolyData* used = UsedPoints(chosen, 3);
    EXPECT_EQ(used->GetFieldData()->GetAbstractArray("Events")->GetNumberOfTuples(),
      FieldStrings(chosen, "Events"));
    EXPECT_GT(chosen->GetStageSeconds()[6], 0.0);
    chosen->GetOutput()->GetFieldData()->RemoveArray("Events");
    given->GetOutput()->GetFieldData()->RemoveArray("Events");
    EXPECT_EQ(FilterChecks::Fingerprint(chosen->GetOutput()),
      FilterChecks::Fingerprint(given->GetOutput()));
    ASSERT_GT(used->GetNumberOfPoints(), 0);
    abscissas.insert(used->GetPoint(0)[0]);
  }
  EXPECT_EQ(abscissas.size(), 3U); // each sizing has its own optimum
}

TEST_F(QuadMesher, ChoosesWhatTheProposalChoosesWhereSizesAreUniformEnough)
{
  // A clearance below that of the energy's minimum, and no target sizes: nothing moves after the
  // proposal.
  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputConnection(this->Domain->GetOutputPort());
  proposal->AutomaticOn();
  proposal->SetMeshSize(0.1);
  FilterChecks::UpdateWithoutError(proposal);
  this->Filter->SetSingularitiesConnection(nullptr);
  this->Filter->SetClearance(1e-3); // at most 1/400 of the diagonal
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkPolyData* used = UsedPoints(this->Filter, 3);
  ASSERT_EQ(used->GetNumberOfPoints(), proposal->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < used->GetNumberOfPoints(); ++i)
  {
    const Place position = PositionOf(used, i);
    const Place proposed = PositionOf(proposal->GetOutput(), i);
    EXPECT_NEAR(position[0], proposed[0], 1e-3);
    EXPECT_NEAR(position[1], proposed[1], 1e-3);
  }
}
