// Names of the boundary's sides in vtkQuadMesher and vtkBoundarySimplifier: read from cell arrays
// of lines, alone or beside surface cells, and written to boundary edges and blocks.

#include "support/FilterChecks.h"
#include "vtkBoundarySimplifier.h"
#include "vtkQuadMesher.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
const std::vector<std::array<double, 2>> Corners = { { 0, 0 }, { 3, 0 }, { 3, 2 }, { 0, 2 } };

/** Returns names of the four segments of the rectangle. */
vtkSmartPointer<vtkStringArray> Names(const char* name)
{
  auto names = vtkSmartPointer<vtkStringArray>::New();
  names->SetName(name);
  for (const char* side : { "bottom", "right", "top", "left" })
  {
    names->InsertNextValue(side);
  }
  return names;
}

/** Returns a rectangle in the plane z = y, as one line per segment. */
vtkSmartPointer<vtkPolyData> Rectangle()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  for (const auto& [x, y] : Corners)
  {
    points->InsertNextPoint(x, y, y);
  }
  for (vtkIdType i = 0; i < 4; ++i)
  {
    // against the direction of the loop every other time
    i % 2 == 0 ? lines->InsertNextCell({ i, (i + 1) % 4 })
               : lines->InsertNextCell({ (i + 1) % 4, i });
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  return data;
}

/** Returns a circle of many segments whose name changes at two vertices. */
vtkSmartPointer<vtkPolyData> Circle(int count)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkStringArray> names;
  names->SetName("Side");
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * static_cast<double>(i) / count;
    points->InsertNextPoint(std::cos(angle), std::sin(angle), 0.0);
    lines->InsertNextCell({ i, (i + 1) % count });
    names->InsertNextValue(1000 * i < 259 * count ? "a" : "b");
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetCellData()->AddArray(names);
  return data;
}

vtkStringArray* SidesOf(vtkDataSet* data)
{
  return vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray("Side"));
}

/** Returns the number of boundary lines of each name, and expects those of the rectangle. */
std::map<std::string, int> CountEdges(vtkQuadMesher* mesher)
{
  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5));
  vtkStringArray* sides = SidesOf(boundary);
  std::map<std::string, int> counts;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < boundary->GetNumberOfCells(); ++line)
  {
    boundary->GetCellPoints(line, ids);
    double from[3];
    double to[3];
    boundary->GetPoint(ids->GetId(0), from);
    boundary->GetPoint(ids->GetId(1), to);
    const double x = 0.5 * (from[0] + to[0]);
    const double y = 0.5 * (from[1] + to[1]);
    const std::string expected = y < 1e-9 ? "bottom"
      : x > 3 - 1e-9                      ? "right"
      : y > 2 - 1e-9                      ? "top"
                                          : "left";
    EXPECT_EQ(sides->GetValue(line), expected);
    ++counts[sides->GetValue(line)];
  }
  return counts;
}

vtkSmartPointer<vtkQuadMesher> MesherOf(vtkDataSet* domain)
{
  auto mesher = vtkSmartPointer<vtkQuadMesher>::New();
  mesher->SetInputData(domain);
  mesher->SetQuadSize(0.2);
  return mesher;
}
}

TEST(QuadMesherSides, EdgesAndBlocksHaveTheNamesOfLines)
{
  const auto domain = Rectangle();
  domain->GetCellData()->AddArray(Names("Side"));
  const auto mesher = MesherOf(domain);
  mesher->Update();
  EXPECT_EQ(CountEdges(mesher).size(), 4U);

  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(mesher->GetOutputDataObject(1));
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 1U);
  auto* names =
    vtkStringArray::SafeDownCast(blocks->GetBlock(0)->GetFieldData()->GetAbstractArray("SideName"));
  ASSERT_EQ(names->GetNumberOfValues(), 4);
  std::set<std::string> found;
  for (vtkIdType side = 0; side < 4; ++side)
  {
    found.insert(names->GetValue(side));
  }
  EXPECT_EQ(found, (std::set<std::string>{ "bottom", "right", "top", "left" }));

  // Files: names on lines, none on quads; they are a domain with these names.
  vtkNew<vtkUnstructuredGrid> file;
  mesher->CopyMesh(file);
  vtkStringArray* sides = SidesOf(file);
  for (vtkIdType cell = 0; cell < file->GetNumberOfCells(); ++cell)
  {
    EXPECT_EQ(sides->GetValue(cell).empty(), file->GetCellType(cell) == VTK_QUAD);
  }
  const auto again = MesherOf(file);
  again->Update();
  EXPECT_EQ(CountEdges(again).size(), 4U);
}

