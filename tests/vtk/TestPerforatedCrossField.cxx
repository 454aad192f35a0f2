#include "support/FieldReading.h"
#include "support/FilterChecks.h"
#include "support/PerforatedCrossFieldTest.h"
#include "support/ResultFiles.h"
#include "support/TestInputs.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace
{
using Complex = std::complex<double>;
}

TEST_F(PerforatedCrossField, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Filter->SetInputData(TestInputs::DrilledDisk()); },
    [this] { this->Filter->SetInputData(TestInputs::DrilledIsland()); });
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckEmptyInput(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "Method", "Start", "UnitHoles", "MaximumIterations", "Tolerance", "Arrays", "StageSeconds" });
}

TEST_F(PerforatedCrossField, WritesDocumentedArrays)
{
  const auto mesh = TestInputs::DrilledIsland();
  vtkUnstructuredGrid* output = this->Solve(mesh);
  vtkCellData* cells = output->GetCellData();
  vtkPointData* points = output->GetPointData();
  const vtkIdType cellCount = mesh->GetNumberOfCells();
  const vtkIdType pointCount = mesh->GetNumberOfPoints();
  EXPECT_EQ(output->GetNumberOfCells(), cellCount);
  EXPECT_EQ(output->GetNumberOfPoints(), pointCount);
  for (const char* name : { "BoundaryKind", "BoundaryId", "QuarterIndex" })
  {
    ExpectArray(cells, name, VTK_INT, 1, cellCount);
  }
  ExpectArray(cells, "CrossFieldCR", VTK_DOUBLE, 6, cellCount);
  for (const char* name : { "Representation", "Cross", "Cross2" })
  {
    ExpectArray(cells, name, VTK_FLOAT, 3, cellCount);
    ExpectArray(points, name, VTK_FLOAT, 3, pointCount);
  }
  ExpectArray(cells, "CrossNorm", VTK_FLOAT, 1, cellCount);
  ExpectArray(points, "CrossNorm", VTK_FLOAT, 1, pointCount);
  EXPECT_STREQ(points->GetScalars()->GetName(), "CrossNorm") << "what ParaView colours by";

  vtkFieldData* report = output->GetFieldData();
  for (const char* name : { "Energy", "Residual", "Valence", "TangentTurning" })
  {
    ExpectArray(report, name, VTK_DOUBLE, 1, 1);
  }
  for (const char* name : { "Iterations", "Converged", "UnwantedSingularities",
         "EulerCharacteristic", "RequiredInteriorQuarters", "GivenInteriorQuarters", "Consistent" })
  {
    ExpectArray(report, name, VTK_INT, 1, 1);
  }
  ExpectArray(report, "HoleDegree", VTK_INT, 1, 3);
  ExpectArray(report, "HoleNormRange", VTK_DOUBLE, 2, 3);
}

TEST_F(PerforatedCrossField, TrianglesAndLinesAgreeOnTheirEdges)
{
  const FieldReading field(this->Solve(TestInputs::DrilledIsland()));
  for (const auto& [side, where] : field.sides)
  {
    const auto opposite = field.sides.find({ side[1], side[0] });
    if (opposite != field.sides.end())
    {
      const auto& other = opposite->second;
      EXPECT_EQ(field.At(field.triangles[where[0]].cell)[where[1]],
        field.At(field.triangles[other[0]].cell)[other[1]]);
    }
  }
  for (const auto& line : field.lines)
  {
    const auto& where = field.sides.at(line.points);
    const Complex expected = field.At(field.triangles[where[0]].cell)[where[1]];
    EXPECT_EQ(field.At(line.cell), FieldReading::Sides({ expected, expected, expected }));
  }
}

TEST_F(PerforatedCrossField, IsAlignedWithTheBoundary)
{
  const FieldReading field(this->Solve(TestInputs::DrilledIsland()));
  for (std::size_t i = 0; i < field.lines.size(); ++i)
  {
    const auto& line = field.lines[i];
    if (line.kind != 1 && line.kind != 2)
    {
      continue;
    }
    // Higher precision, so that the difference is the error of the filter.
    using Long = std::complex<long double>;
    Long direction = Long(field.points[line.points[1]]) - Long(field.points[line.points[0]]);
    direction /= std::abs(direction);
    const Long expected = direction * direction * direction * direction;
    EXPECT_NEAR(double(std::abs(Long(field.OnLine(i)) - expected)), 0.0, 1e-15);
  }
}

