// Surfaces in space in vtkQuadMesher, vtkCrossFieldMap, vtkSeparatrices and vtkPoincareHopfCheck.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkBoundarySimplifier.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkCrossFieldMap.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkHField.h"
#include "vtkPoincareHopfCheck.h"
#include "vtkQuadMesher.h"
#include "vtkQuadsToHigherOrder.h"
#include "vtkSeparatrices.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCleanPolyData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStripper.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace
{
using FilterChecks::CaptureError;
using FilterChecks::CheckInputUntouched;
using FilterChecks::CheckProgressAndAbort;
using FilterChecks::CheckRunTwice;
using FilterChecks::RequireArray;
using FilterChecks::UpdateWithoutError;
using TestInputs::BlownUpCube;

/** Returns singularities of index 1 at the first corners of a cube. */
vtkSmartPointer<vtkPolyData> CubeCorners(int count = 8)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkIntArray> quarters;
  quarters->SetName("QuarterIndex");
  for (int i = 0; i < count; ++i)
  {
    const double at = std::sqrt(1.0 / 3.0);
    points->InsertNextPoint(
      i % 2 == 0 ? -at : at, i / 2 % 2 == 0 ? -at : at, i / 4 == 0 ? -at : at);
    quarters->InsertNextValue(1);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->GetPointData()->AddArray(quarters);
  return data;
}

/** Returns a mesher that made about this number of quads of the sphere. */
vtkSmartPointer<vtkQuadMesher> MesherOfSphere(int count)
{
  auto mesher = vtkSmartPointer<vtkQuadMesher>::New();
  mesher->SetInputData(BlownUpCube());
  mesher->SetSingularitiesData(CubeCorners());
  mesher->SetQuadCount(count);
  UpdateWithoutError(mesher);
  return mesher;
}

TEST(QuadMesherSurfaces, HaveTheGivenIrregularNodes)
{
  const auto sphere = BlownUpCube();
  vtkNew<vtkPolyData> before;
  before->DeepCopy(sphere);
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(sphere);
  mesher->SetSingularitiesData(CubeCorners());
  mesher->SetQuadCount(600);
  mesher->Update();
  ASSERT_EQ(mesher->GetErrorCode(), 0U);
  vtkUnstructuredGrid* quads = mesher->GetOutput();
  EXPECT_EQ(quads->GetNumberOfCells(), 600);
  for (vtkIdType p = 0; p < quads->GetNumberOfPoints(); ++p)
  {
    const double* place = quads->GetPoint(p);
    EXPECT_NEAR(std::hypot(place[0], place[1], place[2]), 1.0, 0.03);
  }
  auto* nodes = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(6));
  auto* used = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(3));
  ASSERT_EQ(nodes->GetNumberOfPoints(), 8);
  ASSERT_EQ(used->GetNumberOfPoints(), 8);
  EXPECT_EQ(used->GetPointData()->GetArray("QuarterIndex")->GetTuple1(7), 1.0);
  EXPECT_NEAR(std::abs(nodes->GetPoint(0)[2]), std::sqrt(1.0 / 3.0), 1e-7);
  EXPECT_EQ(
    vtkMultiBlockDataSet::SafeDownCast(mesher->GetOutputDataObject(1))->GetNumberOfBlocks(), 6U);
  EXPECT_EQ(mesher->GetOutputDataObject(5)->GetNumberOfElements(vtkDataObject::CELL), 0);
  vtkFieldData* report = mesher->GetOutputDataObject(8)->GetFieldData();
  EXPECT_EQ(report->GetArray("Inverted")->GetTuple1(0), 0.0);
  EXPECT_GT(report->GetArray("ScaledJacobianRange")->GetTuple(0)[0], 0.8);
  EXPECT_EQ(sphere->GetNumberOfPoints(), before->GetNumberOfPoints());
  EXPECT_EQ(sphere->GetPoint(5)[2], before->GetPoint(5)[2]);

  // Another surface afterwards: a plane.
  vtkNew<vtkPoints> corners;
  for (int i = 0; i < 4; ++i)
  {
    corners->InsertNextPoint(i % 2, i / 2, 0.0);
  }
  vtkNew<vtkCellArray> cell;
  cell->InsertNextCell({ 0, 1, 3, 2 });
  vtkNew<vtkPolyData> square;
  square->SetPoints(corners);
  square->SetPolys(cell);
  mesher->SetInputData(square);
  mesher->SetSingularitiesData(nullptr);
  mesher->SetQuadCount(100);
  mesher->Update();
  EXPECT_EQ(mesher->GetErrorCode(), 0U);
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 100);
}

