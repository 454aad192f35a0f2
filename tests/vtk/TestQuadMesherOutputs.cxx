// The quads of QuadMesher and what it reports of them: outputs 2 and 5 to 8.

#include "support/DiskTest.h"
#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkQuadMesher.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"
#include "vtkVariant.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
using Place = std::array<double, 3>;

Place PlaceOf(vtkPoints* points, vtkIdType i)
{
  Place place{};
  points->GetPoint(i, place.data());
  return place;
}

class QuadMesherOutputs : public DiskTest<vtkQuadMesher>
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

  vtkTable* Table() { return vtkTable::SafeDownCast(this->Filter->GetOutputDataObject(8)); }

  /** Returns the first value of an array of the report. */
  double Report(const char* name)
  {
    return FilterChecks::RequireArray(this->Table()->GetFieldData(), name)->GetComponent(0, 0);
  }

  std::string Summary() { return this->Table()->GetValueByName(0, "Summary").ToString(); }
};
}

/// The layout is the sides of the blocks, even if singularities have moved from the separatrices of
/// the map: its edges are edges of quads, and exactly those between different blocks, those on the
/// boundary and those where a block meets itself.
TEST_F(QuadMesherOutputs, LayoutFollowsTheQuads)
{
  this->Filter->SetQuadSize(0.0);
  this->Filter->SetQuadCount(300);
  this->Filter->SetSizingToUniform();
  FilterChecks::UpdateWithoutError(this->Filter);
  ASSERT_GT(this->Report("Moved"), 0.001);
  using Edge = std::set<Place>;
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  vtkDataArray* block = FilterChecks::RequireArray(quads->GetCellData(), "BlockId");
  std::map<Edge, std::vector<double>> blocksOf;
  for (vtkIdType cell = 0; cell < quads->GetNumberOfCells(); ++cell)
  {
    vtkPoints* corners = quads->GetCell(cell)->GetPoints();
    for (vtkIdType corner = 0; corner < 4; ++corner)
    {
      blocksOf[{ PlaceOf(corners, corner), PlaceOf(corners, (corner + 1) % 4) }].push_back(
        block->GetTuple1(cell));
    }
  }
  std::set<Edge> between;
  for (const auto& [edge, blocks] : blocksOf)
  {
    if (blocks.size() == 1 || blocks[0] != blocks[1])
    {
      between.insert(edge);
    }
  }
  std::set<Edge> drawn;
  vtkPolyData* layout = this->Lines(2);
  for (vtkIdType side = 0; side < layout->GetNumberOfCells(); ++side)
  {
    vtkPoints* places = layout->GetCell(side)->GetPoints();
    EXPECT_EQ(FilterChecks::RequireArray(layout->GetCellData(), "Edges")->GetTuple1(side),
      static_cast<double>(places->GetNumberOfPoints() - 1));
    for (vtkIdType i = 1; i < places->GetNumberOfPoints(); ++i)
    {
      const Edge edge = { PlaceOf(places, i - 1), PlaceOf(places, i) };
      EXPECT_EQ(blocksOf.count(edge), 1U);
      EXPECT_TRUE(drawn.insert(edge).second) << "a side is drawn twice";
    }
  }
  EXPECT_EQ(drawn, between);
  // The separatrices are elsewhere, since singularities have moved.
  vtkPolyData* separatrices = this->Lines(7);
  EXPECT_EQ(separatrices->GetNumberOfLines(), 12); // four pairs meet head-on
  bool differs = false;
  for (vtkIdType line = 0; line < separatrices->GetNumberOfCells(); ++line)
  {
    vtkPoints* places = separatrices->GetCell(line)->GetPoints();
    for (vtkIdType i = 1; i < places->GetNumberOfPoints(); ++i)
    {
      differs = differs || blocksOf.count({ PlaceOf(places, i - 1), PlaceOf(places, i) }) == 0;
    }
  }
  EXPECT_TRUE(differs);
}

