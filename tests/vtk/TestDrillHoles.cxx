#include "support/FilterChecks.h"
#include "support/MeshReading.h"
#include "support/TestInputs.h"
#include "vtkDrillHoles.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace
{
using TestInputs::Circle;
using TestInputs::Curve;
using TestInputs::Loops;
using TestInputs::Rectangle;
using TestInputs::Row;

/** Returns a rectangle with two islands. */
std::vector<Curve> Islands()
{
  return { Rectangle({ 0.0, 0.0 }, { 6.0, 4.0 }), Circle(24, 0.7, { 4.5, 2.0 }),
    Rectangle({ 1.0, 1.0 }, { 2.0, 3.0 }) };
}

/** Returns holes of different radii and indices. */
std::vector<Row> IslandHoles()
{
  return { { 3.0, 2.0, 1.0, 0.2 }, { 3.0, 3.4, -6.0, 0.05 }, { 0.5, 0.5, 0.0, 0.3 } };
}

double CurveArea(const Curve& curve)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < curve.size(); ++i)
  {
    const auto& a = curve[i];
    const auto& b = curve[(i + 1) % curve.size()];
    twice += a[0] * b[1] - a[1] * b[0];
  }
  return 0.5 * twice;
}

class DrillHoles : public testing::Test
{
public:
  void Set(vtkDataObject* domain, const std::vector<Row>& rows)
  {
    this->Filter->SetInputData(domain);
    this->Filter->SetSingularitiesData(TestInputs::Singularities(rows));
  }

  MeshReading Mesh()
  {
    FilterChecks::UpdateWithoutError(this->Filter);
    return MeshReading(this->Filter->GetOutput());
  }

  /** Returns the output for a domain as bytes. */
  std::string OutputBytes(vtkDataObject* domain, const std::vector<Row>& rows)
  {
    this->Set(domain, rows);
    FilterChecks::UpdateWithoutError(this->Filter);
    return FilterChecks::Fingerprint(this->Filter->GetOutput());
  }

  vtkNew<vtkDrillHoles> Filter;
};
}

TEST_F(DrillHoles, FollowsFilterConventions)
{
  this->Filter->SetMeshSize(0.3);
  const auto setDisk = [this] { this->Set(Loops({ Circle(40, 1.0) }), TestInputs::FourOnDisk()); };
  const auto setIslands = [this] { this->Set(Loops(Islands()), IslandHoles()); };
  FilterChecks::CheckRunTwice(this->Filter, setDisk, setIslands);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckEmptyInput(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter, { "MeshSize", "MinimumHoleEdges", "Gradation" });
}

TEST_F(DrillHoles, DoesNotChangeInputMeshes)
{
  this->Set(TestInputs::FrameMesh(), { { 1.0, 1.0, 1.0, 0.2 } });
  FilterChecks::CheckInputUntouched(this->Filter);
  this->Set(TestInputs::AsUnstructuredGrid(TestInputs::FrameMesh()), { { 1.0, 1.0, 1.0, 0.2 } });
  FilterChecks::CheckInputUntouched(this->Filter);
}