TEST(QuadMesherSurfaces, MayBeStrips)
{
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputData(BlownUpCube());
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkBoundarySimplifier> simplifier; // leaves surfaces as they are
  simplifier->SetInputConnection(stripper->GetOutputPort());
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputConnection(simplifier->GetOutputPort());
  mesher->SetSingularitiesData(CubeCorners());
  mesher->SetQuadCount(600);
  mesher->Update();
  EXPECT_EQ(mesher->GetErrorCode(), 0U);
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 600);
}

TEST(QuadMesherSurfaces, ReportHowTheyFitTheSurface)
{
  const auto mesher = MesherOfSphere(600);
  vtkFieldData* report = mesher->GetOutputDataObject(8)->GetFieldData();
  vtkDataArray* distance = RequireArray(report, "SurfaceDistance");
  // Of the centre of a square with sides h, h² / 4; triangles are below the sphere as well.
  EXPECT_GT(distance->GetComponent(0, 1), distance->GetComponent(0, 0));
  EXPECT_NEAR(distance->GetComponent(0, 0), 3.14159 / 600.0, 0.004);
  EXPECT_NEAR(RequireArray(report, "ScaledJacobianBySurface")->GetComponent(0, 0),
    RequireArray(report, "ScaledJacobianRange")->GetComponent(0, 0), 0.02);
}

TEST(QuadMesherSurfaces, HaveNodesOfOrderTwoOnTheSurface)
{
  const auto mesher = MesherOfSphere(150);
  vtkNew<vtkQuadsToHigherOrder> raiser;
  raiser->SetInputConnection(mesher->GetOutputPort());
  CaptureError(raiser, { "not planar" });
  raiser->SetSurfaceData(BlownUpCube());
  UpdateWithoutError(raiser);
  vtkUnstructuredGrid* output = raiser->GetOutput();
  EXPECT_EQ(output->GetCellType(0), VTK_BIQUADRATIC_QUAD);
  EXPECT_EQ(output->GetNumberOfPoints(), 152 + 300 + 150);
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const double* place = output->GetPoint(p);
    EXPECT_NEAR(std::hypot(place[0], place[1], place[2]), 1.0, 0.015); // of the triangles
  }
  EXPECT_EQ(RequireArray(output->GetFieldData(), "CurvedInverted")->GetComponent(0, 0), 0.0);
  CheckInputUntouched(raiser);
  CheckRunTwice(
    raiser, [&] { raiser->SetOrder(2); }, [&] { raiser->SetOrder(3); });
}

TEST(QuadMesherSurfaces, HaveNoPlanarOptions)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(BlownUpCube());
  mesher->SetSingularitiesData(CubeCorners());
  mesher->SetLayers("outer0:0.01");
  CaptureError(mesher, { "do not support boundary layers yet", "leave this option out" });
  mesher->SetLayers("");
  mesher->SetMerge(vtkQuadMesher::MergeClean);
  CaptureError(mesher, { "do not support fewer blocks by moving singularities yet" });
  mesher->SetMerge(vtkQuadMesher::MergeNone);
  mesher->SetSingularitiesData(CubeCorners(7));
  EXPECT_EQ(CaptureError(mesher, { "add up to 7", "needs 8" }),
    static_cast<unsigned long>(vtkCrossFieldErrorCodes::Inconsistent));
}

