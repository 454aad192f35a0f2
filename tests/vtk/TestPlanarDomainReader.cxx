#include "support/FilterChecks.h"
#include "vtkPlanarDomainReader.h"

#include "vtkCellArray.h"
#include "vtkErrorCode.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

namespace
{
using Place = std::array<double, 3>;
using Loop = std::vector<Place>; // without the repeated first point

const Loop Square = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 1, 0 }, { 0, 1, 0 } };
const Loop Triangle = { { 0.5, 0.25, 0 }, { 1, 0.25, 0 }, { 0.75, 0.5, 0 } };
const char* const SquareTable = "x,y\n0,0\n2,0\n2,1\n0,1\n";

class PlanarDomainReader : public testing::Test
{
public:
  void SetText(const std::string& text, const std::string& file = "loop.csv")
  {
    this->Reader->SetFileName(file);
    this->Reader->ReadFromInputStringOn();
    this->Reader->SetInputString(text);
  }

  /** Returns the loops of a text. Expects each to be one closed polyline. */
  std::vector<Loop> Read(const std::string& text, const std::string& file = "loop.csv")
  {
    this->SetText(text, file);
    FilterChecks::UpdateWithoutError(this->Reader);
    vtkPolyData* output = this->Reader->GetOutput();
    EXPECT_EQ(output->GetNumberOfCells(), output->GetNumberOfLines());
    std::vector<Loop> loops;
    vtkNew<vtkIdList> ids;
    for (vtkIdType line = 0; line < output->GetNumberOfLines(); ++line)
    {
      output->GetLines()->GetCellAtId(line, ids);
      EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1)) << "is not closed";
      loops.emplace_back();
      for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
      {
        Place place{};
        output->GetPoint(ids->GetId(i), place.data());
        loops.back().push_back(place);
      }
    }
    return loops;
  }

  void Refuses(const std::string& text, const std::string& file, const std::string& complaint)
  {
    SCOPED_TRACE(text);
    this->SetText(text, file);
    EXPECT_EQ(FilterChecks::CaptureError(this->Reader, { "'" + file + "'", complaint }),
      vtkErrorCode::UserError);
  }

  vtkNew<vtkPlanarDomainReader> Reader;
};
}

TEST_F(PlanarDomainReader, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Reader, [this] { this->SetText(SquareTable); },
    [this] { this->SetText("x,y\n0,0\n1,0\n0,1\n"); });
  FilterChecks::CheckProgressAndAbort(this->Reader, false);
  FilterChecks::CheckPrintSelf(this->Reader, { "FileName", "ReadFromInputString", "InputString" });
}

TEST_F(PlanarDomainReader, AcceptsColumnNamesOfUsersAndParaView)
{
  EXPECT_EQ(this->Read(SquareTable), std::vector<Loop>{ Square });
  for (const char* text : { "X,Y\n0,0\n2,0\n2,1\n0,1\n", " y , x \r\n0,0\r\n0,2\r\n1,2\r\n1,0\r\n",
         "\"Quality\",\"Points:0\",\"Points:1\",\"Points:2\"\n7,0,0,0\n7,2,0,0\n7,2,1,0\n7,0,1,0\n",
         "Points_0,Points_1,Points_2\n0,0,0\n2,0,0\n2,1,0\n0,1,0\n" })
  {
    EXPECT_EQ(this->Read(text), std::vector<Loop>{ Square }) << text;
  }
  EXPECT_EQ(this->Read("z,x,y\n3,0,0\n3,1,0\n4,0,1\n"),
    (std::vector<Loop>{ { { 0, 0, 3 }, { 1, 0, 3 }, { 0, 1, 4 } } }));
}

TEST_F(PlanarDomainReader, LoopColumnSeparatesLoops)
{
  const std::vector<Loop> both = { Square, Triangle };
  EXPECT_EQ(
    this->Read("loop,x,y\n1,0,0\n1,2,0\n1,2,1\n1,0,1\n2,0.5,0.25\n2,1,0.25\n2,0.75,0.5\n"), both);
  EXPECT_EQ(
    this->Read(
      "x,y,Loop\n0,0,outer\n.5,.25,inner\n2,0,outer\n2,1,outer\n1,.25,inner\n0,1,outer\n.75,.5,inner\n"),
    both);
}

