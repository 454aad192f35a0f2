#include "support/DiskTest.h"
#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkCrossFieldMap.h"
#include "vtkSeparatrices.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace
{
class Separatrices : public DiskTest<vtkCrossFieldMap>
{
public:
  void SetUp() override
  {
    DiskTest::SetUp();
    this->Lines->SetInputConnection(this->Filter->GetOutputPort());
  }

  double Value(const char* name)
  {
    return FilterChecks::RequireArray(this->Lines->GetOutput()->GetFieldData(), name)
      ->GetComponent(0, 0);
  }

  static std::array<double, 2> PlaceOf(vtkPolyData* data, vtkIdType point)
  {
    return { data->GetPoint(point)[0], data->GetPoint(point)[1] };
  }

  vtkNew<vtkSeparatrices> Lines; ///< Separatrices of the map.
};
}

TEST_F(Separatrices, FollowsFilterConventions)
{
  FilterChecks::UpdateWithoutError(this->Lines);
  FilterChecks::CheckInputUntouched(this->Lines);
  FilterChecks::CheckProgressAndAbort(this->Lines);
  FilterChecks::CheckPrintSelf(this->Lines, { "LongestStreamline", "StageSeconds" });
  FilterChecks::CheckEmptyInput(this->Lines);
}

TEST_F(Separatrices, DivideTheDiskIntoPatches)
{
  FilterChecks::UpdateWithoutError(this->Lines);
  vtkPolyData* lines = this->Lines->GetOutput();
  vtkPolyData* patches = this->Lines->GetOutput(1);
  EXPECT_EQ(lines->GetNumberOfCells(), 12);
  EXPECT_EQ(this->Value("Lines"), 12.0);
  EXPECT_EQ(this->Value("Faces"), 9.0 - this->Value("HeadOn"));
  vtkDataArray* ids = FilterChecks::RequireArray(patches->GetCellData(), "FaceId");
  EXPECT_EQ(this->Value("Flips"), 0.0);
  EXPECT_LT(this->Value("Mismatch"), 1e-12);
  // docs/method.md §13.4, for the mesh size of this test.
  vtkDataArray* u = FilterChecks::RequireArray(patches->GetCellData(), "USize");
  vtkDataArray* v = FilterChecks::RequireArray(patches->GetCellData(), "VSize");
  double square = 0.0;
  double area = 0.0;
  for (vtkIdType i = 0, last = -1; i < patches->GetNumberOfCells(); ++i)
  {
    const auto patch = static_cast<vtkIdType>(ids->GetTuple1(i));
    if (patch == last)
    {
      continue;
    }
    EXPECT_EQ(patch, last + 1);
    last = patch;
    square = std::max(square, std::min(u->GetTuple1(i), v->GetTuple1(i)));
    area += u->GetTuple1(i) * v->GetTuple1(i);
  }
  EXPECT_EQ(ids->GetRange()[1], this->Value("Faces") - 1.0);
  EXPECT_NEAR(square, 1.094482, 0.01);
  EXPECT_NEAR(area, 3.14, 0.02);
  for (const char* name : { "Line", "Seed", "Singularity", "QuarterIndex", "EndsAt", "Length" })
  {
    EXPECT_EQ(FilterChecks::RequireArray(lines->GetCellData(), name)->GetNumberOfTuples(), 12);
  }
  EXPECT_EQ(FilterChecks::RequireArray(patches->GetPointData(), "NodeKind")->GetNumberOfTuples(),
    patches->GetNumberOfPoints());
}

