// Hexahedra from the outputs of vtkQuadMesher and from one grid.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkExtrudeQuads.h"
#include "vtkQuadMeshWriter.h"
#include "vtkQuadMesher.h"
#include "vtkQuadsToHigherOrder.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTetra.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>

namespace
{
class ExtrudeQuads : public testing::Test
{
public:
  void SetUp() override
  {
    // A rectangle with its lower side on the axis y = 0, and a hole.
    this->Mesher->SetInputData(
      TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }),
                          TestInputs::Rectangle({ 1.5, 1.5 }, { 2.5, 2.5 }) },
        0.5));
    this->Mesher->SetQuadCount(100);
    this->Filter->SetInputConnection(this->Mesher->GetOutputPort());
    this->Filter->SetBoundaryConnection(this->Mesher->GetOutputPort(5));
  }

  std::map<int, int> Types() const
  {
    std::map<int, int> types;
    vtkUnstructuredGrid* mesh = this->Filter->GetOutput();
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      ++types[mesh->GetCellType(cell)];
    }
    return types;
  }

  /** Returns the sum of the volumes of hexahedra and prisms. */
  double Volume() const
  {
    double sum = 0.0;
    vtkNew<vtkIdList> ids;
    vtkNew<vtkPoints> corners;
    for (vtkIdType c = 0; c < this->Filter->GetOutput()->GetNumberOfCells(); ++c)
    {
      vtkCell* cell = this->Filter->GetOutput()->GetCell(c);
      if (cell->GetCellDimension() < 3)
      {
        continue;
      }
      cell->Triangulate(0, ids, corners);
      for (vtkIdType i = 0; i < corners->GetNumberOfPoints(); i += 4)
      {
        double at[4][3];
        for (vtkIdType corner = 0; corner < 4; ++corner)
        {
          corners->GetPoint(i + corner, at[corner]);
        }
        sum += std::abs(vtkTetra::ComputeVolume(at[0], at[1], at[2], at[3]));
      }
    }
    return sum;
  }

  void Refuse(const std::string& words)
  {
    FilterChecks::MessageRecorder recorder(this->Filter);
    this->Filter->Update();
    EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
    EXPECT_NE(this->Filter->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    ASSERT_EQ(recorder.errors.size(), 1U);
    EXPECT_NE(recorder.errors[0].find(words), std::string::npos) << recorder.errors[0];
  }

  vtkNew<vtkQuadMesher> Mesher;
  vtkNew<vtkExtrudeQuads> Filter;
};
}

TEST_F(ExtrudeQuads, TranslationHasCellsFacesArraysAndBlocks)
{
  this->Filter->SetHeight(0.5);
  this->Filter->SetLayers(3);
  this->Filter->Update();
  const auto quads = static_cast<int>(this->Mesher->GetOutput()->GetNumberOfCells());
  const auto edges = static_cast<int>(
    vtkPolyData::SafeDownCast(this->Mesher->GetOutputDataObject(5))->GetNumberOfCells());
  EXPECT_EQ(this->Types(),
    (std::map<int, int>{ { VTK_QUAD, 3 * edges + 2 * quads }, { VTK_HEXAHEDRON, 3 * quads } }));
  EXPECT_NEAR(this->Volume(), 15.0 * 0.5, 1e-12);
  vtkUnstructuredGrid* mesh = this->Filter->GetOutput();
  auto* sides = vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("Side"));
  ASSERT_NE(sides, nullptr);
  std::map<std::string, int> faces;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    const double layer = FilterChecks::RequireArray(mesh->GetCellData(), "K")->GetTuple1(cell);
    const double block =
      FilterChecks::RequireArray(mesh->GetCellData(), "BlockId")->GetTuple1(cell);
    EXPECT_EQ(layer, cell < 3 * quads ? std::floor(static_cast<double>(cell) / quads) : -1.0);
    EXPECT_GE(block, 0.0);
    const double column = FilterChecks::RequireArray(mesh->GetCellData(), "I")->GetTuple1(cell);
    EXPECT_EQ(column >= 0.0, cell < 3 * quads);
    ++faces[sides->GetValue(cell)];
  }
  EXPECT_EQ(faces[""], 3 * quads);
  EXPECT_EQ(faces["back"], quads);
  EXPECT_EQ(faces["front"], quads);
  EXPECT_EQ(faces.size(), 3U + 8U) << "four sides outside and four of the hole";
  EXPECT_EQ(mesh->GetFieldData()->GetArray("SweepHeight")->GetTuple1(0), 0.5);
  EXPECT_TRUE(mesh->GetPointData()->HasArray("Valence"));

  auto* flat = vtkMultiBlockDataSet::SafeDownCast(this->Mesher->GetOutputDataObject(1));
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(1));
  ASSERT_EQ(blocks->GetNumberOfBlocks(), flat->GetNumberOfBlocks());
  for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
  {
    auto* grid = vtkStructuredGrid::SafeDownCast(blocks->GetBlock(b));
    auto* base = vtkStructuredGrid::SafeDownCast(flat->GetBlock(b));
    ASSERT_EQ(grid->GetNumberOfPoints(), 4 * base->GetNumberOfPoints());
    for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
    {
      const double* below = base->GetPoint(i % base->GetNumberOfPoints());
      const double x = below[0];
      const double y = below[1];
      EXPECT_EQ(grid->GetPoint(i)[0], x);
      EXPECT_EQ(grid->GetPoint(i)[1], y);
    }
  }
}

