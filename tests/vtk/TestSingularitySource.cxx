#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkDrillHoles.h"
#include "vtkPlanarDomainSource.h"
#include "vtkPoincareHopfCheck.h"
#include "vtkSingularitySource.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <set>

namespace
{
using Row = std::array<double, 4>;

class SingularitySource : public testing::Test
{
public:
  /** Writes a file that is removed after the test, and sets it as the file of the source. */
  void SetText(const std::string& text)
  {
    this->File = testing::TempDir() + "crossfield-singularities-" +
      testing::UnitTest::GetInstance()->current_test_info()->name() + ".csv";
    std::ofstream stream(this->File, std::ios::binary);
    stream << text;
    stream.close();
    ASSERT_TRUE(stream);
    this->Source->SetFileName(this->File);
    this->Source->Modified(); // an earlier text may have had the same name
  }

  void TearDown() override
  {
    if (!this->File.empty())
    {
      std::remove(this->File.c_str());
    }
  }

  /** Returns the rows of the output, with −1 for a missing radius. */
  std::vector<Row> Rows()
  {
    this->Source->Update();
    EXPECT_EQ(this->Source->GetErrorCode(), vtkErrorCode::NoError);
    vtkPolyData* output = this->Source->GetOutput();
    vtkDataArray* quarters = FilterChecks::RequireArray(output->GetPointData(), "QuarterIndex");
    vtkDataArray* radii = output->GetPointData()->GetArray("Radius");
    EXPECT_EQ(output->GetNumberOfVerts(), output->GetNumberOfPoints());
    EXPECT_EQ(output->GetNumberOfCells(), output->GetNumberOfPoints());
    std::vector<Row> rows;
    for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
    {
      double point[3];
      output->GetPoint(i, point);
      EXPECT_EQ(point[2], 0.0);
      EXPECT_EQ(output->GetCellType(i), VTK_VERTEX);
      rows.push_back({ point[0], point[1], quarters->GetTuple1(i),
        radii != nullptr ? radii->GetTuple1(i) : -1.0 });
    }
    return rows;
  }

  std::string File;
  vtkNew<vtkSingularitySource> Source;
};
}

TEST_F(SingularitySource, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Source, [this] { this->Source->SetSingularity(0, 0.0, 0.0, 1.0, 0.2); },
    [this] { this->Source->SetSingularity(0, 0.5, 0.0, -1.0, 0.2); });
  FilterChecks::CheckProgressAndAbort(this->Source, false);
  FilterChecks::CheckPrintSelf(this->Source, { "FileName", "Singularities" });
}

TEST_F(SingularitySource, DefaultIsTheFirstFigureOfThePaper)
{
  const double d = 0.6 * std::sqrt(0.5);
  const std::vector<Row> rows = this->Rows();
  ASSERT_EQ(rows.size(), 4u);
  double sumX = 0.0;
  double sumY = 0.0;
  for (const auto& [x, y, quarterIndex, radius] : rows)
  {
    EXPECT_NEAR(std::abs(x), d, 1e-15);
    EXPECT_NEAR(std::abs(y), d, 1e-15);
    EXPECT_EQ(quarterIndex, 1.0);
    EXPECT_EQ(radius, 0.1);
    sumX += x;
    sumY += y;
  }
  EXPECT_EQ(sumX, 0.0);
  EXPECT_EQ(sumY, 0.0);
  EXPECT_EQ(std::set<Row>(rows.begin(), rows.end()).size(), 4u) << "one in each quadrant";
}