TEST_F(PerforatedCrossField, DisplayArraysFollowFromTheExactField)
{
  vtkUnstructuredGrid* output = this->Solve(TestInputs::DrilledIsland());
  const FieldReading field(output);
  // The display arrays are in single precision.
  const double rounding = std::ldexp(1.0, -21);
  const auto expect = [rounding](vtkFieldData* data, vtkIdType tuple, const Complex& u)
  {
    double representation[3];
    FilterChecks::RequireArray(data, "Representation")->GetTuple(tuple, representation);
    EXPECT_NEAR(std::abs(Complex(representation[0], representation[1]) - u), 0.0, rounding);
    EXPECT_EQ(representation[2], 0.0);
    const double norm = FilterChecks::RequireArray(data, "CrossNorm")->GetTuple1(tuple);
    EXPECT_NEAR(norm, std::abs(u), rounding);
    double cross[3];
    double cross2[3];
    FilterChecks::RequireArray(data, "Cross")->GetTuple(tuple, cross);
    FilterChecks::RequireArray(data, "Cross2")->GetTuple(tuple, cross2);
    EXPECT_NEAR(std::hypot(cross[0], cross[1]), 1.0, rounding);
    EXPECT_EQ(cross[2], 0.0);
    EXPECT_EQ(cross2[0], -cross[1]);
    EXPECT_EQ(cross2[1], cross[0]);
    EXPECT_EQ(cross2[2], 0.0);
    const Complex branch(cross[0], cross[1]);
    EXPECT_NEAR(std::abs(std::abs(u) * branch * branch * branch * branch - u), 0.0, rounding);
  };

  std::vector<Complex> sums(field.points.size());
  std::vector<double> weights(field.points.size());
  for (std::size_t t = 0; t < field.triangles.size(); ++t)
  {
    const auto& triangle = field.triangles[t];
    const FieldReading::Sides u = field.At(triangle.cell);
    expect(output->GetCellData(), triangle.cell, (u[0] + u[1] + u[2]) / 3.0);
    const FieldReading::Sides corners = field.AtCorners(t);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto point = static_cast<std::size_t>(triangle.points[i]);
      sums[point] += triangle.area * corners[i];
      weights[point] += triangle.area;
    }
  }
  for (std::size_t i = 0; i < field.lines.size(); ++i)
  {
    expect(output->GetCellData(), field.lines[i].cell, field.OnLine(i));
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
  {
    expect(output->GetPointData(), static_cast<vtkIdType>(i), sums[i] / weights[i]);
  }
}

TEST_F(PerforatedCrossField, TheReportFollowsFromTheExactField)
{
  for (const auto& mesh : { TestInputs::DrilledDisk(), TestInputs::DrilledIsland() })
  {
    const FieldReading field(this->SolveConstrained(mesh));
    const double energy = this->Value("Energy");
    EXPECT_GT(energy, 0.0);
    EXPECT_NEAR(field.Energy(), energy, 1e-12 * energy);

    vtkFieldData* report = this->Filter->GetOutput()->GetFieldData();
    vtkDataArray* degrees = FilterChecks::RequireArray(report, "HoleDegree");
    vtkDataArray* norms = FilterChecks::RequireArray(report, "HoleNormRange");
    int given = 0;
    for (int row = 0; row < degrees->GetNumberOfTuples(); ++row)
    {
      const std::vector<std::size_t> walk = field.OrderedLoop(3, row);
      const int prescribed = field.lines[walk.front()].quarterIndex;
      given += prescribed;
      EXPECT_NEAR(field.Degree(row), prescribed, 1e-12);
      EXPECT_EQ(degrees->GetComponent(row, 0), prescribed);
      double least = std::abs(field.OnLine(walk.front()));
      double largest = least;
      for (std::size_t line : walk)
      {
        least = std::min(least, std::abs(field.OnLine(line)));
        largest = std::max(largest, std::abs(field.OnLine(line)));
      }
      EXPECT_DOUBLE_EQ(norms->GetComponent(row, 0), least);
      EXPECT_DOUBLE_EQ(norms->GetComponent(row, 1), largest);
    }
    EXPECT_EQ(this->Value("GivenInteriorQuarters"), given);
    EXPECT_EQ(this->Value("RequiredInteriorQuarters"), given);
    EXPECT_EQ(this->Value("Consistent"), 1.0);
    EXPECT_EQ(this->Value("Converged"), 1.0);
    EXPECT_LE(this->Value("Residual"), this->Filter->GetTolerance());
    EXPECT_NEAR(4.0 * (this->Value("Valence") + this->Value("TangentTurning")), given, 1e-12);
  }
}

