// Several materials in vtkQuadMesher: read from a cell array, and written to quads, blocks and boundary edges.

#include "support/FilterChecks.h"
#include "vtkBoundarySimplifier.h"
#include "vtkPoincareHopfCheck.h"
#include "vtkQuadMesher.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

namespace
{
/** Returns two squares side by side in the plane z = y, with materials 7 and 3 in an array. */
vtkSmartPointer<vtkPolyData> TwoSquares(const char* array)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int i = 0; i < 6; ++i)
  {
    points->InsertNextPoint(i % 3, i / 3, i / 3);
  }
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell({ 0, 1, 4, 3 });
  cells->InsertNextCell({ 1, 2, 5, 4 });
  vtkNew<vtkIntArray> materials;
  materials->SetName(array);
  materials->InsertNextValue(7);
  materials->InsertNextValue(3);
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  data->GetCellData()->AddArray(materials);
  return data;
}

TEST(QuadMesherRegions, AreOneMesh)
{
  const auto domain = TwoSquares("Material");
  vtkNew<vtkPolyData> before;
  before->DeepCopy(domain);
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(domain);
  mesher->SetQuadCount(200);
  mesher->Update();
  ASSERT_EQ(mesher->GetErrorCode(), 0U);
  vtkUnstructuredGrid* quads = mesher->GetOutput();
  vtkDataArray* region = quads->GetCellData()->GetArray("Region");
  ASSERT_NE(region, nullptr);
  std::map<double, int> counts;
  for (vtkIdType quad = 0; quad < quads->GetNumberOfCells(); ++quad)
  {
    double centre = 0.0;
    for (int corner = 0; corner < 4; ++corner)
    {
      centre += 0.25 * quads->GetPoint(quads->GetCell(quad)->GetPointId(corner))[0];
    }
    EXPECT_EQ(region->GetTuple1(quad), centre < 1.0 ? 7.0 : 3.0);
    ++counts[region->GetTuple1(quad)];
  }
  EXPECT_EQ(counts[3.0], counts[7.0]);
  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5));
  vtkCellData* edges = boundary->GetCellData();
  int inner = 0;
  for (vtkIdType edge = 0; edge < boundary->GetNumberOfCells(); ++edge)
  {
    const bool isInner = edges->GetArray("BoundaryKind")->GetTuple1(edge) == 5.0;
    inner += isInner ? 1 : 0;
    EXPECT_EQ(edges->GetArray("RegionRight")->GetTuple1(edge) == -1.0, !isInner);
    EXPECT_EQ(
      vtkStringArray::SafeDownCast(edges->GetAbstractArray("Side"))->GetValue(edge) == "3+7",
      isInner);
  }
  EXPECT_GE(inner, 8);
  EXPECT_LE(inner, 16);
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(mesher->GetOutputDataObject(1));
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 2U);
  std::set<double> ofBlocks;
  for (unsigned int block = 0; block < 2; ++block)
  {
    ofBlocks.insert(vtkStructuredGrid::SafeDownCast(blocks->GetBlock(block))
                      ->GetCellData()
                      ->GetArray("Region")
                      ->GetTuple1(0));
  }
  EXPECT_EQ(ofBlocks, (std::set<double>{ 3.0, 7.0 }));
  vtkFieldData* report = mesher->GetOutputDataObject(8)->GetFieldData();
  auto* names = vtkStringArray::SafeDownCast(report->GetAbstractArray("RegionMaterial"));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(0), "3");
  EXPECT_EQ(report->GetArray("RegionQuads")->GetTuple1(1), counts[7.0]);
  EXPECT_EQ(domain->GetNumberOfCells(), before->GetNumberOfCells());
  EXPECT_EQ(domain->GetCellData()->GetNumberOfArrays(), 1);
  EXPECT_EQ(domain->GetPoint(5)[2], before->GetPoint(5)[2]);
}

TEST(QuadMesherRegions, AreThoseOfTheLastUpdate)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(TwoSquares("Grain"));
  mesher->SetQuadCount(200);
  mesher->Update();
  EXPECT_FALSE(mesher->GetOutput()->GetCellData()->HasArray("Region"));
  mesher->SetMaterialArray("Grain");
  mesher->Update();
  EXPECT_TRUE(mesher->GetOutput()->GetCellData()->HasArray("Region"));
  mesher->SetInputData(TwoSquares("Material"));
  mesher->SetMaterialArray("none");
  mesher->Update();
  EXPECT_EQ(mesher->GetErrorCode(), 0U);
  EXPECT_FALSE(mesher->GetOutput()->GetCellData()->HasArray("Region"));
  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5));
  EXPECT_FALSE(boundary->GetCellData()->HasArray("RegionLeft"));
}

TEST(QuadMesherRegions, PassTheSimplificationOfTheBoundary)
{
  vtkNew<vtkBoundarySimplifier> simplifier;
  simplifier->SetInputData(TwoSquares("Material"));
  simplifier->Update();
  auto* output = vtkPolyData::SafeDownCast(simplifier->GetOutputDataObject(0));
  EXPECT_EQ(output->GetNumberOfPolys(), 2);
  EXPECT_TRUE(output->GetCellData()->HasArray("Material"));
}

TEST(QuadMesherRegions, NeedAnArrayOfMaterials)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(TwoSquares("Material"));
  mesher->SetMaterialArray("Grain");
  EXPECT_NE(
    FilterChecks::CaptureError(mesher, { "no cell array 'Grain'", "give the name of one" }), 0U);
}

TEST(PoincareHopfCheckRegions, CountsEachRegion)
{
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputData(TwoSquares("Material"));
  check->Update();
  ASSERT_EQ(check->GetErrorCode(), 0U);
  vtkFieldData* data = check->GetOutput()->GetFieldData();
  EXPECT_EQ(data->GetArray("Consistent")->GetTuple1(0), 1.0);
  auto* materials = vtkStringArray::SafeDownCast(data->GetAbstractArray("RegionMaterial"));
  ASSERT_NE(materials, nullptr);
  ASSERT_EQ(materials->GetNumberOfValues(), 2);
  EXPECT_EQ(materials->GetValue(0), "3");
  for (const char* name : { "RegionRequiredInteriorQuarters", "RegionGivenInteriorQuarters" })
  {
    EXPECT_EQ(data->GetArray(name)->GetTuple1(0), 0.0);
    EXPECT_EQ(data->GetArray(name)->GetTuple1(1), 0.0);
  }
  check->SetInputData(TwoSquares("Grain"));
  check->SetMaterialArray("Grain");
  check->Update();
  EXPECT_NE(check->GetOutput()->GetFieldData()->GetAbstractArray("RegionMaterial"), nullptr);
  check->SetMaterialArray("none");
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetAbstractArray("RegionMaterial"), nullptr);
  check->SetMaterialArray("Alloy");
  EXPECT_NE(FilterChecks::CaptureError(check, { "no cell array 'Alloy'" }), 0U);
}
}