TEST_F(SingularitySource, RowsAreInThePlaneOfStartOrDomain)
{
  vtkNew<vtkPolyData> start;
  start->DeepCopy(TestInputs::Singularities({ { 0.5, 0.25, 1, 0.1 } }));
  start->GetPoints()->SetPoint(0, 0.5, 0.25, 2.0);
  this->Source->SetStartData(start);
  this->Source->SetSingularity(0, 0.125, 0.0, 1.0, 0.1);
  FilterChecks::UpdateWithoutError(this->Source);
  EXPECT_EQ(this->Source->GetOutput()->GetPoint(0)[2], 2.0);
  EXPECT_EQ(this->Source->GetOutput()->GetPoint(0)[0], 0.125);
  EXPECT_EQ(this->Source->GetOutput()->GetFieldData()->GetArray("Plane"), nullptr)
    << "not needed for z = const";
  EXPECT_EQ(this->Source->GetPlane()->GetComponent(0, 2), 2.0);

  vtkNew<vtkPolyData> domain;
  domain->DeepCopy(TestInputs::Loops({ { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } } }));
  for (vtkIdType i = 0; i < domain->GetNumberOfPoints(); ++i)
  {
    const double* place = domain->GetPoint(i);
    domain->GetPoints()->SetPoint(i, place[0], place[1], 3.0);
  }
  this->Source->SetDomainData(domain);
  FilterChecks::UpdateWithoutError(this->Source);
  EXPECT_EQ(this->Source->GetOutput()->GetPoint(0)[2], 3.0);
  // The points of a file are in space.
  this->SetText("x,y,z,quarter_index\n0.5,0.25,1.5,1\n");
  FilterChecks::UpdateWithoutError(this->Source);
  EXPECT_EQ(this->Source->GetOutput()->GetPoint(0)[2], 1.5);
}

TEST_F(SingularitySource, DefaultRowsFitTheDomain)
{
  vtkNew<vtkPlanarDomainSource> domain;
  this->Source->SetDomainConnection(domain->GetOutputPort());
  for (const char* name : { "disk", "ring", "ellipse", "quarter-disk", "l-shape", "hexagonal",
         "star", "angular-balanced", "angular-negative", "angular-positive", "angular-hole" })
  {
    for (const double scale : { 0.01, 1.0, 300.0 })
    {
      SCOPED_TRACE(std::string(name) + " " + std::to_string(scale));
      domain->SetDomainName(name);
      domain->SetRadius(scale);
      domain->SetInnerRadius(0.4 * scale);
      domain->SetWidth(2.0 * scale);
      domain->SetHeight(scale);
      const std::size_t count = this->Rows().size();
      vtkNew<vtkPoincareHopfCheck> check;
      check->SetInputConnection(domain->GetOutputPort());
      check->SetSingularitiesConnection(this->Source->GetOutputPort());
      FilterChecks::UpdateWithoutError(check);
      vtkFieldData* report = check->GetOutputDataObject(0)->GetFieldData();
      EXPECT_EQ(FilterChecks::RequireArray(report, "Consistent")->GetTuple1(0), 1.0);
      const double required =
        FilterChecks::RequireArray(report, "RequiredInteriorQuarters")->GetTuple1(0);
      EXPECT_EQ(static_cast<double>(count), std::abs(required)) << "all of one sign";
      // Holes that overlap or leave the domain would be refused.
      vtkNew<vtkDrillHoles> drill;
      drill->SetInputConnection(domain->GetOutputPort());
      drill->SetSingularitiesConnection(this->Source->GetOutputPort());
      FilterChecks::UpdateWithoutError(drill);
      EXPECT_GT(drill->GetOutput()->GetNumberOfCells(), 100);
      EXPECT_EQ(this->Source->GetOutputRows()->GetNumberOfTuples(), static_cast<vtkIdType>(count));
    }
  }
}

TEST_F(SingularitySource, FittedRowsAreThoseOfTheUserOnceChanged)
{
  vtkNew<vtkPlanarDomainSource> domain;
  domain->SetDomainName("ellipse");
  this->Source->SetDomainConnection(domain->GetOutputPort());
  const std::vector<Row> defaults = this->Rows();
  EXPECT_EQ(defaults.size(), 4u);
  EXPECT_LT(std::abs(defaults[0][1]), 0.5) << "inside";
  const Row own = { 0.5, 0.25, 1.0, 0.05 };
  this->Source->SetSingularity(0, own[0], own[1], own[2], own[3]);
  EXPECT_EQ(this->Rows()[0], own);
  EXPECT_EQ(this->Rows()[1][3], 0.1) << "the other rows as they are";
  this->Source->RemoveAllSingularities();
  EXPECT_TRUE(this->Rows().empty());
  // ParaView sets the default rows one by one.
  const double d = 0.6 * std::sqrt(0.5);
  this->Source->AddSingularity(d, d, 1.0, 0.1);
  this->Source->AddSingularity(-d, d, 1.0, 0.1);
  this->Source->AddSingularity(-d, -d, 1.0, 0.1);
  this->Source->AddSingularity(d, -d, 1.0, 0.1);
  EXPECT_EQ(this->Rows(), defaults);
  // Start and a file come first.
  this->SetText("x,y,quarter_index,radius\n0.5,-0.25,2,0.3\n");
  EXPECT_EQ(this->Rows().size(), 1u);
  this->Source->SetFileName(nullptr);
  this->Source->SetStartData(TestInputs::Singularities({ { 0.1, 0.2, -1.0, 0.05 } }));
  EXPECT_EQ(this->Rows().size(), 1u);
}