TEST(QuadMesherSurfaces, HaveRequestedSizes)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(BlownUpCube());
  mesher->SetSingularitiesData(CubeCorners());
  mesher->SetQuadCount(0);
  mesher->SetChordError(0.01);
  UpdateWithoutError(mesher);
  const vtkIdType byError = mesher->GetOutput()->GetNumberOfCells(); // √(4 · 0.01) = 0.2: 314 quads
  EXPECT_NEAR(static_cast<double>(byError), 314.0, 80.0);
  CheckInputUntouched(mesher);
  mesher->SetChordError(0.0);
  mesher->SetQuadSize(0.2);
  mesher->AddSizeNear(0.0, 0.0, 1.0, 0.12, 0.6);
  UpdateWithoutError(mesher);
  EXPECT_EQ(mesher->GetErrorCode(), 0U);
  EXPECT_GT(mesher->GetOutput()->GetNumberOfCells(), 350);
  mesher->ClearSizesNear();
  auto sphere = BlownUpCube();
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Length");
  for (vtkIdType p = 0; p < sphere->GetNumberOfPoints(); ++p)
  {
    lengths->InsertNextValue(0.2);
  }
  sphere->GetPointData()->AddArray(lengths);
  mesher->SetInputData(sphere);
  mesher->SetQuadSize(1.0);
  mesher->SetSizingToField();
  CaptureError(mesher, { "No size array is chosen" });
  mesher->SetSizeArray("Length");
  UpdateWithoutError(mesher);
  EXPECT_NEAR(static_cast<double>(mesher->GetOutput()->GetNumberOfCells()), 314.0, 40.0);
  lengths->SetValue(3, -1.0);
  lengths->Modified();
  sphere->Modified();
  CaptureError(mesher, { "The target size at point 3", "not a positive number" });
}

TEST(QuadMesherSurfaces, KeepTheConventionsOfFilters)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(BlownUpCube());
  mesher->SetSingularitiesData(CubeCorners());
  mesher->SetQuadCount(150);
  UpdateWithoutError(mesher);
  CheckInputUntouched(mesher);
  CheckProgressAndAbort(mesher);
  CheckRunTwice(
    mesher, [&] { mesher->SetQuadCount(150); }, [&] { mesher->SetQuadCount(600); });
}

/** Returns the cube with edges of length 2 with the quadrilaterals of that sphere. */
vtkSmartPointer<vtkPolyData> Cube()
{
  auto cube = BlownUpCube();
  for (vtkIdType p = 0; p < cube->GetNumberOfPoints(); ++p)
  {
    double place[3];
    cube->GetPoint(p, place);
    const double largest = std::max({ std::abs(place[0]), std::abs(place[1]), std::abs(place[2]) });
    cube->GetPoints()->SetPoint(p, place[0] / largest, place[1] / largest, place[2] / largest);
  }
  return cube;
}

/** Returns the number of edges on sharp edges in the boundary of a mesher's quads. */
vtkIdType CountFeatures(vtkQuadMesher* mesher)
{
  vtkDataArray* kinds = RequireArray(
    vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5))->GetCellData(), "BoundaryKind");
  vtkIdType count = 0;
  for (vtkIdType line = 0; line < kinds->GetNumberOfTuples(); ++line)
  {
    count += kinds->GetTuple1(line) == 7.0 ? 1 : 0;
  }
  return count;
}

TEST(QuadMesherSurfaces, FollowSharpEdges)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(Cube());
  mesher->SetQuadCount(600);
  UpdateWithoutError(mesher);
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 600);
  EXPECT_EQ(CountFeatures(mesher), 120);
  EXPECT_EQ(
    vtkMultiBlockDataSet::SafeDownCast(mesher->GetOutputDataObject(1))->GetNumberOfBlocks(), 6U);
  EXPECT_EQ(vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(6))->GetNumberOfPoints(), 8);
  CheckInputUntouched(mesher);
  CheckProgressAndAbort(mesher);
  mesher->SetFeatureAngle(180.0);
  UpdateWithoutError(mesher);
  EXPECT_EQ(CountFeatures(mesher), 0);

  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputData(Cube());
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("Consistent")->GetTuple1(0), 1.0);
  check->SetFeatureAngle(180.0);
  check->Update();
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("Consistent")->GetTuple1(0), 0.0);

  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputData(Cube());
  proposal->Update();
  EXPECT_EQ(proposal->GetErrorCode(), 0U);
  EXPECT_EQ(proposal->GetOutput()->GetNumberOfPoints(), 0);
  proposal->SetFeatureAngle(180.0);
  UpdateWithoutError(proposal);
  EXPECT_EQ(proposal->GetOutput()->GetNumberOfPoints(), 8);
}