TEST_F(DrillHoles, WritesDocumentedArrays)
{
  this->Set(Loops(Islands()), IslandHoles());
  const MeshReading mesh = this->Mesh();
  vtkCellData* data = this->Filter->GetOutput()->GetCellData();
  EXPECT_EQ(data->GetNumberOfArrays(), 3);
  for (const char* name : { "BoundaryKind", "BoundaryId", "QuarterIndex" })
  {
    vtkDataArray* array = data->GetArray(name);
    ASSERT_NE(array, nullptr) << name;
    EXPECT_EQ(array->GetDataType(), VTK_INT) << name;
    EXPECT_EQ(array->GetNumberOfComponents(), 1) << name;
  }
  EXPECT_EQ(this->Filter->GetOutput()->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (const auto& triangle : mesh.triangles)
  {
    EXPECT_EQ(data->GetArray("BoundaryKind")->GetTuple1(triangle.cell), 0);
    EXPECT_EQ(data->GetArray("BoundaryId")->GetTuple1(triangle.cell), -1);
    EXPECT_EQ(data->GetArray("QuarterIndex")->GetTuple1(triangle.cell), 0);
  }
  using Code = std::array<int, 3>;
  std::set<Code> codes;
  for (const auto& line : mesh.lines)
  {
    codes.insert({ line.kind, line.id, line.quarterIndex });
  }
  const std::set<Code> expected = { { 1, 0, 0 }, { 2, 1, 0 }, { 2, 2, 0 }, { 3, 0, 1 },
    { 3, 1, -6 }, { 3, 2, 0 } };
  EXPECT_EQ(codes, expected);
}

TEST_F(DrillHoles, BoundaryLinesHaveTheDomainOnTheLeft)
{
  this->Set(Loops(Islands()), IslandHoles());
  const MeshReading mesh = this->Mesh();
  for (const auto& triangle : mesh.triangles)
  {
    EXPECT_GT(triangle.area, 0.0);
    EXPECT_LT(triangle.cell, mesh.lines.front().cell) << "lines come after the triangles";
  }
  std::set<std::array<vtkIdType, 2>> lines;
  for (const auto& line : mesh.lines)
  {
    EXPECT_EQ(mesh.sides.count(line.points), 1u) << "no triangle on the left of a line";
    lines.insert(line.points);
  }
  EXPECT_EQ(lines.size(), mesh.lines.size()) << "a line is there twice";
  for (const auto& side : mesh.sides)
  {
    const auto& [from, to] = side.first;
    EXPECT_NE(mesh.sides.count({ to, from }), lines.count({ from, to }))
      << "an edge is a line exactly if it has one triangle";
  }
}

TEST_F(DrillHoles, MeshCoversTheDomainWithoutTheHoles)
{
  this->Set(Loops(Islands()), IslandHoles());
  const MeshReading mesh = this->Mesh();
  double area = 6.0 * 4.0 - 1.0 * 2.0 - CurveArea(Circle(24, 0.7));
  const std::vector<Row> holes = IslandHoles();
  for (std::size_t row = 0; row < holes.size(); ++row)
  {
    const auto& [x, y, quarterIndex, radius] = holes[row];
    Curve walked;
    for (std::size_t line : mesh.OrderedLoop(3, static_cast<int>(row)))
    {
      const MeshReading::Place point = mesh.points[mesh.lines[line].points[0]];
      EXPECT_NEAR(std::abs(point - MeshReading::Place(x, y)), radius, 1e-14);
      walked.push_back({ point.real(), point.imag() });
    }
    EXPECT_GE(walked.size(), 32u);
    EXPECT_GE(static_cast<double>(walked.size()), 8.0 * std::abs(quarterIndex));
    const Curve regular = Circle(static_cast<int>(walked.size()), radius);
    EXPECT_NEAR(CurveArea(walked), -CurveArea(regular), 1e-13) << "clockwise and regular";
    area -= CurveArea(regular);
  }
  EXPECT_NEAR(mesh.Area(), area, 1e-11);
  mesh.OrderedLoop(1, 0);
  mesh.OrderedLoop(2, 1);
  mesh.OrderedLoop(2, 2);
}

TEST_F(DrillHoles, TrianglesHaveTheTargetSizeAndGoodAngles)
{
  for (double meshSize : { 0.4, 0.1 })
  {
    this->Filter->SetMeshSize(meshSize);
    this->Set(Loops(Islands()), IslandHoles());
    const MeshReading mesh = this->Mesh();
    EXPECT_GT(mesh.MinimumAngle(), 20.7);
    double longest = 0.0;
    for (const auto& side : mesh.sides)
    {
      const auto& [from, to] = side.first;
      longest = std::max(longest, std::abs(mesh.points[to] - mesh.points[from]));
    }
    // The longest edge of a mesh with this edge length is within these bounds.
    EXPECT_LT(longest, 2.0 * meshSize);
    EXPECT_GT(longest, 0.7 * meshSize);
  }
}

TEST_F(DrillHoles, DefaultMeshSizeIsAFortiethOfTheDiagonal)
{
  const std::string automatic = this->OutputBytes(Loops(Islands()), IslandHoles());
  this->Filter->SetMeshSize(std::hypot(6.0, 4.0) / 40.0);
  EXPECT_TRUE(this->OutputBytes(Loops(Islands()), IslandHoles()) == automatic);
  this->Filter->SetMeshSize(std::hypot(6.0, 4.0) / 30.0);
  EXPECT_FALSE(this->OutputBytes(Loops(Islands()), IslandHoles()) == automatic);
}

TEST_F(DrillHoles, WithoutRadiusAHoleHasTheMeshSize)
{
  auto singularities = TestInputs::Singularities({ { 3.0, 2.0, 1.0, 0.0 } });
  singularities->GetPointData()->RemoveArray("Radius");
  this->Filter->SetInputData(Loops(Islands()));
  this->Filter->SetSingularitiesData(singularities);
  this->Filter->SetMeshSize(0.25);
  const MeshReading mesh = this->Mesh();
  for (std::size_t line : mesh.OrderedLoop(3, 0))
  {
    const MeshReading::Place point = mesh.points[mesh.lines[line].points[0]];
    EXPECT_NEAR(std::abs(point - MeshReading::Place(3.0, 2.0)), 0.25, 1e-14);
  }
}

TEST_F(DrillHoles, QuarterIndicesMayHaveAnyNumericType)
{
  const std::string integers = this->OutputBytes(Loops(Islands()), IslandHoles());
  auto singularities = TestInputs::Singularities(IslandHoles());
  vtkNew<vtkFloatArray> quarters;
  quarters->SetName("QuarterIndex");
  for (const Row& row : IslandHoles())
  {
    quarters->InsertNextValue(static_cast<float>(row[2]));
  }
  singularities->GetPointData()->AddArray(quarters); // replaces the array of the same name
  this->Filter->SetSingularitiesData(singularities);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_TRUE(FilterChecks::Fingerprint(this->Filter->GetOutput()) == integers);
}

TEST_F(DrillHoles, MinimumHoleEdgesIsRespected)
{
  this->Filter->SetMinimumHoleEdges(100);
  this->Set(Loops({ Circle(40, 1.0) }), { { 0.0, 0.0, 1.0, 0.1 } });
  EXPECT_GE(this->Mesh().OrderedLoop(3, 0).size(), 100u);
}

TEST_F(DrillHoles, GradationBoundsEdgeGrowth)
{
  this->Filter->SetMeshSize(0.2);
  this->Set(Loops({ Circle(40, 1.0) }), { { 0.0, 0.0, 1.0, 0.01 } });
  this->Filter->SetGradation(0.1);
  const std::size_t slow = this->Mesh().triangles.size();
  this->Filter->SetGradation(0.5);
  EXPECT_GT(slow, 2 * this->Mesh().triangles.size());
}

TEST_F(DrillHoles, MeshesWithoutSingularities)
{
  this->Set(Loops(Islands()), {});
  const MeshReading mesh = this->Mesh();
  EXPECT_NEAR(mesh.Area(), 6.0 * 4.0 - 1.0 * 2.0 - CurveArea(Circle(24, 0.7)), 1e-11);
  EXPECT_TRUE(std::none_of(
    mesh.lines.begin(), mesh.lines.end(), [](const auto& line) { return line.kind == 3; }));
}

TEST_F(DrillHoles, OrderAndOrientationOfLoopsDoNotMatter)
{
  const std::string tidy = this->OutputBytes(Loops(Islands()), IslandHoles());
  EXPECT_TRUE(this->OutputBytes(TestInputs::UntidyLoops(Islands()), IslandHoles()) == tidy);

  // Loops in another order with other first points and with a duplicate last point.
  std::vector<Curve> curves = Islands();
  std::swap(curves[0], curves[2]);
  for (Curve& curve : curves)
  {
    std::rotate(curve.begin(), curve.begin() + 2, curve.end());
    curve.push_back(curve.front());
  }
  EXPECT_TRUE(this->OutputBytes(Loops(curves), IslandHoles()) == tidy);

  const auto grid = TestInputs::AsUnstructuredGrid(Loops(Islands()));
  EXPECT_TRUE(this->OutputBytes(grid, IslandHoles()) == tidy);
}

TEST_F(DrillHoles, MeshAndItsBoundaryGiveTheSameOutput)
{
  const std::vector<Row> rows = { { 1.0, 1.0, 1.0, 0.2 } };
  const std::string loops = this->OutputBytes(Loops(TestInputs::FrameCurves()), rows);
  EXPECT_TRUE(this->OutputBytes(TestInputs::FrameMesh(), rows) == loops);
  const auto grid = TestInputs::AsUnstructuredGrid(TestInputs::FrameMesh());
  EXPECT_TRUE(this->OutputBytes(grid, rows) == loops);
}

TEST_F(DrillHoles, StrayCellsAndPointsOfAMeshAreIgnored)
{
  const std::vector<Row> rows = { { 1.0, 1.0, 1.0, 0.2 } };
  const std::string loops = this->OutputBytes(Loops(TestInputs::FrameCurves()), rows);
  auto mesh = TestInputs::FrameMesh();
  // Points outside the domain and its plane would change the result if they were not ignored.
  const vtkIdType a = mesh->GetPoints()->InsertNextPoint(50.0, 50.0, 7.0);
  const vtkIdType b = mesh->GetPoints()->InsertNextPoint(-50.0, 0.0, 0.0);
  vtkNew<vtkCellArray> vertices;
  vertices->InsertNextCell({ a });
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ vtkIdType(0), b });
  mesh->SetVerts(vertices);
  mesh->SetLines(lines);
  EXPECT_TRUE(this->OutputBytes(mesh, rows) == loops);
  EXPECT_TRUE(this->OutputBytes(TestInputs::AsUnstructuredGrid(mesh), rows) == loops);

  auto withVertex = Loops(TestInputs::FrameCurves());
  const vtkIdType c = withVertex->GetPoints()->InsertNextPoint(50.0, 50.0, 7.0);
  vtkNew<vtkCellArray> vertex;
  vertex->InsertNextCell({ c });
  withVertex->SetVerts(vertex);
  EXPECT_TRUE(this->OutputBytes(withVertex, rows) == loops);
}