TEST_F(SingularitySource, FittedRowsAreInThePlaneOfTheDomain)
{
  this->Source->SetDomainData(
    TestInputs::Loops({ TestInputs::Circle(40, 2.0, { 5.0, 1.0 }) }, 3.0));
  FilterChecks::UpdateWithoutError(this->Source);
  vtkPolyData* output = this->Source->GetOutput();
  ASSERT_EQ(output->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double* place = output->GetPoint(i);
    EXPECT_EQ(place[2], 3.0);
    EXPECT_LT(std::hypot(place[0] - 5.0, place[1] - 1.0), 2.0);
  }
  this->Source->SetDomainData(TestInputs::OpenCurve({ { 0, 0 }, { 1, 0 }, { 1, 1 } }));
  FilterChecks::CaptureError(this->Source, { "open" });
}

TEST_F(SingularitySource, WritesDocumentedArrays)
{
  this->Source->Update();
  vtkPointData* data = this->Source->GetOutput()->GetPointData();
  ASSERT_EQ(data->GetNumberOfArrays(), 2);
  ASSERT_NE(data->GetArray("QuarterIndex"), nullptr);
  EXPECT_EQ(data->GetArray("QuarterIndex")->GetDataType(), VTK_INT);
  EXPECT_EQ(data->GetArray("QuarterIndex")->GetNumberOfComponents(), 1);
  ASSERT_NE(data->GetArray("Radius"), nullptr);
  EXPECT_EQ(data->GetArray("Radius")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(data->GetArray("Radius")->GetNumberOfComponents(), 1);
}

TEST_F(SingularitySource, RowsAreSetAppendedAndRemoved)
{
  this->Source->RemoveAllSingularities();
  EXPECT_EQ(this->Source->GetNumberOfSingularities(), 0);
  EXPECT_TRUE(this->Rows().empty());
  this->Source->AddSingularity(1.0, 2.0, 3.0, 4.0);
  this->Source->SetSingularity(2, 5.0, 6.0, -7.0, 8.0);
  EXPECT_EQ(this->Source->GetNumberOfSingularities(), 3);
  std::vector<Row> rows = this->Rows();
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_EQ(rows[0], Row({ 1.0, 2.0, 3.0, 4.0 }));
  EXPECT_EQ(rows[2], Row({ 5.0, 6.0, -7.0, 8.0 }));
  this->Source->SetSingularity(0, 9.0, 9.0, 9.0, 9.0);
  this->Source->SetNumberOfSingularities(1);
  rows = this->Rows();
  EXPECT_EQ(rows, std::vector<Row>({ { 9.0, 9.0, 9.0, 9.0 } }));
}

TEST_F(SingularitySource, HandlesReplacePositions)
{
  this->Source->RemoveAllSingularities();
  this->Source->AddSingularity(1.0, 2.0, 3.0, 0.4);
  this->Source->AddSingularity(5.0, 6.0, -7.0, 0.8);
  this->Source->SetNumberOfHandles(1);
  this->Source->SetHandle(0, 0.5, 0.25, 0.0);
  EXPECT_EQ(this->Rows()[0], Row({ 1.0, 2.0, 3.0, 0.4 })) << "handles are off by default";
  this->Source->UseHandlesOn();
  EXPECT_EQ(this->Rows(), std::vector<Row>({ { 0.5, 0.25, 3.0, 0.4 } }));
  this->Source->SetHandle(2, -1.0, -2.0, 0.0);
  EXPECT_EQ(this->Source->GetNumberOfHandles(), 3);
  EXPECT_EQ(this->Rows(),
    std::vector<Row>(
      { { 0.5, 0.25, 3.0, 0.4 }, { 0.0, 0.0, -7.0, 0.8 }, { -1.0, -2.0, 1.0, 0.8 } }));
  this->Source->SetHandle(2, -1.0, -2.0, 3.0);
  this->Source->Update();
  EXPECT_EQ(this->Source->GetOutput()->GetPoint(2)[2], 3.0);
  // The rows themselves do not change.
  this->Source->UseHandlesOff();
  EXPECT_EQ(this->Rows().size(), 2u);
  // Handles also move the rows of a file; without rows they have a default.
  this->Source->UseHandlesOn();
  this->Source->SetNumberOfHandles(1);
  this->SetText("x,y,quarter_index,radius\n0.5,-0.25,2,0.3\n");
  EXPECT_EQ(this->Rows(), std::vector<Row>({ { 0.5, 0.25, 2.0, 0.3 } }));
  this->SetText("x,y,quarter_index,radius\n");
  EXPECT_EQ(this->Rows(), std::vector<Row>({ { 0.5, 0.25, 1.0, 0.1 } }));
}

TEST_F(SingularitySource, DefaultHandlesAreTheDefaultRows)
{
  const std::vector<Row> rows = this->Rows();
  this->Source->UseHandlesOn();
  EXPECT_EQ(this->Rows(), rows);
}

TEST_F(SingularitySource, StartsFromPointsWithoutRows)
{
  const std::vector<Row> start = { { 0.1, 0.2, -1.0, 0.05 }, { 0.3, 0.4, 2.0, 0.06 } };
  this->Source->SetStartData(TestInputs::Singularities({ start[0], start[1] }));
  EXPECT_EQ(this->Rows(), start);
  FilterChecks::CheckInputUntouched(this->Source);
  vtkDoubleArray* values = this->Source->GetOutputRows();
  ASSERT_EQ(values->GetNumberOfTuples(), 2);
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(values->GetComponent(1, static_cast<int>(i)), start[1][i]);
  }
  // Rows that are set replace the points, until they are removed.
  this->Source->SetSingularity(0, 1.0, 2.0, 3.0, 0.4);
  EXPECT_EQ(this->Rows()[0], Row({ 1.0, 2.0, 3.0, 0.4 }));
  this->Source->RemoveAllSingularities();
  EXPECT_EQ(this->Rows(), start);
  // The output of a failed Start has no array and is not an empty configuration.
  this->Source->SetStartData(vtkNew<vtkPolyData>());
  FilterChecks::CaptureError(this->Source, { "no point array 'QuarterIndex'" });
  EXPECT_EQ(this->Source->GetOutputRows()->GetNumberOfTuples(), 0);
}