/**
 * Returns the sphere with a line along the first edge of a cell, called `seam`, and regions 10, 11 and 12 of the
 * sides across each axis.
 */
vtkSmartPointer<vtkPolyData> NamedSphere(vtkIdType from, vtkIdType to)
{
  auto sphere = BlownUpCube();
  vtkNew<vtkIntArray> regions;
  regions->SetName("Region");
  vtkNew<vtkStringArray> sides;
  sides->SetName("Side");
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ from, to });
  regions->InsertNextValue(0);
  sides->InsertNextValue("seam");
  for (vtkIdType cell = 0; cell < sphere->GetNumberOfPolys(); ++cell)
  {
    regions->InsertNextValue(10 + static_cast<int>(cell / (2 * 8 * 8)));
    sides->InsertNextValue("");
  }
  sphere->SetLines(lines);
  sphere->GetCellData()->AddArray(regions);
  sphere->GetCellData()->AddArray(sides);
  return sphere;
}

TEST(QuadMesherSurfaces, KeepRegionsAndNamedLines)
{
  // The first edge of the first cell is on the edge of the cube between regions 10 and 12.
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(NamedSphere(0, 1));
  mesher->SetQuadCount(600);
  UpdateWithoutError(mesher);
  EXPECT_EQ(CountFeatures(mesher), 0);
  vtkUnstructuredGrid* quads = mesher->GetOutput();
  vtkDataArray* region = RequireArray(quads->GetCellData(), "Region");
  for (vtkIdType cell = 0; cell < quads->GetNumberOfCells(); ++cell)
  {
    double centre[3] = { 0.0, 0.0, 0.0 };
    for (const vtkIdType point : { 0, 1, 2, 3 })
    {
      double place[3];
      quads->GetPoint(quads->GetCell(cell)->GetPointId(static_cast<int>(point)), place);
      for (int k = 0; k < 3; ++k)
      {
        centre[k] += std::abs(place[k]);
      }
    }
    EXPECT_EQ(region->GetTuple1(cell),
      10.0 + static_cast<double>(std::max_element(centre, centre + 3) - centre));
  }
  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5));
  vtkDataArray* kinds = RequireArray(boundary->GetCellData(), "BoundaryKind");
  vtkDataArray* left = RequireArray(boundary->GetCellData(), "RegionLeft");
  vtkDataArray* right = RequireArray(boundary->GetCellData(), "RegionRight");
  auto* sides = vtkStringArray::SafeDownCast(boundary->GetCellData()->GetAbstractArray("Side"));
  ASSERT_NE(sides, nullptr);
  std::map<std::string, int> edges;
  for (vtkIdType line = 0; line < boundary->GetNumberOfCells(); ++line)
  {
    EXPECT_EQ(kinds->GetTuple1(line), 5.0);
    EXPECT_LT(left->GetTuple1(line), right->GetTuple1(line));
    ++edges[sides->GetValue(line)];
  }
  EXPECT_EQ(edges.size(), 4U);
  EXPECT_GE(edges["seam"], 1);
  for (const char* name : { "10+11", "10+12", "11+12" })
  {
    EXPECT_GE(edges[name], 36) << name;
  }
  CheckInputUntouched(mesher);
  mesher->SetMaterialArray("none");
  UpdateWithoutError(mesher);
  EXPECT_EQ(mesher->GetOutput()->GetCellData()->GetArray("Region"), nullptr);
  mesher->SetMaterialArray("Side");
  mesher->SetSideNameArray("Names");
  CaptureError(mesher, { "no cell array 'Names'" });
  mesher->SetMaterialArray("Materials");
  CaptureError(mesher, { "no cell array 'Materials'" });
  mesher->SetMaterialArray("");
  mesher->SetSideNameArray("");
  mesher->SetInputData(NamedSphere(0, 40)); // across cells
  CaptureError(mesher, { "The line 'seam' from (", "along no edge of the surface" });
}

