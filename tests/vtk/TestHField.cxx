#include "support/DiskTest.h"
#include "support/FieldReading.h"
#include "support/FilterChecks.h"
#include "support/PerforatedCrossFieldTest.h"
#include "support/ResultFiles.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldErrorCodes.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkCrossGlyphs.h"
#include "vtkHField.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <cmath>

namespace
{
using HField = DiskTest<vtkHField>;
}

TEST_F(HField, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Domain->SetDomainName("disk"); },
    [this]
    {
      this->Domain->SetDomainName("ellipse");
      this->Domain->SetWidth(2.4);
      this->Domain->SetHeight(1.8);
    });
  this->Domain->SetDomainName("disk");
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter, { "MeshSize", "Arrays", "StageSeconds" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(HField, WritesDocumentedArrays)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* output = this->Filter->GetOutput();
  vtkPointData* points = output->GetPointData();
  const vtkIdType pointCount = output->GetNumberOfPoints();
  const vtkIdType cellCount = output->GetNumberOfCells();
  ExpectArray(points, "H", VTK_DOUBLE, 1, pointCount);
  ExpectArray(points, "SizeMap", VTK_FLOAT, 1, pointCount);
  ExpectArray(output->GetCellData(), "CrossFieldCR", VTK_DOUBLE, 6, cellCount);
  for (const char* name : { "Representation", "Cross", "Cross2" })
  {
    ExpectArray(output->GetCellData(), name, VTK_FLOAT, 3, cellCount);
    ExpectArray(points, name, VTK_FLOAT, 3, pointCount);
  }
  for (const char* name : { "BoundaryKind", "BoundaryId", "QuarterIndex" })
  {
    ExpectArray(output->GetCellData(), name, VTK_INT, 1, cellCount);
  }
  for (vtkIdType i = 0; i < pointCount; ++i)
  {
    EXPECT_EQ(points->GetArray("SizeMap")->GetTuple1(i),
      static_cast<double>(static_cast<float>(std::exp(points->GetArray("H")->GetTuple1(i)))));
  }
  for (const char* name : { "Energy", "RenormalizedEnergy", "Residual" })
  {
    ExpectArray(output->GetFieldData(), name, VTK_DOUBLE, 1, 1);
  }
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
  ExpectArray(output->GetFieldData(), "HolonomyDefect", VTK_DOUBLE, 1, 0);
}

TEST_F(HField, SizeMapIsLargeWhereLinesDiverge)
{
  // On a ring with radial crosses the edge length of quads is proportional to the radius.
  this->Domain->SetDomainName("ring");
  this->Filter->SetSingularitiesConnection(nullptr);
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* output = this->Filter->GetOutput();
  vtkDataArray* sizes = output->GetPointData()->GetArray("SizeMap");
  double least = VTK_DOUBLE_MAX;
  double most = 0.0;
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    const double* point = output->GetPoint(i);
    const double ratio = sizes->GetTuple1(i) / std::hypot(point[0], point[1]);
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  EXPECT_LT(most / least, 1.02);
  EXPECT_EQ(output->GetFieldData()->GetArray("HolonomyDefect")->GetNumberOfTuples(), 1);
}

TEST_F(HField, OtherFiltersReadItsField)
{
  vtkNew<vtkCrossGlyphs> glyphs;
  glyphs->SetInputConnection(this->Filter->GetOutputPort());
  FilterChecks::UpdateWithoutError(glyphs);
  vtkNew<vtkCrossFieldSingularities> reader;
  reader->SetInputConnection(this->Filter->GetOutputPort());
  FilterChecks::UpdateWithoutError(reader);
  vtkPolyData* found = vtkPolyData::SafeDownCast(reader->GetOutputDataObject(0));
  ASSERT_EQ(found->GetNumberOfPoints(), 4);
  for (vtkIdType i = 0; i < 4; ++i)
  {
    const double* point = found->GetPoint(i);
    EXPECT_NEAR(std::hypot(point[0], point[1]), 0.6, 0.03);
    EXPECT_EQ(found->GetPointData()->GetArray("QuarterIndex")->GetTuple1(i), 1.0);
  }
}

