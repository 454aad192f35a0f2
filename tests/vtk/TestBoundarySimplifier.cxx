#include "support/FilterChecks.h"
#include "vtkBoundarySimplifier.h"
#include "vtkDrillHoles.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace
{
constexpr int Count = 40000;

/**
 * Creates a circle of radius 1 in the plane x = 3 with its angle as a point array, and a point that
 * no line uses.
 */
void FillCircle(vtkPolyData* circle)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> angles;
  angles->SetName("Angle");
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(Count + 1);
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / Count;
    lines->InsertCellPoint(points->InsertNextPoint(3.0, std::cos(angle), std::sin(angle)));
    angles->InsertNextValue(angle);
  }
  lines->InsertCellPoint(0);
  points->InsertNextPoint(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0);
  angles->InsertNextValue(-1.0);
  circle->SetPoints(points);
  circle->SetLines(lines);
  circle->GetPointData()->AddArray(angles);
}

double Value(vtkDataSet* data, const char* name, int component = 0)
{
  return data->GetFieldData()->GetArray(name)->GetTuple1(component);
}

TEST(BoundarySimplifier, ThinsInThePlaneOfTheDomainAndKeepsArrays)
{
  vtkNew<vtkPolyData> circle;
  FillCircle(circle);
  vtkNew<vtkBoundarySimplifier> filter;
  filter->SetInputData(circle);
  filter->SetMeshSize(1.0); // 0.02 of 1/40 of the diagonal is smaller
  FilterChecks::UpdateWithoutError(filter);
  auto* thin = vtkPolyData::SafeDownCast(filter->GetOutput());
  const double length = 0.02 * std::sqrt(8.0) / 40.0;
  const vtkIdType count = thin->GetNumberOfPoints();
  EXPECT_EQ(Value(thin, "BoundaryPoints"), Count);
  ASSERT_EQ(thin->GetFieldData()->GetArray("BoundaryPoints")->GetNumberOfTuples(), 2);
  EXPECT_EQ(Value(thin, "BoundaryPoints", 1), static_cast<double>(count));
  EXPECT_GT(static_cast<double>(count), 2.0 * vtkMath::Pi() / length);
  EXPECT_LT(count, Count);
  EXPECT_GT(Value(thin, "BoundaryMoved"), 0.0);
  EXPECT_LE(Value(thin, "BoundaryMoved"), length * length / 8.0 * 1.001);
  vtkDataArray* angles = thin->GetPointData()->GetArray("Angle");
  double farthest = 0.0; // distance from the position given by the array
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = angles->GetTuple1(i);
    const double position[3] = { 3.0, std::cos(angle), std::sin(angle) };
    farthest = std::max(farthest, vtkMath::Distance2BetweenPoints(thin->GetPoint(i), position));
  }
  EXPECT_LE(std::sqrt(farthest), 1.001 * vtkMath::Pi() / Count); // half a segment
}

/** Adds a closed square as a line or a quad, with a name. */
template <class DataSet>
void AddSquare(double x, double size, int type, const char* name, DataSet* data)
{
  std::vector<vtkIdType> ids;
  for (const auto& [dx, dy] : { std::pair(0.0, 0.0), { size, 0.0 }, { size, size }, { 0.0, size } })
  {
    ids.push_back(data->GetPoints()->InsertNextPoint(x + dx, x + dy, 0.0));
  }
  if (type == VTK_POLY_LINE)
  {
    ids.push_back(ids.front());
  }
  data->InsertNextCell(type, static_cast<int>(ids.size()), ids.data());
  vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("Side"))
    ->InsertNextValue(name);
}

/** Expects the cells and the place of each part of two squares, in data sets of their type. */
template <class DataSet>
void ExpectParts(int type)
{
  SCOPED_TRACE(type);
  vtkNew<DataSet> data;
  const vtkNew<vtkPoints> points;
  data->SetPoints(points);
  data->AllocateEstimate(8, 5);
  const vtkNew<vtkStringArray> sides;
  sides->SetName("Side");
  data->GetCellData()->AddArray(sides);
  AddSquare(10.0, 1.0, type, "small", data.Get());
  AddSquare(0.0, 4.0, type, "large", data.Get());
  if (type == VTK_POLY_LINE)
  {
    AddSquare(1.0, 1.0, type, "hole", data.Get());
  }
  const vtkIdType cells = type == VTK_POLY_LINE ? 2 : 1;
  const vtkNew<vtkBoundarySimplifier> filter;
  filter->SetInputData(data);
  FilterChecks::UpdateWithoutError(filter);
  EXPECT_EQ(
    vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0))->GetNumberOfCells(), cells + 1);
  for (const char* part : { "largest", "1", "large", "2", "small" })
  {
    SCOPED_TRACE(part);
    filter->SetPart(part);
    FilterChecks::UpdateWithoutError(filter);
    auto* output = DataSet::SafeDownCast(filter->GetOutputDataObject(0));
    ASSERT_NE(output, nullptr);
    const bool isSmall = part[0] == '2' || part[0] == 's';
    ASSERT_EQ(output->GetNumberOfCells(), isSmall ? 1 : cells);
    EXPECT_EQ(output->GetCell(0)->GetBounds()[0], isSmall ? 10.0 : 0.0);
    EXPECT_EQ(
      vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray("Side"))->GetValue(0),
      isSmall ? "small" : "large");
  }
  filter->SetPart("3");
  FilterChecks::CaptureError(filter, { "no part 3", "2 parts" });
  filter->SetPart("other");
  FilterChecks::CaptureError(filter, { "No part of the domain has a side 'other'" });
  EXPECT_EQ(data->GetNumberOfCells(), cells + 1) << "the input stays as it is";
}

