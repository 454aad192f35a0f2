#include "support/FilterChecks.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkDrawingReader.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <string>
#include <unistd.h>

namespace
{
namespace names = vtkCrossFieldArrayNames;

/** Returns a .dxf of a stadium, 4 by 2 with a semicircle at its right end, with a gap of a width. */
std::string Stadium(double gap = 0.0)
{
  return "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n"
         "0\nLINE\n8\nwall\n10\n0\n20\n0\n11\n4\n21\n0\n"
         "0\nARC\n8\nend\n10\n4\n20\n1\n40\n1\n50\n270\n51\n90\n"
         "0\nLINE\n8\nwall\n10\n4\n20\n2\n11\n0\n21\n2\n"
         "0\nLINE\n8\n0\n10\n0\n20\n2\n11\n0\n21\n" +
    std::to_string(gap) + "\n0\nENDSEC\n0\nEOF\n";
}

class DrawingReader : public testing::Test
{
public:
  ~DrawingReader() override { std::remove(this->File.c_str()); }

  void Set(const std::string& text, const std::string& ending = ".dxf")
  {
    std::remove(this->File.c_str());
    this->File = testing::TempDir() + "drawing" + std::to_string(getpid()) + ending;
    std::ofstream(this->File, std::ios::binary) << text;
    this->Reader->SetFileName(this->File);
    this->Reader->Modified();
  }

  vtkPolyData* Read(const std::string& text, const std::string& ending = ".dxf")
  {
    this->Set(text, ending);
    FilterChecks::UpdateWithoutError(this->Reader);
    return this->Reader->GetOutput();
  }

  std::string File;
  vtkNew<vtkDrawingReader> Reader;
};

TEST_F(DrawingReader, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Reader, [this] { this->Set(Stadium()); },
    [this] { this->Set("<svg xmlns='http://www.w3.org/2000/svg'><circle r='1'/></svg>", ".svg"); });
  FilterChecks::CheckProgressAndAbort(this->Reader, false);
  FilterChecks::CheckPrintSelf(this->Reader, { "FileName", "JoinTolerance", "SamplingAngle" });
}

TEST_F(DrawingReader, LinesHaveNamesAndCurves)
{
  vtkPolyData* output = this->Read(Stadium());
  auto* side = vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray(names::Side));
  vtkDataArray* curve = FilterChecks::RequireArray(output->GetCellData(), names::Curve);
  ASSERT_NE(side, nullptr);
  ASSERT_EQ(side->GetNumberOfValues(), output->GetNumberOfLines());
  std::map<std::string, int> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < output->GetNumberOfLines(); ++cell)
  {
    const std::string name = side->GetValue(cell);
    ++lines[name];
    output->GetLines()->GetCellAtId(cell, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), 2);
    double place[3];
    output->GetPoint(ids->GetId(0), place);
    EXPECT_EQ(curve->GetTuple1(cell), name == "end" ? 1.0 : 0.0);
    if (name == "end")
    {
      EXPECT_NEAR(std::hypot(place[0] - 4.0, place[1] - 1.0), 1.0, 1e-15);
    }
  }
  EXPECT_EQ(lines["wall"], 2);
  EXPECT_EQ(lines[""], 1);
  EXPECT_GE(lines["end"], 36); // 5° each
  auto* kinds =
    vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray(names::CurveKind));
  ASSERT_NE(kinds, nullptr);
  EXPECT_EQ(kinds->GetValue(0), "line");
  EXPECT_EQ(kinds->GetValue(1), "circle");
  vtkDataArray* offsets = FilterChecks::RequireArray(output->GetFieldData(), names::CurveOffset);
  vtkDataArray* values = FilterChecks::RequireArray(output->GetFieldData(), names::CurveValues);
  EXPECT_EQ(offsets->GetTuple1(1), 0.0);
  EXPECT_EQ(offsets->GetTuple1(2), 4.0);
  EXPECT_EQ(values->GetTuple1(0), 4.0);
  EXPECT_EQ(values->GetTuple1(1), 1.0);
  EXPECT_EQ(std::hypot(values->GetTuple1(2), values->GetTuple1(3)), 1.0);
}

TEST_F(DrawingReader, NurbsValuesHaveKnotsAndWeights)
{
  vtkPolyData* output = this->Read(
    "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0C0 1 1 2 2 2L2 0Z'/></svg>", ".svg");
  vtkDataArray* values = FilterChecks::RequireArray(output->GetFieldData(), names::CurveValues);
  const double expected[] = { 3, 4, 0, 0, 0, 0, 1, 1, 1, 1, 0, 0, 1, 0, -1, 1, 1, -2, 1, 2, -2, 1 };
  ASSERT_EQ(values->GetNumberOfTuples(), 22);
  for (vtkIdType i = 0; i < 22; ++i)
  {
    EXPECT_EQ(values->GetTuple1(i), expected[i]) << i;
  }
}