TEST_F(SingularitySource, OmitsRadiiIfAllAreZero)
{
  this->Source->RemoveAllSingularities();
  this->Source->AddSingularity(0.0, 0.0, 1.0, 0.0);
  EXPECT_EQ(this->Rows(), std::vector<Row>({ { 0.0, 0.0, 1.0, -1.0 } }));
  this->Source->AddSingularity(
    0.5, 0.0, 1.0, 0.1); // one radius is given, so the filters refuse the other
  EXPECT_EQ(this->Rows()[0], Row({ 0.0, 0.0, 1.0, 0.0 }));
}

TEST_F(SingularitySource, ReadsAFile)
{
  this->SetText("x,y,quarter_index,radius\n0.5,-0.25,1,0.1\n1e-3,2,-2,0.05\n");
  const std::vector<Row> expected = { { 0.5, -0.25, 1.0, 0.1 }, { 1e-3, 2.0, -2.0, 0.05 } };
  EXPECT_EQ(this->Rows(), expected);

  // A file with additional columns, another order of columns, blanks and Windows line ends.
  this->SetText("name,radius, quarter_index,y,x\r\na,0.1, 1,-0.25,0.5\r\nb,0.05, -2,2,1e-3\r\n");
  EXPECT_EQ(this->Rows(), expected);

  // Output of ParaView's File, Save Data.
  this->SetText("\"QuarterIndex\",\"Radius\",\"Points:0\",\"Points:1\",\"Points:2\"\n"
                "1,0.1,0.5,-0.25,0\n-2,0.05,1e-3,2,0\n");
  EXPECT_EQ(this->Rows(), expected);

  // The rows are used again.
  this->Source->SetFileName(nullptr);
  EXPECT_EQ(this->Rows().size(), 4u);
}