// The triangles of every patch are positively oriented and have the total area of its outline; all
// patches have the area of the domain. The outlines are rectangles of (u, v).
TEST_F(Separatrices, PatchesAreTriangulated)
{
  for (const char* name : { "disk", "ring", "l-shape", "hexagonal" })
  {
    SCOPED_TRACE(name);
    this->Domain->SetDomainName(name);
    this->Domain->SetEdgeLength(0.05);
    if (std::string(name) == "hexagonal")
    {
      this->Filter->SetSingularitiesData(
        TestInputs::Singularities({ { 0.469, 0.0, -1, 0.1 }, { -0.469, 0.0, -1, 0.1 } }));
    }
    else if (std::string(name) != "disk")
    {
      this->Filter->SetSingularitiesData(nullptr);
    }
    FilterChecks::UpdateWithoutError(this->Lines);
    vtkPolyData* patches = this->Lines->GetOutput(1);
    vtkDataArray* ofCell = FilterChecks::RequireArray(patches->GetCellData(), "FaceId");
    vtkDataArray* ofPoint = FilterChecks::RequireArray(patches->GetPointData(), "FaceId");
    vtkDataArray* uv = FilterChecks::RequireArray(patches->GetPointData(), "UV");
    vtkDataArray* u = FilterChecks::RequireArray(patches->GetCellData(), "USize");
    vtkDataArray* v = FilterChecks::RequireArray(patches->GetCellData(), "VSize");
    const auto count = static_cast<std::size_t>(this->Value("Faces"));
    std::vector<double> filled(count, 0.0);
    std::vector<double> outlined(count, 0.0);
    std::vector<double> rectangle(count, 0.0);
    std::vector<double> expected(count, 0.0);
    for (vtkIdType cell = 0; cell < patches->GetNumberOfCells(); ++cell)
    {
      vtkNew<vtkIdList> ids;
      patches->GetCellPoints(cell, ids);
      ASSERT_EQ(ids->GetNumberOfIds(), 3);
      const std::array<double, 2> a = PlaceOf(patches, ids->GetId(0));
      const std::array<double, 2> b = PlaceOf(patches, ids->GetId(1));
      const std::array<double, 2> c = PlaceOf(patches, ids->GetId(2));
      const double twice = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
      EXPECT_GT(twice, 0.0);
      const auto patch = static_cast<std::size_t>(ofCell->GetTuple1(cell));
      EXPECT_EQ(ofPoint->GetTuple1(ids->GetId(0)), ofCell->GetTuple1(cell));
      filled[patch] += 0.5 * twice;
      expected[patch] = u->GetTuple1(cell) * v->GetTuple1(cell);
    }
    for (vtkIdType i = 0, first = 0; i < patches->GetNumberOfPoints(); ++i)
    {
      const double here = ofPoint->GetTuple1(i);
      first = here == ofPoint->GetTuple1(first) ? first : i;
      const bool last = i + 1 == patches->GetNumberOfPoints() || ofPoint->GetTuple1(i + 1) != here;
      const vtkIdType next = last ? first : i + 1;
      const std::array<double, 2> a = PlaceOf(patches, i);
      const std::array<double, 2> b = PlaceOf(patches, next);
      const auto patch = static_cast<std::size_t>(here);
      outlined[patch] += 0.5 * (a[0] * b[1] - a[1] * b[0]);
      rectangle[patch] += 0.5 *
        (uv->GetComponent(i, 0) * uv->GetComponent(next, 1) -
          uv->GetComponent(i, 1) * uv->GetComponent(next, 0));
    }
    double domain = 0.0;
    double map = 0.0;
    for (std::size_t patch = 0; patch < count; ++patch)
    {
      EXPECT_NEAR(filled[patch], outlined[patch], 1e-12);
      EXPECT_NEAR(rectangle[patch], expected[patch], 1e-12);
      domain += filled[patch];
      map += expected[patch];
    }
    EXPECT_NEAR(domain, map, 1e-9); // the map has the area of the domain
  }
}

TEST_F(Separatrices, StreamlinesFromSeedsEndOnTheBoundary)
{
  this->Lines->SetSeedsData(TestInputs::Singularities({ { 0.1, 0.2, 1, 0.1 } }));
  FilterChecks::UpdateWithoutError(this->Lines);
  vtkPolyData* lines = this->Lines->GetOutput();
  ASSERT_EQ(lines->GetNumberOfCells(), 16);
  vtkDataArray* seed = FilterChecks::RequireArray(lines->GetCellData(), "Seed");
  vtkDataArray* end = FilterChecks::RequireArray(lines->GetCellData(), "EndsAt");
  for (vtkIdType cell = 12; cell < 16; ++cell)
  {
    EXPECT_EQ(seed->GetTuple1(cell), 0.0);
    EXPECT_EQ(end->GetTuple1(cell), 2.0);
    vtkNew<vtkIdList> ids;
    lines->GetCellPoints(cell, ids);
    const double* last = lines->GetPoint(ids->GetId(ids->GetNumberOfIds() - 1));
    EXPECT_NEAR(std::hypot(last[0], last[1]), 1.0, 0.01);
  }
  this->Lines->SetSeedsData(TestInputs::Singularities({ { 3.0, 0.0, 1, 0.1 } }));
  EXPECT_EQ(FilterChecks::CaptureError(this->Lines, { "seed 0", "outside", "move it inside" }),
    vtkCrossFieldErrorCodes::BadInput);
}

TEST_F(Separatrices, RejectInputWithoutMap)
{
  this->Lines->SetInputData(TestInputs::DrilledDisk());
  FilterChecks::CaptureError(this->Lines, { "no array 'UV'", "cross field map" });
}