TEST_F(DrillHoles, OutputIsInThePlaneOfTheDomain)
{
  this->Set(Loops(Islands(), 0.0), IslandHoles());
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkNew<vtkUnstructuredGrid> flat;
  flat->DeepCopy(this->Filter->GetOutput());
  // The z of the singularities is ignored; it stays 0.
  this->Set(Loops(Islands(), -3.25), IslandHoles());
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* shifted = this->Filter->GetOutput();
  ASSERT_EQ(shifted->GetNumberOfPoints(), flat->GetNumberOfPoints());
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(shifted->GetPoint(i)[2], -3.25);
    EXPECT_EQ(MeshReading::Place(shifted->GetPoint(i)[0], shifted->GetPoint(i)[1]),
      MeshReading::Place(flat->GetPoint(i)[0], flat->GetPoint(i)[1]));
  }
}

TEST_F(DrillHoles, TheUnitOfLengthDoesNotMatter)
{
  this->Set(Loops(Islands()), IslandHoles());
  const MeshReading plain = this->Mesh();
  for (double scale : { 0x1p20, 0x1p-20 }) // powers of two, which cause no rounding
  {
    std::vector<Curve> curves = Islands();
    for (Curve& curve : curves)
    {
      for (auto& place : curve)
      {
        place = { scale * place[0], scale * place[1] };
      }
    }
    std::vector<Row> rows = IslandHoles();
    for (auto& [x, y, quarterIndex, radius] : rows)
    {
      x *= scale;
      y *= scale;
      radius *= scale;
    }
    this->Set(Loops(curves), rows);
    const MeshReading scaled = this->Mesh();
    ASSERT_EQ(scaled.points.size(), plain.points.size());
    ASSERT_EQ(scaled.triangles.size(), plain.triangles.size());
    for (std::size_t i = 0; i < plain.points.size(); ++i)
    {
      EXPECT_NEAR(std::abs(scaled.points[i] / scale - plain.points[i]), 0.0, 1e-9);
    }
  }
}