TEST(BoundarySimplifier, ChoosesAPart)
{
  ExpectParts<vtkPolyData>(VTK_POLY_LINE);
  ExpectParts<vtkPolyData>(VTK_QUAD);
  ExpectParts<vtkUnstructuredGrid>(VTK_POLY_LINE);
  ExpectParts<vtkUnstructuredGrid>(VTK_QUAD);
}

TEST(BoundarySimplifier, SupportsGridsAndFixedPoints)
{
  vtkNew<vtkPolyData> circle;
  FillCircle(circle);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(circle->GetPoints());
  grid->SetCells(VTK_POLY_LINE, circle->GetLines());
  vtkNew<vtkPolyData> kept;
  vtkNew<vtkPoints> position;
  position->SetDataTypeToDouble();
  position->InsertNextPoint(circle->GetPoint(17));
  kept->SetPoints(position);
  vtkNew<vtkBoundarySimplifier> filter;
  filter->SetInputData(0, grid);
  filter->SetInputData(1, kept);
  filter->SetThinningLength(0.1);
  FilterChecks::UpdateWithoutError(filter);
  vtkDataSet* thin = vtkUnstructuredGrid::SafeDownCast(filter->GetOutput());
  ASSERT_NE(thin, nullptr);
  EXPECT_LT(thin->GetNumberOfPoints(), 200);
  const vtkIdType nearest = thin->FindPoint(circle->GetPoint(17));
  EXPECT_NEAR(
    vtkMath::Distance2BetweenPoints(thin->GetPoint(nearest), circle->GetPoint(17)), 0.0, 1e-20);
}

TEST(BoundarySimplifier, RemovesFieldDataOfEarlierRuns)
{
  vtkNew<vtkPlanarDomainSource> source;
  source->SetDomainName("star");
  source->Update();
  vtkNew<vtkPolyData> star;
  star->ShallowCopy(source->GetOutput());
  const std::array<const char*, 3> arrays = { "BoundaryMoved", "BoundaryPoints", "Other" };
  for (const char* name : arrays)
  {
    vtkNew<vtkDoubleArray> values; // as in a file with an earlier output
    values->SetName(name);
    values->InsertNextValue(1.0);
    values->InsertNextValue(1.0);
    star->GetFieldData()->AddArray(values);
  }
  vtkNew<vtkBoundarySimplifier> filter;
  filter->SetInputData(star);
  FilterChecks::UpdateWithoutError(filter);
  vtkFieldData* data = filter->GetOutput()->GetFieldData();
  EXPECT_EQ(data->GetAbstractArray("BoundaryMoved"), nullptr);
  EXPECT_EQ(data->GetAbstractArray("BoundaryPoints"), nullptr);
  EXPECT_NE(data->GetAbstractArray("Other"), nullptr);
  EXPECT_EQ(star->GetFieldData()->GetNumberOfArrays(), 3);
}

TEST(BoundarySimplifier, DistancesOfThinningAndSmoothingAddUp)
{
  vtkNew<vtkPlanarDomainSource> disk;
  disk->SetEdgeLength(0.01);
  disk->Update();
  const auto moved = [&](double thinning, double smoothing, vtkPolyData* domain)
  {
    vtkNew<vtkBoundarySimplifier> filter;
    filter->SetInputData(domain);
    filter->SetThinningLength(thinning);
    filter->SetSmoothingLength(smoothing);
    FilterChecks::UpdateWithoutError(filter);
    vtkNew<vtkPolyData> simple;
    simple->ShallowCopy(filter->GetOutput());
    domain->ShallowCopy(simple);
    return Value(simple, "BoundaryMoved");
  };
  vtkNew<vtkPolyData> domain;
  domain->ShallowCopy(disk->GetOutput());
  const double first = moved(0.1, 0.0, domain);
  const double second = moved(0.0, 0.5, domain);
  EXPECT_GT(std::min(first, second), 0.0);
  domain->ShallowCopy(disk->GetOutput());
  EXPECT_DOUBLE_EQ(moved(0.1, 0.5, domain), first + second);
}

TEST(BoundarySimplifier, PassesThroughDomainsWithoutDetailAndDrilledMeshes)
{
  vtkNew<vtkPlanarDomainSource> source;
  source->SetDomainName("star");
  vtkNew<vtkBoundarySimplifier> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetSmoothingLength(0.01);
  FilterChecks::UpdateWithoutError(filter);
  auto* same = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(same->GetPoints(), source->GetOutput()->GetPoints());
  EXPECT_EQ(same->GetFieldData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(source->GetOutput()->GetFieldData()->GetNumberOfArrays(), 0);

  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkSingularitySource> none;
  none->RemoveAllSingularities();
  drill->SetSingularitiesConnection(none->GetOutputPort());
  vtkNew<vtkBoundarySimplifier> after;
  after->SetInputConnection(drill->GetOutputPort());
  after->SetSmoothingLength(0.5);
  FilterChecks::UpdateWithoutError(after);
  EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(after->GetOutput())->GetCells(),
    drill->GetOutput()->GetCells());
}
}
