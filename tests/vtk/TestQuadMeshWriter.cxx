// Files for solvers from the outputs of vtkQuadMesher and from one grid; no file after a failure.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkQuadMeshWriter.h"
#include "vtkQuadMesher.h"
#include "vtkQuadsToHigherOrder.h"

#include "vtkCellData.h"
#include "vtkElevationFilter.h"
#include "vtkErrorCode.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

namespace
{
namespace fs = std::filesystem;

class QuadMeshWriter : public testing::Test
{
public:
  void SetUp() override
  {
    this->Mesher->SetInputData(TestInputs::Loops(
      { TestInputs::Rectangle({ -2.0, -2.0 }, { 2.0, 2.0 }), TestInputs::Circle(12, 1.0) }, 0.5));
    this->Mesher->SetQuadCount(100);
    this->Mesher->Update();
    this->Mesher->CopyMesh(this->Mesh);
    this->Folder = fs::path(testing::TempDir()) /
      ("quad_mesh_writer_" +
        std::string(testing::UnitTest::GetInstance()->current_test_info()->name()));
    fs::create_directory(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  std::string File(const std::string& name) const { return (this->Folder / name).string(); }

  std::string Write(
    vtkDataObject* input, const std::string& name, vtkDataObject* boundary = nullptr)
  {
    vtkNew<vtkQuadMeshWriter> writer;
    writer->SetInputDataObject(input);
    writer->SetBoundaryData(boundary);
    writer->SetFileName(this->File(name));
    EXPECT_EQ(writer->Write(), 1);
    EXPECT_EQ(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    std::ifstream file(this->File(name), std::ios::binary);
    return { std::istreambuf_iterator<char>(file), {} };
  }

  /** Writes a grid, expects a message with these words and no other file in the folder than before. */
  void Refuse(vtkUnstructuredGrid* input, const std::string& name, const std::string& words)
  {
    vtkNew<vtkQuadMeshWriter> writer;
    writer->SetInputData(input);
    writer->SetFileName(this->File(name));
    FilterChecks::MessageRecorder recorder(writer);
    writer->Write();
    EXPECT_NE(writer->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
    ASSERT_EQ(recorder.errors.size(), 1U);
    EXPECT_NE(recorder.errors[0].find(words), std::string::npos) << recorder.errors[0];
  }

  std::size_t Files() const
  {
    return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(this->Folder), fs::directory_iterator()));
  }

  vtkNew<vtkQuadMesher> Mesher;
  vtkNew<vtkUnstructuredGrid> Mesh;
  fs::path Folder;
};

int CountOf(const std::string& text, const std::string& part)
{
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}
}

TEST_F(QuadMeshWriter, TwoOutputsAndOneGridGiveTheSameFiles)
{
  for (const char* name : { "a.msh", "a.inp", "a.su2" })
  {
    const std::string joined = this->Write(this->Mesh, name);
    EXPECT_GT(joined.size(), 1000U);
    EXPECT_EQ(
      this->Write(this->Mesher->GetOutput(), name, this->Mesher->GetOutputDataObject(5)), joined);
    vtkNew<vtkQuadsToHigherOrder> first;
    first->SetInputConnection(this->Mesher->GetOutputPort());
    first->SetBoundaryConnection(this->Mesher->GetOutputPort(5));
    first->SetOrder(1);
    first->Update();
    EXPECT_EQ(this->Write(first->GetOutput(), name), joined);
  }
  EXPECT_EQ(this->Files(), 3U) << "no temporary files";
}

TEST_F(QuadMeshWriter, FindsTheBoundaryEdgesUpstream)
{
  const auto write = [this](vtkAlgorithm* source)
  {
    vtkNew<vtkQuadMeshWriter> writer;
    writer->SetInputConnection(source->GetOutputPort());
    writer->SetFileName(this->File("a.su2"));
    EXPECT_EQ(writer->Write(), 1);
    std::ifstream file(this->File("a.su2"), std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string joined = this->Write(this->Mesh, "b.su2");
  EXPECT_EQ(write(this->Mesher), joined);
  // Behind filters that only add arrays.
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputConnection(this->Mesher->GetOutputPort());
  EXPECT_EQ(write(elevation), joined);
  // Of the present mesh.
  this->Mesher->SetQuadCount(200);
  const std::string finer = write(elevation);
  EXPECT_NE(finer, joined);
  vtkNew<vtkQuadsToHigherOrder> first;
  first->SetInputConnection(this->Mesher->GetOutputPort());
  first->SetOrder(1);
  EXPECT_EQ(write(first), finer);

  // Where the points differ, they are not found; the remedy of the message works.
  vtkNew<vtkTransform> transform;
  transform->Scale(2.0, 2.0, 1.0);
  vtkNew<vtkTransformFilter> scaled;
  scaled->SetTransform(transform);
  scaled->SetInputConnection(this->Mesher->GetOutputPort());
  vtkNew<vtkQuadMeshWriter> writer;
  writer->SetInputConnection(scaled->GetOutputPort());
  writer->SetFileName(this->File("c.su2"));
  FilterChecks::MessageRecorder recorder(writer);
  writer->Write();
  ASSERT_EQ(recorder.errors.size(), 1U);
  EXPECT_NE(recorder.errors[0].find("directly behind Quad Mesher"), std::string::npos)
    << recorder.errors[0];
  scaled->SetInputConnection(first->GetOutputPort());
  EXPECT_EQ(CountOf(write(scaled), "MARKER_TAG="), CountOf(joined, "MARKER_TAG="));
}

TEST_F(QuadMeshWriter, BinaryFormats)
{
  EXPECT_EQ(this->Write(this->Mesh, "a.EX2").substr(0, 4), std::string("CDF\x02"));
  EXPECT_EQ(this->Write(this->Mesh, "a.vtk").rfind("# vtk DataFile", 0), 0U);
  const std::string grid = this->Write(this->Mesh, "a.xyz");
  EXPECT_TRUE(fs::exists(this->Folder / "a.nmf"));
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(this->Mesher->GetOutputDataObject(1));
  EXPECT_EQ(std::stoul(grid), static_cast<unsigned long>(blocks->GetNumberOfBlocks()));
  if (vtkQuadMeshWriter::ReasonAgainst("a.cgns", 1).empty())
  {
    EXPECT_EQ(this->Write(this->Mesh, "a.cgns").substr(1, 3), "HDF");
  }
  EXPECT_TRUE(vtkQuadMeshWriter::CanWrite("a.exo"));
  EXPECT_FALSE(vtkQuadMeshWriter::CanWrite("a.case"));
  EXPECT_NE(vtkQuadMeshWriter::ReasonAgainst("a.cgns", 2), "");
}

TEST_F(QuadMeshWriter, FormatsOfBlocksNeedTheirArrays)
{
  this->Mesh->GetCellData()->RemoveArray("J");
  for (const char* name : { "a.xyz", "a.cgns" })
  {
    const std::string reason = vtkQuadMeshWriter::ReasonAgainst(name, 1);
    this->Refuse(this->Mesh, name, reason.empty() ? "BlockId" : "built without");
  }
  EXPECT_EQ(this->Files(), 0U);
}

TEST_F(QuadMeshWriter, EndingAndVersionGiveTheFormat)
{
  EXPECT_EQ(this->Write(this->Mesh, "a.MSH").rfind("$MeshFormat\n4.1 0 8\n", 0), 0U);
  EXPECT_EQ(this->Write(this->Mesh, "a.msh2").rfind("$MeshFormat\n2.2 0 8\n", 0), 0U);
  EXPECT_EQ(this->Write(this->Mesh, "a.su2").rfind("NDIME= 2\n", 0), 0U);
  EXPECT_NE(this->Write(this->Mesh, "a.inp").find("*ELEMENT, TYPE=CPS4, ELSET=domain\n"),
    std::string::npos);
  vtkNew<vtkQuadMeshWriter> writer;
  writer->SetInputData(this->Mesh);
  writer->SetFileName("nowhere/a.msh");
  writer->SetMshVersion(vtkQuadMeshWriter::Msh22);
  writer->WriteToOutputStringOn();
  writer->Write();
  ASSERT_EQ(writer->GetOutputFiles().size(), 1U);
  EXPECT_EQ(writer->GetOutputFiles()[0].first, "nowhere/a.msh");
  const std::string& text = writer->GetOutputFiles()[0].second;
  EXPECT_EQ(text.rfind("$MeshFormat\n2.2 0 8\n", 0), 0U);
  for (const char* side : { "1 \"outer0\"", "1 \"outer3\"", "1 \"hole0\"", "2 \"domain\"" })
  {
    const std::string name = std::string(side).substr(1);
    EXPECT_EQ(CountOf(text, name), 1) << name;
  }
}

TEST_F(QuadMeshWriter, HigherOrders)
{
  vtkNew<vtkQuadsToHigherOrder> raiser;
  raiser->SetInputData(this->Mesh);
  for (int order = 2; order <= 3; ++order)
  {
    raiser->SetOrder(order);
    raiser->Update();
    const std::string text = this->Write(raiser->GetOutput(), "a.msh");
    EXPECT_EQ(CountOf(text, order == 2 ? "\n2 6 10 " : "\n2 6 36 "), 1) << text.substr(0, 500);
  }
  this->Refuse(raiser->GetOutput(), "a.inp", "no elements of order 3");
  this->Refuse(raiser->GetOutput(), "a.su2", "order 1 only");
  EXPECT_NE(vtkQuadMeshWriter::ReasonAgainst("a.su2", 2), "");
  EXPECT_EQ(vtkQuadMeshWriter::ReasonAgainst("a.inp", 2), "");
}

TEST_F(QuadMeshWriter, FailuresLeaveOldFilesAndNoNewOnes)
{
  const std::string before = this->Write(this->Mesh, "a.msh");
  auto* quads = vtkUnstructuredGrid::SafeDownCast(this->Mesher->GetOutput());
  this->Refuse(quads, "a.msh", "no boundary edges");
  this->Refuse(this->Mesh, "a.med", "ending");
  this->Refuse(this->Mesh, "no/a.msh", "cannot be written");
  vtkNew<vtkUnstructuredGrid> nothing;
  this->Refuse(nothing, "b.msh", "no quads");
  vtkNew<vtkUnstructuredGrid> nameless;
  nameless->ShallowCopy(this->Mesh);
  nameless->GetCellData()->RemoveArray("Side");
  this->Refuse(nameless, "b.inp", "no cell array Side");
  vtkNew<vtkUnstructuredGrid> infinite;
  infinite->DeepCopy(this->Mesh);
  infinite->GetPoints()->SetPoint(0, 0.0, std::nan(""), 0.0);
  this->Refuse(infinite, "b.inp", "finite");
  fs::create_directory(this->Folder / "folder.msh");
  this->Refuse(this->Mesh, "folder.msh", "cannot be written");
  EXPECT_EQ(this->Files(), 2U);
  std::ifstream file(this->File("a.msh"), std::ios::binary);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), before);
}

TEST_F(QuadMeshWriter, NamesOfEveryEdge)
{
  auto* sides = vtkStringArray::SafeDownCast(this->Mesh->GetCellData()->GetAbstractArray("Side"));
  int lines = 0;
  for (vtkIdType cell = 0; cell < this->Mesh->GetNumberOfCells(); ++cell)
  {
    if (this->Mesh->GetCellType(cell) == VTK_LINE)
    {
      sides->SetValue(cell, "été \"" + std::to_string(++lines));
    }
  }
  const std::string text = this->Write(this->Mesh, "a.msh");
  EXPECT_EQ(CountOf(text, "\"été '"), lines);
  const std::string inp = this->Write(this->Mesh, "a.inp");
  EXPECT_EQ(CountOf(inp, "*SURFACE, NAME=side__t"), lines);
}