TEST_F(HField, EqualsTheUnitNormFieldOnADrilledMesh)
{
  const auto mesh = TestInputs::DrilledDisk();
  vtkNew<vtkPerforatedCrossField> unit;
  unit->SetInputData(mesh);
  unit->SetMethodToUnitNorm();
  FilterChecks::UpdateWithoutError(unit);
  this->Filter->SetInputData(mesh);
  FilterChecks::UpdateWithoutError(this->Filter); // the configuration of the holes is optional
  vtkDataArray* expected = unit->GetOutput()->GetCellData()->GetArray("CrossFieldCR");
  vtkDataArray* found = this->Filter->GetOutput()->GetCellData()->GetArray("CrossFieldCR");
  ASSERT_EQ(found->GetNumberOfTuples(), expected->GetNumberOfTuples());
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < 6; ++c)
    {
      EXPECT_NEAR(found->GetComponent(i, c), expected->GetComponent(i, c), 1e-9);
    }
  }
  EXPECT_EQ(this->Filter->GetOutput()->GetFieldData()->GetArray("RenormalizedEnergy"), nullptr);
}

TEST_F(HField, AcceptsSingularitiesOnTheBoundary)
{
  // A corner of the square has index 0 instead of 1 and a point of a side −1, so two more are
  // needed inside.
  this->Domain->SetDomainName("square");
  this->Filter->SetMeshSize(0.05);
  this->Filter->SetSingularitiesData(TestInputs::Singularities({ { 0.0, 0.0, 0.0, 0.1 },
    { 0.25, 0.0, -1.0, 0.1 }, { 0.7, 0.6, 1.0, 0.1 }, { 0.5, 0.25, 1.0, 0.1 } }));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
  EXPECT_EQ(this->Value("GivenInteriorQuarters"), 2.0);
  // The same indices, prescribed as corners on port 2.
  const double energy = this->Value("RenormalizedEnergy");
  this->Filter->SetSingularitiesData(TestInputs::Singularities(
    { { 0.25, 0.0, -1.0, 0.1 }, { 0.7, 0.6, 1.0, 0.1 }, { 0.5, 0.25, 1.0, 0.1 } }));
  this->Filter->SetCornersData(TestInputs::Singularities({ { 0.0, 0.0, 0.0, 0.1 } }));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_NEAR(this->Value("RenormalizedEnergy"), energy, 0.05);
}

TEST_F(HField, WarnsThatHIsMultivalued)
{
  this->Domain->SetDomainName("ring");
  this->Filter->SetSingularitiesData(
    TestInputs::Singularities({ { 0.75, 0.05, 1.0, 0.1 }, { -0.1, 0.65, -1.0, 0.1 } }));
  FilterChecks::MessageRecorder messages(this->Filter);
  this->Filter->Update();
  ResultFiles::Save(this->Filter);
  EXPECT_TRUE(messages.errors.empty());
  ASSERT_EQ(messages.warnings.size(), 1u);
  EXPECT_NE(messages.warnings[0].find("not single-valued: at inner loop 1"), std::string::npos);
}

TEST_F(HField, RejectsInvalidInput)
{
  const auto expectError =
    [this](const std::vector<TestInputs::Row>& rows, const std::vector<std::string>& parts)
  {
    this->Filter->SetSingularitiesData(TestInputs::Singularities(rows));
    return FilterChecks::CaptureError(this->Filter, parts);
  };
  EXPECT_EQ(expectError({ { 0.0, 0.0, 3.0, 0.1 } }, { "add up to 3", "requires 4" }),
    vtkCrossFieldErrorCodes::Inconsistent);
  EXPECT_EQ(expectError({ { 2.0, 0.0, 4.0, 0.1 } }, { "(2, 0)", "outside the domain" }),
    vtkErrorCode::UserError);
  this->Filter->SetInputData(TestInputs::DrilledDisk());
  EXPECT_EQ(expectError({ { 0.0, 0.0, 4.0, 0.1 } }, { "has holes", "quarter index 4" }),
    vtkErrorCode::UserError);
  vtkNew<vtkPolyData> bare;
  bare->ShallowCopy(TestInputs::Singularities({ { 0.1, 0.0, 4.0, 0.1 } }));
  bare->GetPointData()->RemoveArray("QuarterIndex");
  this->Filter->SetSingularitiesData(bare);
  EXPECT_EQ(FilterChecks::CaptureError(this->Filter, { "no point array 'QuarterIndex'" }),
    vtkErrorCode::UserError);
}