TEST_F(ExtrudeQuads, RevolutionHasPrismsOnTheAxis)
{
  this->Filter->SetMotionToRevolution();
  this->Filter->SetAngle(360.0);
  this->Filter->SetLayers(90);
  this->Filter->Update();
  std::map<int, int> types = this->Types();
  EXPECT_GT(types[VTK_WEDGE], 0);
  EXPECT_GT(types[VTK_HEXAHEDRON], types[VTK_WEDGE]);
  const double exact = vtkMath::Pi() * (16.0 * 4.0 - 2.0 * 2.0);
  EXPECT_NEAR(this->Volume() / exact, 1.0, 1e-3);
  auto* sides = vtkStringArray::SafeDownCast(
    this->Filter->GetOutput()->GetCellData()->GetAbstractArray("Side"));
  EXPECT_EQ(sides->LookupValue("back"), -1);
  EXPECT_EQ(sides->LookupValue("outer0"), -1) << "the side on the axis";
  // What the writer reads from the grid has the same faces.
  vtkNew<vtkQuadMeshWriter> writer;
  writer->SetInputData(this->Filter->GetOutput());
  writer->SetFileName("a.msh");
  writer->WriteToOutputStringOn();
  EXPECT_EQ(writer->Write(), 1);
  EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
}

TEST_F(ExtrudeQuads, NodesOfOrderTwoAreWhereVtkHasThem)
{
  vtkNew<vtkUnstructuredGrid> mesh;
  this->Mesher->Update();
  this->Mesher->CopyMesh(mesh);
  vtkNew<vtkQuadsToHigherOrder> raiser;
  raiser->SetInputData(mesh);
  this->Filter->SetInputConnection(raiser->GetOutputPort());
  this->Filter->SetBoundaryConnection(nullptr);
  this->Filter->SetLayers(2);
  this->Filter->Update();
  ASSERT_EQ(this->Types().count(VTK_TRIQUADRATIC_HEXAHEDRON), 1U);
  EXPECT_EQ(this->Types().size(), 2U);
  // Edges are straight, so each node is the trilinear image of its place in the unit cube.
  vtkUnstructuredGrid* solid = this->Filter->GetOutput();
  for (vtkIdType c = 0; c < solid->GetNumberOfCells(); ++c)
  {
    vtkCell* cell = solid->GetCell(c);
    const int dimension = cell->GetCellDimension();
    double* places = cell->GetParametricCoords();
    for (vtkIdType node = 0; node < cell->GetNumberOfPoints(); ++node)
    {
      double expected[3] = { 0.0, 0.0, 0.0 };
      for (vtkIdType corner = 0; corner < (dimension == 2 ? 4 : 8); ++corner)
      {
        double weight = 1.0;
        for (int d = 0; d < dimension; ++d)
        {
          const double at = places[3 * node + d];
          weight *= places[3 * corner + d] > 0.5 ? at : 1.0 - at;
        }
        for (int d = 0; d < 3; ++d)
        {
          expected[d] += weight * cell->GetPoints()->GetPoint(corner)[d];
        }
      }
      const double* found = cell->GetPoints()->GetPoint(node);
      ASSERT_NEAR(std::sqrt(vtkMath::Distance2BetweenPoints(found, expected)), 0.0, 1e-12)
        << "cell " << c << ", node " << node;
    }
  }
}

TEST_F(ExtrudeQuads, TwiceOnOtherInputAndInputUntouched)
{
  this->Mesher->Update();
  vtkNew<vtkUnstructuredGrid> before;
  before->DeepCopy(this->Mesher->GetOutput());
  this->Filter->Update();
  const vtkIdType first = this->Filter->GetOutput()->GetNumberOfCells();
  this->Filter->SetLayers(2);
  this->Filter->Update();
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfCells(), first);
  EXPECT_EQ(before->GetNumberOfPoints(), this->Mesher->GetOutput()->GetNumberOfPoints());
  EXPECT_EQ(before->GetCellData()->GetNumberOfArrays(),
    this->Mesher->GetOutput()->GetCellData()->GetNumberOfArrays());
  this->Mesher->SetQuadCount(400);
  this->Filter->Update();
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfCells(), first * 2);
}

TEST_F(ExtrudeQuads, EmptyInputGivesEmptyOutputs)
{
  vtkNew<vtkUnstructuredGrid> empty;
  this->Filter->SetInputData(empty);
  this->Filter->SetBoundaryConnection(nullptr);
  FilterChecks::MessageRecorder recorder(this->Filter);
  this->Filter->Update();
  EXPECT_TRUE(recorder.errors.empty());
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfCells(), 0);
}

TEST_F(ExtrudeQuads, Errors)
{
  this->Filter->SetLayers(0);
  this->Refuse("give at least 1");
  this->Filter->SetLayers(1);
  this->Filter->SetHeight(-1.0);
  this->Refuse("must be positive");
  this->Filter->SetMotionToRevolution();
  this->Filter->SetAngle(400.0);
  this->Refuse("at most 360");
  this->Filter->SetAngle(40.0);
  vtkNew<vtkUnstructuredGrid> alone;
  alone->ShallowCopy(this->Mesher->GetOutput());
  this->Filter->SetBoundaryConnection(nullptr);
  this->Filter->Update(); // with the boundary of the mesher
  EXPECT_GT(this->Filter->GetOutput()->GetNumberOfCells(), 0);
  this->Filter->SetInputData(alone);
  this->Refuse("no boundary edges");
}