TEST_F(PerforatedCrossField, ReportsTopologyAndUnwantedSingularities)
{
  // On the disk every singularity is in a hole.
  const FieldReading disk(this->Solve(TestInputs::DrilledDisk()));
  EXPECT_EQ(this->Value("EulerCharacteristic"), 1.0);
  EXPECT_EQ(this->Value("Valence"), 0.0);
  EXPECT_NEAR(this->Value("TangentTurning"), 1.0, 1e-14);
  EXPECT_EQ(disk.CountSingular(), 0);
  EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);

  // The holes beside the island are far from the singularities of the relaxed field.
  this->Filter->SetStartToHarmonic(); // leads to the global minimum
  const FieldReading island(this->SolveConstrained(TestInputs::DrilledIsland()));
  EXPECT_EQ(this->Value("EulerCharacteristic"), 0.0);
  EXPECT_NEAR(this->Value("Valence"), 0.0, 1e-14); // no rotation at right angles
  EXPECT_NEAR(this->Value("TangentTurning"), -1.0, 1e-14);
  EXPECT_GT(island.CountSingular(), 0);
  EXPECT_GE(this->Value("UnwantedSingularities"), island.CountSingular());
}

TEST_F(PerforatedCrossField, TheUnitOfLengthDoesNotMatter)
{
  this->Solve(TestInputs::DrilledDisk());
  const double energy = this->Value("Energy");
  for (double scale : { 1e6, 1e-6 })
  {
    const auto mesh = TestInputs::DrilledDisk();
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
    {
      const double* point = mesh->GetPoint(i);
      mesh->GetPoints()->SetPoint(i, scale * point[0], scale * point[1], 0.0);
    }
    const FieldReading field(this->Solve(mesh));
    EXPECT_NEAR(this->Value("Energy"), energy, 1e-9 * energy);
    for (int row = 0; row < 4; ++row)
    {
      EXPECT_NEAR(field.Degree(row), 1.0, 1e-9);
    }
  }
}

TEST_F(PerforatedCrossField, RotatingTheDomainRotatesTheField)
{
  this->Solve(TestInputs::DrilledIsland());
  const double energy = this->Value("Energy");
  const auto mesh = TestInputs::DrilledIsland();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const Complex turned =
      std::polar(1.0, 0.7) * Complex(mesh->GetPoint(i)[0], mesh->GetPoint(i)[1]);
    mesh->GetPoints()->SetPoint(i, turned.real() + 20.0, turned.imag() - 30.0, 0.0);
  }
  const FieldReading turned(this->Solve(mesh));
  EXPECT_NEAR(this->Value("Energy"), energy, 1e-9 * energy);
  const FieldReading plain(this->Solve(TestInputs::DrilledIsland()));
  ASSERT_EQ(turned.triangles.size(), plain.triangles.size());
  double largest = 0.0;
  for (const auto& triangle : plain.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Complex expected = std::polar(1.0, 4.0 * 0.7) * plain.At(triangle.cell)[i];
      largest = std::max(largest, std::abs(turned.At(triangle.cell)[i] - expected));
    }
  }
  EXPECT_LT(largest, 1e-8);
}

TEST_F(PerforatedCrossField, WarnsWithoutConvergence)
{
  this->Filter->SetMethodToConstrained();
  this->Filter->SetMaximumIterations(1);
  this->Filter->SetInputData(TestInputs::DrilledDisk());
  FilterChecks::MessageRecorder messages(this->Filter);
  this->Filter->Update();
  ResultFiles::Save(this->Filter);
  EXPECT_TRUE(messages.errors.empty());
  ASSERT_EQ(messages.warnings.size(), 1u);
  EXPECT_NE(messages.warnings[0].find("1 step"), std::string::npos) << messages.warnings[0];
  EXPECT_EQ(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(this->Value("Converged"), 0.0);
  EXPECT_EQ(this->Value("Iterations"), 1.0);
  EXPECT_GT(this->Value("Residual"), this->Filter->GetTolerance());
}

TEST_F(PerforatedCrossField, MeasuresStages)
{
  this->Solve(TestInputs::DrilledDisk(0.05));
  for (double seconds : { this->Filter->GetStageSeconds()[0], this->Filter->GetStageSeconds()[1],
         this->Filter->GetStageSeconds()[2] })
  {
    EXPECT_GT(seconds, 0.0);
    EXPECT_LT(seconds, 60.0);
  }
}

TEST_F(PerforatedCrossField, KeepsOtherArraysOfTheMesh)
{
  const auto mesh = TestInputs::DrilledDisk();
  vtkNew<vtkUnstructuredGrid> named;
  named->ShallowCopy(mesh);
  vtkSmartPointer<vtkDataArray> ids;
  ids.TakeReference(mesh->GetCellData()->GetArray("BoundaryId")->NewInstance());
  ids->DeepCopy(mesh->GetCellData()->GetArray("BoundaryId"));
  ids->SetName("MyArray");
  named->GetCellData()->AddArray(ids);
  EXPECT_NE(this->Solve(named)->GetCellData()->GetArray("MyArray"), nullptr);
}