TEST_F(DrawingReader, ReportsUnitAndGap)
{
  this->Set(Stadium(1e-5));
  const FilterChecks::MessageRecorder messages(this->Reader);
  this->Reader->Update();
  EXPECT_EQ(messages.warnings.size(), 1U);
  vtkPolyData* output = this->Reader->GetOutput();
  auto* unit =
    vtkStringArray::SafeDownCast(output->GetFieldData()->GetAbstractArray(names::DrawingUnit));
  ASSERT_NE(unit, nullptr);
  EXPECT_EQ(unit->GetValue(0), "mm");
  EXPECT_DOUBLE_EQ(
    FilterChecks::RequireArray(output->GetFieldData(), names::LargestGap)->GetTuple1(0), 1e-5);
}

TEST_F(DrawingReader, JoinToleranceClosesGaps)
{
  this->Set(Stadium(0.01));
  EXPECT_EQ(FilterChecks::CaptureError(this->Reader, { "is open at", "join tolerance to 0.011" }),
    vtkErrorCode::UserError);
  this->Reader->SetJoinTolerance(0.011);
  const FilterChecks::MessageRecorder messages(this->Reader);
  this->Reader->Update();
  EXPECT_TRUE(messages.errors.empty());
  ASSERT_EQ(messages.warnings.size(), 1U);
  EXPECT_NE(messages.warnings[0].find("was 0.01 wide"), std::string::npos) << messages.warnings[0];
  EXPECT_GT(this->Reader->GetOutput()->GetNumberOfLines(), 0);
}

TEST_F(DrawingReader, SamplingAngleLimitsTheTurn)
{
  this->Reader->SetSamplingAngle(1.0);
  const vtkIdType fine = this->Read(Stadium())->GetNumberOfLines();
  EXPECT_EQ(fine, 180 + 3);
  this->Reader->SetSamplingAngle(100.0);
  EXPECT_EQ(this->Reader->GetSamplingAngle(), 30.0);
}

TEST_F(DrawingReader, RecognisesFiles)
{
  for (const char* ending : { ".dxf", ".svg", ".geojson", ".msh", ".STEP", ".stp", ".brep" })
  {
    this->Set("x", ending);
    EXPECT_EQ(vtkDrawingReader::CanReadFile(this->File.c_str()), 1) << ending;
  }
  this->Set("square\n0 0\n1 0\n1 1\n", ".dat");
  EXPECT_EQ(vtkDrawingReader::CanReadFile(this->File.c_str()), 0);
  this->Set("x", ".vtp");
  EXPECT_EQ(vtkDrawingReader::CanReadFile(this->File.c_str()), 0);
  EXPECT_EQ(vtkDrawingReader::CanReadFile("/no/such/file.dxf"), 0);
}

TEST_F(DrawingReader, KeepsLinesInsideApartFromTheBoundary)
{
  const std::string text = Stadium();
  const std::string crack = "0\nLINE\n8\ncrack\n10\n0\n20\n1\n11\n2\n21\n1\n";
  this->Reader->SetLines("crack; other");
  vtkPolyData* const output = this->Read(std::string(text).insert(text.find("0\nLINE"), crack));
  auto* sides = vtkStringArray::SafeDownCast(output->GetCellData()->GetAbstractArray(names::Side));
  ASSERT_EQ(sides->GetNumberOfValues(), output->GetNumberOfLines());
  EXPECT_EQ(sides->GetValue(output->GetNumberOfLines() - 1), "crack");
  double place[3];
  output->GetPoint(output->GetNumberOfPoints() - 1, place);
  EXPECT_EQ(place[1], 1.0);
}

TEST_F(DrawingReader, RefusesMissingAndUnknownFiles)
{
  this->Reader->SetFileName("/no/such/file.dxf");
  EXPECT_EQ(FilterChecks::CaptureError(this->Reader, { "no file '/no/such/file.dxf'" }),
    vtkErrorCode::UserError);
  this->Set("x", ".xyz");
  EXPECT_EQ(
    FilterChecks::CaptureError(this->Reader, { "unknown ending" }), vtkErrorCode::UserError);
  if (!vtkDrawingReader::CanReadCad())
  {
    this->Set("x", ".step");
    EXPECT_EQ(FilterChecks::CaptureError(this->Reader, { "without Open CASCADE" }),
      vtkErrorCode::UserError);
  }
}
}