TEST_F(PlanarDomainReader, ReadsAerofoilsAndPlainLoops)
{
  const std::string rows = "0 0\n2 0\n 2.0\t1e0\n0 1\n";
  EXPECT_EQ(this->Read("a name of 2 words\n" + rows, "wing.dat"), std::vector<Loop>{ Square });
  EXPECT_EQ(this->Read(rows, "wing.DAT"), std::vector<Loop>{ Square });
  EXPECT_EQ(this->Read("0 0\n\n2 0\n2 1\n0 1\n\n\n\n", "wing.dat"), std::vector<Loop>{ Square });
  const std::vector<Loop> both = { Square, Triangle };
  const std::string inner = "0.5 0.25\n1 0.25\n0.75 0.5\n";
  EXPECT_EQ(this->Read("name\n\n\n" + rows + "\n \r\n" + inner, "wing.dat"), both);
  EXPECT_EQ(this->Read(rows + "999.0 999.0\n" + inner + "999 999\n", "wing.dat"), both);
  // A closed trailing edge has its point twice, which the filters count once.
  EXPECT_EQ(this->Read(rows + "0 0\n", "wing.dat")[0].size(), 5u);
}

TEST_F(PlanarDomainReader, CommaSelectsTableForOtherEndings)
{
  EXPECT_EQ(this->Read(SquareTable, "/dev/stdin"), std::vector<Loop>{ Square });
  EXPECT_EQ(this->Read("0 0\n2 0\n2 1\n0 1\n", "/dev/stdin"), std::vector<Loop>{ Square });
}

TEST_F(PlanarDomainReader, RejectsInvalidText)
{
  this->Reader->SetFileName("/no/such/file.csv");
  EXPECT_EQ(
    FilterChecks::CaptureError(this->Reader, { "'/no/such/file.csv'" }), vtkErrorCode::UserError);
  const char* table = "loop.csv";
  this->Refuses("", table, "no columns x and y");
  this->Refuses("a,b\n0,0\n1,0\n1,1\n", table, "no columns x and y");
  this->Refuses("x;y\n0;0\n1;0\n1;1\n", table, "no columns x and y");
  this->Refuses("x,y\n", table, "no points");
  this->Refuses("x,y\n0,0\n1,zero\n1,1\n", table, "Row 2");
  this->Refuses("x,y\n0,0\n1\n1,1\n", table, "Row 2");
  this->Refuses("x,y,loop\n0,0,1\n1,0,1\n1,1,1\n.5,.5,2\n", table, "Loop 2");
  this->Refuses("x,y\n\xff\xfe,0\n", table, "");
  const char* profile = "wing.dat";
  this->Refuses("", profile, "three points");
  this->Refuses("name\n1 0\n0 0\n", profile, "three points");
  this->Refuses("name\n1 0\n0.5 zero\n", profile, "Line 3");
  this->Refuses("name\n1 0 0\n0 0 1\n", profile, "Line 2");
  this->Refuses("name\n1 0\n0 nan\n", profile, "Line 3");
  this->Refuses("name\n2. 2.\n0 0\n1 0.1\n0 0\n1 -0.1\n", profile, "Lednicer");
  this->Refuses("0 0\n2 0\n2 1\n\n\n0 1\n1 0\n", profile, "Loop 2");
}

TEST_F(PlanarDomainReader, ReadsFilesAndDetectsFormats)
{
  const std::string folder = testing::TempDir() + "crossfield-reader-";
  struct Case
  {
    const char* ending;
    const char* text;
    int expected;
  };
  for (const Case& test : { Case{ ".csv", SquareTable, 1 }, Case{ ".csv", "time,value\n0,1\n", 0 },
         Case{ ".dat", "name\n0 0\n2 0\n2 1\n0 1\n", 1 },
         Case{ ".dat", "TITLE = \"Tecplot\"\nVARIABLES = x, y\n", 0 }, Case{ ".csv", "", 0 },
         Case{ ".dat", "", 0 } })
  {
    const std::string file = folder + std::to_string(test.expected) + test.ending;
    std::ofstream(file) << test.text;
    EXPECT_EQ(vtkPlanarDomainReader::CanReadFile(file.c_str()), test.expected) << test.text;
    this->Reader->SetFileName(file);
    if (test.expected == 1)
    {
      this->Reader->ReadFromInputStringOff();
      FilterChecks::UpdateWithoutError(this->Reader);
      EXPECT_EQ(this->Reader->GetOutput()->GetNumberOfPoints(), 4);
    }
    std::remove(file.c_str());
  }
  EXPECT_EQ(vtkPlanarDomainReader::CanReadFile("/no/such/file.csv"), 0);
  EXPECT_EQ(vtkPlanarDomainReader::CanReadFile(nullptr), 0);
}