TEST(QuadMesherSides, ATablePrescribesWhatPropertiesDo)
{
  const auto domain = Rectangle();
  domain->GetCellData()->AddArray(Names("Side"));
  const auto byProperties = MesherOf(domain);
  byProperties->AddSide("right", "19", "both:3", "");
  byProperties->SetLayers("left:2e-3,1.3,16");
  byProperties->SetPeriodic("top:bottom");
  byProperties->SetCurves("right:line");
  byProperties->Update();

  const auto texts = [](const char* name, const std::array<const char*, 4>& values)
  {
    auto column = vtkSmartPointer<vtkStringArray>::New();
    column->SetName(name);
    for (const char* value : values)
    {
      column->InsertNextValue(value);
    }
    return column;
  };
  const auto numbers =
    [](const char* name, vtkSmartPointer<vtkDataArray> column, const std::array<double, 4>& values)
  {
    column->SetName(name);
    for (const double value : values)
    {
      column->InsertNextTuple1(value);
    }
    return column;
  };
  vtkNew<vtkTable> table;
  table->AddColumn(texts("Side", { "bottom", "left", "top", "right" }));
  table->AddColumn(numbers("Count", vtkSmartPointer<vtkIntArray>::New(), { 0, 0, 0, 19 }));
  table->AddColumn(texts("Progression", { "", "", "", "both:3" }));
  table->AddColumn(
    numbers("LayerFirst", vtkSmartPointer<vtkDoubleArray>::New(), { std::nan(""), 2e-3, 0, 0 }));
  table->AddColumn(texts("LayerGrowth", { "", "1.3", "", " " }));
  table->AddColumn(numbers("LayerRows", vtkSmartPointer<vtkDoubleArray>::New(), { 0, 16, 0, 0 }));
  table->AddColumn(texts("Partner", { "", "", "bottom", "" }));
  table->AddColumn(texts("Curve", { "", "", "", "line" }));
  const auto byTable = MesherOf(domain);
  byTable->SetSideTableData(table);
  byTable->Update();
  EXPECT_EQ(CountEdges(byTable)["right"], 19);
  EXPECT_EQ(CountEdges(byTable), CountEdges(byProperties));
  ASSERT_GT(byTable->GetOutput()->GetNumberOfPoints(), 0);
  ASSERT_EQ(
    byTable->GetOutput()->GetNumberOfPoints(), byProperties->GetOutput()->GetNumberOfPoints());
  for (vtkIdType point = 0; point < byTable->GetOutput()->GetNumberOfPoints(); ++point)
  {
    std::array<double, 3> place;
    byProperties->GetOutput()->GetPoint(point, place.data());
    EXPECT_EQ(
      vtkMath::Distance2BetweenPoints(place.data(), byTable->GetOutput()->GetPoint(point)), 0.0);
  }

  // What a table and a property prescribe for a side contradicts itself.
  byTable->AddSide("right", "19", "", "");
  FilterChecks::CaptureError(byTable, { "number of edges of side 'right' is prescribed twice" });
  byTable->ClearSides();
  table->AddColumn(texts("CornerRows", { "", "turnn", "", "" }));
  table->Modified();
  FilterChecks::CaptureError(byTable, { "What rows do at 'left' is 'turnn'; give end, turn" });
  table->RemoveColumnByName("CornerRows");
  table->AddColumn(texts("Layers", { "", "", "", "" }));
  FilterChecks::CaptureError(byTable, { "the column 'Layers', which is none of Side, Count, " });
  table->RemoveColumnByName("Layers");
  table->RemoveColumnByName("Side");
  FilterChecks::CaptureError(byTable, { "has no column Side" });
  table->AddColumn(texts("Side", { "bottom", "", "top", "right" }));
  FilterChecks::CaptureError(byTable, { "Row 1 of the table of sides has no name" });
  const vtkNew<vtkTable> empty;
  byTable->SetSideTableData(empty);
  byTable->Update();
  EXPECT_GT(byTable->GetOutput()->GetNumberOfCells(), 0);
}