TEST(QuadMesherSurfaces, HaveAProposal)
{
  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputData(BlownUpCube());
  UpdateWithoutError(proposal);
  vtkPolyData* chosen = proposal->GetOutput();
  ASSERT_EQ(chosen->GetNumberOfPoints(), 8);
  EXPECT_EQ(RequireArray(chosen->GetPointData(), "QuarterIndex")->GetRange()[0], 1.0);
  CheckInputUntouched(proposal);
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(BlownUpCube());
  mesher->SetSingularitiesConnection(proposal->GetOutputPort());
  mesher->SetQuadCount(600);
  UpdateWithoutError(mesher);
  EXPECT_EQ(vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(6))->GetNumberOfPoints(), 8);
  proposal->SetSingularitiesData(CubeCorners());
  CaptureError(proposal, { "chosen all together", "leave out given singularities" });
}

TEST(QuadMesherSurfaces, HaveMapAndSeparatrices)
{
  vtkNew<vtkCrossFieldMap> map;
  map->SetInputData(BlownUpCube());
  map->SetSingularitiesData(CubeCorners());
  vtkNew<vtkSeparatrices> separatrices;
  separatrices->SetInputConnection(map->GetOutputPort());
  separatrices->Update();
  ASSERT_EQ(map->GetErrorCode(), 0U);
  ASSERT_EQ(separatrices->GetErrorCode(), 0U);
  vtkPolyData* lines = separatrices->GetOutput();
  vtkFieldData* counts = lines->GetFieldData();
  EXPECT_EQ(counts->GetArray("Faces")->GetTuple1(0), 6.0);
  EXPECT_EQ(counts->GetArray("Arcs")->GetTuple1(0), 12.0);
  for (vtkIdType p = 0; p < lines->GetNumberOfPoints(); ++p)
  {
    const double* place = lines->GetPoint(p);
    EXPECT_NEAR(std::hypot(place[0], place[1], place[2]), 1.0, 0.03);
  }
}