/// Each boundary edge has one quad, on its left; the boundary has the points of the quads.
TEST_F(QuadMesherOutputs, BoundaryIsAnOutput)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  std::multiset<std::array<vtkIdType, 2>> sides;
  for (vtkIdType cell = 0; cell < quads->GetNumberOfCells(); ++cell)
  {
    ASSERT_EQ(quads->GetCellType(cell), VTK_QUAD);
    vtkIdList* corners = quads->GetCell(cell)->GetPointIds();
    for (vtkIdType corner = 0; corner < 4; ++corner)
    {
      sides.insert({ corners->GetId(corner), corners->GetId((corner + 1) % 4) });
    }
  }
  vtkPolyData* boundary = this->Lines(5);
  vtkDataArray* vertices = FilterChecks::RequireArray(boundary->GetPointData(), "VertexId");
  EXPECT_EQ(boundary->GetNumberOfPoints(), boundary->GetNumberOfCells()); // closed loops
  for (vtkIdType line = 0; line < boundary->GetNumberOfCells(); ++line)
  {
    std::array<vtkIdType, 2> ends{};
    for (vtkIdType end = 0; end < 2; ++end)
    {
      const vtkIdType point = boundary->GetCell(line)->GetPointId(static_cast<int>(end));
      const auto vertex = static_cast<vtkIdType>(vertices->GetTuple1(point));
      EXPECT_EQ(PlaceOf(boundary->GetPoints(), point), PlaceOf(quads->GetPoints(), vertex));
      ends[static_cast<std::size_t>(end)] = vertex;
    }
    EXPECT_EQ(sides.count(ends), 1U);
    EXPECT_EQ(sides.count({ ends[1], ends[0] }), 0U);
    EXPECT_EQ(
      FilterChecks::RequireArray(boundary->GetCellData(), "BoundaryKind")->GetTuple1(line), 1.0);
  }
}

/// Files have quads and boundary edges in one grid, with the report.
TEST_F(QuadMesherOutputs, CopyMeshHasQuadsAndBoundary)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  vtkPolyData* boundary = this->Lines(5);
  const vtkNew<vtkUnstructuredGrid> mesh;
  this->Filter->CopyMesh(mesh);
  const vtkIdType count = quads->GetNumberOfCells();
  EXPECT_EQ(quads->GetFieldData()->GetNumberOfArrays(), 0); // ParaView would offer them as colours
  ASSERT_EQ(mesh->GetNumberOfCells(), count + boundary->GetNumberOfCells());
  EXPECT_EQ(FilterChecks::RequireArray(mesh->GetFieldData(), "Quads")->GetTuple1(0),
    static_cast<double>(count));
  const auto at = [&mesh](const char* name, vtkIdType cell)
  { return FilterChecks::RequireArray(mesh->GetCellData(), name)->GetTuple1(cell); };
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const bool isLine = cell >= count;
    ASSERT_EQ(mesh->GetCellType(cell), isLine ? VTK_LINE : VTK_QUAD);
    EXPECT_EQ(at("BlockId", cell) < 0.0, isLine);
    EXPECT_EQ(at("BoundaryKind", cell), isLine ? 1.0 : 0.0);
    EXPECT_EQ(at("BoundaryId", cell), isLine ? 0.0 : -1.0);
    if (isLine)
    {
      EXPECT_EQ(at("ScaledJacobian", cell), 1.0);
      EXPECT_EQ(PlaceOf(mesh->GetCell(cell)->GetPoints(), 0),
        PlaceOf(boundary->GetCell(cell - count)->GetPoints(), 0));
    }
  }
}