TEST(QuadMesherSides, NamesMayBeIntegersOfAnotherArray)
{
  const auto domain = Rectangle();
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Patch");
  for (const int number : { 3, -1, 3, 12 })
  {
    numbers->InsertNextValue(number);
  }
  domain->GetCellData()->AddArray(numbers);
  const auto mesher = MesherOf(domain);
  mesher->SetSideNameArray("Patch");
  mesher->AddSide("3", "26", "", "");
  mesher->Update();
  auto* table = vtkTable::SafeDownCast(mesher->GetOutputDataObject(8));
  auto* names = vtkStringArray::SafeDownCast(table->GetFieldData()->GetAbstractArray("SideNames"));
  auto* edges = vtkIntArray::SafeDownCast(table->GetFieldData()->GetArray("SideEdges"));
  ASSERT_EQ(names->GetNumberOfValues(), 3);
  for (vtkIdType side = 0; side < 3; ++side)
  {
    EXPECT_TRUE(names->GetValue(side) != "3" || edges->GetValue(side) == 26);
  }
}

TEST(QuadMesherSides, AreGeneratedWithoutNames)
{
  const auto mesher = MesherOf(Rectangle());
  mesher->Update();
  std::set<std::string> found;
  vtkStringArray* sides = SidesOf(vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5)));
  for (vtkIdType i = 0; i < sides->GetNumberOfValues(); ++i)
  {
    found.insert(sides->GetValue(i));
  }
  EXPECT_EQ(found, (std::set<std::string>{ "outer0", "outer1", "outer2", "outer3" }));
  const auto [text, alarm] = FilterChecks::TextForView(mesher, 8, "Summary");
  EXPECT_NE(text.find("Sides: outer0 to outer3."), std::string::npos) << text;
}

TEST(QuadMesherSides, HavePlaces)
{
  const auto domain = Rectangle();
  domain->GetCellData()->AddArray(Names("Side"));
  const auto mesher = MesherOf(domain);
  mesher->Update();
  vtkStringArray* names = mesher->GetSideNames();
  vtkDoubleArray* places = mesher->GetSidePlaces();
  ASSERT_EQ(names->GetNumberOfValues(), 4);
  ASSERT_EQ(places->GetNumberOfTuples(), 4);
  const std::map<std::string, std::array<double, 2>> lines = { { "bottom", { 1, 0 } },
    { "right", { 0, 3 } }, { "top", { 1, 2 } }, { "left", { 0, 0 } } }; // axis and value
  for (vtkIdType side = 0; side < 4; ++side)
  {
    const auto& [axis, value] = lines.at(names->GetValue(side));
    EXPECT_NEAR(places->GetComponent(side, static_cast<int>(axis)), value, 1e-12);
    EXPECT_NEAR(places->GetComponent(side, 2), places->GetComponent(side, 1), 1e-12) << "z = y";
  }
  // Names stay if the mesher refuses one.
  mesher->AddSide("inlet", "12", "", "");
  FilterChecks::CaptureError(mesher, { "inlet" });
  EXPECT_EQ(names->GetNumberOfValues(), 4);
  EXPECT_EQ(places->GetNumberOfTuples(), 0);
}

TEST(QuadMesherSides, SimplifiedBoundariesKeepNames)
{
  vtkNew<vtkBoundarySimplifier> simplifier;
  const auto circle = Circle(3000);
  simplifier->SetInputData(circle);
  simplifier->SetThinningLength(0.05);
  simplifier->Update();
  auto* thin = vtkPolyData::SafeDownCast(simplifier->GetOutputDataObject(0));
  EXPECT_LT(thin->GetNumberOfPoints(), 400);
  vtkStringArray* sides = SidesOf(thin);
  std::map<std::string, double> lengths;
  vtkNew<vtkIdList> ids;
  for (vtkIdType line = 0; line < thin->GetNumberOfCells(); ++line)
  {
    thin->GetCellPoints(line, ids);
    for (vtkIdType i = 1; i < ids->GetNumberOfIds(); ++i)
    {
      double from[3];
      double to[3];
      thin->GetPoint(ids->GetId(i - 1), from);
      thin->GetPoint(ids->GetId(i), to);
      lengths[sides->GetValue(line)] += std::sqrt(vtkMath::Distance2BetweenPoints(from, to));
    }
  }
  EXPECT_NEAR(lengths["a"], 2.0 * vtkMath::Pi() * 777 / 3000, 1e-3);
  EXPECT_NEAR(lengths["b"], 2.0 * vtkMath::Pi() * 2223 / 3000, 1e-3);
}

TEST(QuadMesherSides, ThinningFollowsTheSizeOfASide)
{
  // Segments of length 2.1e-4: shorter than the default of 0.02/40 of the diagonal, longer than
  // 0.02 of the size.
  for (const double size : { 0.0, 0.004 })
  {
    vtkNew<vtkBoundarySimplifier> simplifier;
    simplifier->SetInputData(Circle(30000));
    if (size > 0.0)
    {
      simplifier->AddSideSize("a", size);
    }
    simplifier->Update();
    const bool isThinned =
      vtkPolyData::SafeDownCast(simplifier->GetOutputDataObject(0))->GetNumberOfPoints() < 30000;
    EXPECT_EQ(isThinned, size == 0.0);
  }
}