TEST(QuadMesherSurfaces, HaveAnHField)
{
  vtkNew<vtkHField> field;
  field->SetInputData(BlownUpCube());
  field->SetSingularitiesData(CubeCorners());
  UpdateWithoutError(field);
  CheckInputUntouched(field);
  vtkUnstructuredGrid* output = field->GetOutput();
  vtkDataArray* h = output->GetPointData()->GetArray("H");
  vtkDataArray* cross = output->GetCellData()->GetArray("Cross");
  vtkDataArray* second = output->GetCellData()->GetArray("Cross2");
  ASSERT_EQ(h->GetNumberOfTuples(), output->GetNumberOfPoints());
  // Largest at the middles of the faces, where no singularity is near.
  for (vtkIdType p = 0; p < output->GetNumberOfPoints(); ++p)
  {
    const double* place = output->GetPoint(p);
    if (std::abs(place[0]) > 0.99)
    {
      EXPECT_NEAR(h->GetTuple1(p), h->GetRange()[1], 0.02);
    }
  }
  for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
  {
    const double* one = cross->GetTuple3(cell);
    const double length = std::hypot(one[0], one[1], one[2]);
    EXPECT_NEAR(length, 1.0, 1e-6);
    const double along[] = { one[0], one[1], one[2] };
    const double* other = second->GetTuple3(cell);
    EXPECT_NEAR(along[0] * other[0] + along[1] * other[1] + along[2] * other[2], 0.0, 1e-6);
    // Near the middle of a face they are along the axes.
    const double* corner = output->GetPoint(output->GetCell(cell)->GetPointId(0));
    if (corner[2] > 0.99)
    {
      EXPECT_NEAR(std::max(std::abs(along[0]), std::abs(along[1])), 1.0, 0.02);
    }
  }
  EXPECT_FALSE(output->GetFieldData()->HasArray("Energy"));
  EXPECT_EQ(output->GetFieldData()->GetArray("UnwantedSingularities")->GetTuple1(0), 0.0);
  // Its singularities are those given.
  vtkNew<vtkCrossFieldSingularities> read;
  read->SetInputConnection(field->GetOutputPort());
  UpdateWithoutError(read);
  vtkPolyData* found = read->GetOutput();
  ASSERT_EQ(found->GetNumberOfPoints(), 8);
  for (vtkIdType i = 0; i < 8; ++i)
  {
    EXPECT_EQ(found->GetPointData()->GetArray("QuarterIndex")->GetTuple1(i), 1.0);
    EXPECT_EQ(found->GetPointData()->GetArray("BoundaryKind")->GetTuple1(i), 0.0);
    EXPECT_NEAR(std::abs(found->GetPoint(i)[0]), std::sqrt(1.0 / 3.0), 1e-6);
  }
  output->GetCellData()->RemoveArray("Cross");
  vtkNew<vtkUnstructuredGrid> without;
  without->ShallowCopy(output);
  read->SetInputData(without);
  CaptureError(read, { "no cell array 'Cross'", "H Field" });
}

TEST(QuadMesherSurfaces, AreChecked)
{
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputData(BlownUpCube());
  check->SetSingularitiesData(CubeCorners());
  check->Update();
  vtkFieldData* data = check->GetOutput()->GetFieldData();
  EXPECT_EQ(data->GetArray("Consistent")->GetTuple1(0), 1.0);
  EXPECT_EQ(data->GetArray("RequiredInteriorQuarters")->GetTuple1(0), 8.0);
  EXPECT_EQ(data->GetArray("EulerCharacteristic")->GetTuple1(0), 2.0);
  EXPECT_NEAR(data->GetArray("TotalCurvature")->GetTuple1(0), 2.0, 1e-10);
  EXPECT_EQ(check->GetOutputDataObject(2)->GetNumberOfElements(vtkDataObject::POINT), 0);
  check->SetSingularitiesData(CubeCorners(3));
  check->Update();
  data = check->GetOutput()->GetFieldData();
  EXPECT_EQ(data->GetArray("Consistent")->GetTuple1(0), 0.0);
  EXPECT_EQ(data->GetArray("GivenInteriorQuarters")->GetTuple1(0), 3.0);
}
}

TEST(QuadMesherSurfaces, MayBeTheOuterSidesOfVolumes)
{
  // The ball as pyramids around its centre.
  const auto sphere = BlownUpCube();
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(sphere);
  clean->SetTolerance(1e-9);
  clean->Update();
  vtkPolyData* outside = clean->GetOutput();
  const vtkIdType count = outside->GetNumberOfPoints();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(0.0, 0.0, 0.0);
  for (vtkIdType p = 0; p < count; ++p)
  {
    points->InsertNextPoint(outside->GetPoint(p));
  }
  vtkNew<vtkUnstructuredGrid> volumes;
  volumes->SetPoints(points);
  for (vtkIdType cell = 0; cell < outside->GetNumberOfCells(); ++cell)
  {
    vtkIdList* of = outside->GetCell(cell)->GetPointIds();
    const vtkIdType pyramid[] = { 1 + of->GetId(0), 1 + of->GetId(1), 1 + of->GetId(2),
      1 + of->GetId(3), 0 };
    volumes->InsertNextCell(VTK_PYRAMID, 5, pyramid);
  }
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(volumes);
  mesher->SetSingularitiesData(CubeCorners());
  mesher->SetQuadCount(600);
  UpdateWithoutError(mesher);
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfCells(), 600);
}