/// Four nodes of valence 3, where the quads have them, also after they have moved.
TEST_F(QuadMesherOutputs, IrregularNodesAreAnOutput)
{
  this->Filter->SetSizingToUniform();
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  std::map<Place, int> quadsAt;
  for (vtkIdType cell = 0; cell < quads->GetNumberOfCells(); ++cell)
  {
    for (vtkIdType corner = 0; corner < 4; ++corner)
    {
      ++quadsAt[PlaceOf(quads->GetCell(cell)->GetPoints(), corner)];
    }
  }
  vtkPolyData* nodes = this->Lines(6);
  ASSERT_EQ(nodes->GetNumberOfPoints(), 4);
  EXPECT_EQ(nodes->GetNumberOfVerts(), 4);
  for (vtkIdType node = 0; node < 4; ++node)
  {
    EXPECT_EQ(quadsAt[PlaceOf(nodes->GetPoints(), node)], 3);
    EXPECT_EQ(FilterChecks::RequireArray(nodes->GetPointData(), "Valence")->GetTuple1(node), 3.0);
    EXPECT_EQ(
      FilterChecks::RequireArray(nodes->GetPointData(), "QuarterIndex")->GetTuple1(node), 1.0);
  }
}

/// The text reports the measured quality, and after a failure the message.
TEST_F(QuadMesherOutputs, SummaryIsATextForTheView)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  double minimum = 180.0;
  for (vtkIdType cell = 0; cell < quads->GetNumberOfCells(); ++cell)
  {
    vtkPoints* corners = quads->GetCell(cell)->GetPoints();
    for (vtkIdType corner = 0; corner < 4; ++corner)
    {
      const Place place = PlaceOf(corners, corner);
      std::array<Place, 2> sides = { PlaceOf(corners, (corner + 1) % 4),
        PlaceOf(corners, (corner + 3) % 4) };
      for (Place& side : sides)
      {
        vtkMath::Subtract(side.data(), place.data(), side.data());
      }
      minimum = std::min(minimum,
        vtkMath::DegreesFromRadians(
          vtkMath::AngleBetweenVectors(sides[0].data(), sides[1].data())));
    }
  }
  EXPECT_NEAR(this->Report("MinimumAngle"), minimum, 1e-9);
  EXPECT_EQ(this->Report("Alarm"), 0.0);
  std::string text = this->Summary();
  std::replace(text.begin(), text.end(), '\n', ' ');
  char expected[200];
  std::snprintf(expected, sizeof expected,
    "%d quads in 5 blocks; minimum angle %.0f°, minimum scaled Jacobian %.2f; irregular nodes: 4 of "
    "valence 3. Sides: outer0.",
    static_cast<int>(quads->GetNumberOfCells()), minimum, this->Report("ScaledJacobianRange"));
  EXPECT_EQ(text, expected);
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 0.3, 0.0, 1.0, 0.1 } }));
  FilterChecks::CaptureError(this->Filter, { "add up to 1" });
  EXPECT_NE(this->Summary().find("add up to 1"), std::string::npos) << this->Summary();
  EXPECT_EQ(this->Report("Alarm"), 1.0);
  EXPECT_EQ(quads->GetNumberOfCells(), 0);
}

/// Where grid lines do not close up, the text says how much quads are stretched.
TEST_F(QuadMesherOutputs, SummaryNamesTheStretch)
{
  this->Domain->SetDomainName("ring");
  std::vector<TestInputs::Row> rows;
  for (int i = 0; i < 4; ++i)
  {
    const double turn = 0.5 * vtkMath::Pi() * i;
    rows.push_back({ 0.8 * std::cos(turn), 0.8 * std::sin(turn), 1.0, 0.02 });
    rows.push_back({ 0.55 * std::cos(turn + 0.6), 0.55 * std::sin(turn + 0.6), -1.0, 0.02 });
  }
  this->Filter->SetSingularitiesData(TestInputs::Singularities(rows));
  FilterChecks::UpdateWithoutError(this->Filter);
  ASSERT_GT(this->Report("PredictedStretch"), 1.5);
  std::string text = this->Summary();
  std::replace(text.begin(), text.end(), '\n', ' ');
  const std::string reason =
    vtkStringArray::SafeDownCast(this->Table()->GetFieldData()->GetAbstractArray("StretchReason"))
      ->GetValue(0);
  EXPECT_NE(text.find(reason), std::string::npos) << text;
}