TEST(QuadMesherSides, PrescriptionsAreProperties)
{
  const auto domain = Rectangle();
  domain->GetCellData()->AddArray(Names("Side"));
  const auto mesher = MesherOf(domain);
  mesher->AddSide("bottom", "19", "both:3", "");
  mesher->Update();
  EXPECT_EQ(CountEdges(mesher)["bottom"], 19);
  mesher->ClearSides();
  mesher->AddSide("left", "", "", "0.1");
  const FilterChecks::MessageRecorder recorder(
    mesher); // sizes are met on less than 90 % of the area
  mesher->Update();
  EXPECT_TRUE(recorder.errors.empty());
  EXPECT_NEAR(CountEdges(mesher)["left"], 28, 5); // the side has the length √8
}

TEST(QuadMesherSides, SizesNearPositionsAndInsideSidesAreProperties)
{
  const auto domain = Rectangle();
  domain->GetCellData()->AddArray(Names("Side"));
  const auto mesher = MesherOf(domain);
  mesher->SetQuadSize(0.3);
  const auto quadsOf = [&]
  {
    mesher->Update();
    return mesher->GetOutput()->GetNumberOfCells();
  };
  const auto report = [&](const char* name) -> double
  {
    vtkDataArray* array = mesher->GetOutputDataObject(8)->GetFieldData()->GetArray(name);
    return array == nullptr ? -1.0 : array->GetTuple1(0);
  };
  const vtkIdType without = quadsOf();
  EXPECT_EQ(report("SizeTargetAreaShare"), -1.0);
  mesher->AddSizeNear(1.5, 1.0, 1.0, 0.04, 0.2); // in the plane z = y
  const vtkIdType with = quadsOf();
  EXPECT_GT(with, 2 * without);
  EXPECT_GT(report("SizeTargetAreaShare"), 0.9);
  EXPECT_EQ(report("SizeTargetFactor"), 1.0);
  mesher->SetGrowth(1.05); // sizes stay small farther away
  EXPECT_GT(quadsOf(), 2 * with);
  mesher->ClearSizesNear();
  mesher->SetGrowth(1.25);
  EXPECT_EQ(quadsOf(), without);
  mesher->AddSizeInside("left", "0.1");
  const FilterChecks::MessageRecorder recorder(mesher);
  mesher->Update();
  ASSERT_EQ(recorder.errors.size(), 1U);
  EXPECT_NE(recorder.errors[0].find("'left' encloses nothing"), std::string::npos)
    << recorder.errors[0];
  mesher->ClearSizesInside();
  // The rectangle as one side, by a table.
  for (vtkIdType i = 0; i < 4; ++i)
  {
    vtkStringArray::SafeDownCast(domain->GetCellData()->GetAbstractArray("Side"))
      ->SetValue(i, "all");
  }
  domain->Modified();
  vtkNew<vtkTable> table;
  vtkNew<vtkStringArray> names;
  names->SetName("Side");
  names->InsertNextValue("all");
  table->AddColumn(names);
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("SizeInside");
  sizes->InsertNextValue(0.15);
  table->AddColumn(sizes);
  mesher->SetSideTableData(table);
  EXPECT_NEAR(static_cast<double>(quadsOf()), 6.0 * std::sqrt(2.0) / 0.0225, 60.0);
}

TEST(QuadMesherSides, Refusals)
{
  const auto domain = Rectangle();
  const auto mesher = MesherOf(domain);
  const auto expectRefusal = [&mesher](const char* words)
  {
    const FilterChecks::MessageRecorder recorder(mesher);
    mesher->Update();
    ASSERT_EQ(recorder.errors.size(), 1U);
    EXPECT_NE(recorder.errors[0].find(words), std::string::npos) << recorder.errors[0];
  };
  mesher->SetSideNameArray("Missing");
  expectRefusal("no cell array 'Missing'");
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName("Missing");
  numbers->SetNumberOfValues(4);
  numbers->Fill(1.0);
  domain->GetCellData()->AddArray(numbers);
  mesher->Modified();
  expectRefusal("neither strings nor single integers");
  mesher->SetSideNameArray("");
  mesher->AddSide("outer0", "11", "", "");
  mesher->AddSide("outer2", "12", "", "");
  expectRefusal("are sides of one strip of quads");
}