TEST_F(SingularitySource, AFileWithoutRadiiGivesNoRadius)
{
  this->SetText("x,y,quarter_index\n0.5,-0.25,1\n");
  EXPECT_EQ(this->Rows(), std::vector<Row>({ { 0.5, -0.25, 1.0, -1.0 } }));
  EXPECT_EQ(this->Source->GetOutput()->GetPointData()->GetArray("Radius"), nullptr);
}

TEST_F(SingularitySource, AcceptsAFileWithoutRows)
{
  this->SetText("x,y,quarter_index,radius\n");
  EXPECT_TRUE(this->Rows().empty());
}

TEST_F(SingularitySource, RejectsInvalidFiles)
{
  this->Source->SetFileName("/no/such/folder/four.csv");
  EXPECT_EQ(FilterChecks::CaptureError(this->Source, { "'/no/such/folder/four.csv'" }),
    vtkErrorCode::UserError);
  this->Source->SetFileName(testing::TempDir());
  FilterChecks::CaptureError(this->Source, { "'" + testing::TempDir() + "'" });

  struct Case
  {
    const char* text;
    const char* complaint;
  };
  const Case cases[] = { { "", "no column 'x'" }, { "x,quarter_index\n0,1\n", "no column 'y'" },
    { "x,y\n0,0\n", "no column 'quarter_index'" }, { "0.5,0.5,1,0.1\n", "no column 'x'" },
    { "x,y,quarter_index\n0,zero,1\n", "no number in column 'y'" },
    { "x,y,quarter_index\n0,,1\n", "no number in column 'y'" },
    { "x,y,quarter_index\n0,1.5m,1\n", "no number in column 'y'" },
    { "x,y,quarter_index\n0,0\n", "no number in column 'quarter_index'" },
    { "x,y,quarter_index,radius\n0,0,1\n", "no number in column 'radius'" },
    { "x,y,quarter_index\n0,nan,1\n", "Row 1" }, { "x,y,quarter_index\n0,0,1\n0,inf,1\n", "Row 2" },
    { "x,y,quarter_index,radius\n0,0,1,nan\n", "Row 1" },
    { "x,y,quarter_index\n0,0,0.25\n", "not an integer" },
    { "x,y,quarter_index\n0,0,nan\n", "quarter" } };
  for (const Case& test : cases)
  {
    SCOPED_TRACE(test.text);
    this->SetText(test.text);
    FilterChecks::CaptureError(this->Source, { test.complaint });
  }
  this->SetText("x,y,quarter_index\n0,0,1\n");
  EXPECT_EQ(this->Rows().size(), 1u) << "after the refusals";
}

TEST_F(SingularitySource, RejectsRowsThatAreNotNumbers)
{
  const double notANumber = std::numeric_limits<double>::quiet_NaN();
  this->Source->SetSingularity(3, 0.0, 0.0, 0.5, 0.1);
  FilterChecks::CaptureError(this->Source, { "singularity 4", "not an integer" });
  this->Source->SetSingularity(3, notANumber, 0.0, 1.0, 0.1);
  FilterChecks::CaptureError(this->Source, { "Row 4", "not a finite number" });
  this->Source->SetSingularity(3, 0.0, 0.0, 1.0, notANumber);
  FilterChecks::CaptureError(this->Source, { "Row 4", "not a finite number" });
  FilterChecks::MessageRecorder messages(this->Source);
  this->Source->SetSingularity(-1, 0.0, 0.0, 1.0, 0.1);
  EXPECT_EQ(messages.errors.size(), 1u);
  EXPECT_EQ(this->Source->GetNumberOfSingularities(), 4);
}
