#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossGlyphs.h"
#include "vtkPerforatedCrossField.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTriangle.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace
{
using Vector = std::array<double, 3>;

Vector Combine(double a, const Vector& p, double b, const Vector& q)
{
  return { a * p[0] + b * q[0], a * p[1] + b * q[1], a * p[2] + b * q[2] };
}

double Length(const Vector& v)
{
  return std::hypot(v[0], v[1], v[2]);
}

/** Line of the output. */
struct Stroke
{
  Vector middle;
  Vector along; ///< Difference of the end points.
  double norm;
};

class CrossGlyphs : public testing::Test
{
public:
  void SetUp() override
  {
    // The plane z = 2.5 shows whether the crosses are in the plane of the field.
    vtkNew<vtkPerforatedCrossField> solver;
    solver->SetMethodToConstrained(); // its norms vary
    solver->SetInputData(TestInputs::Drill(
      TestInputs::Loops({ TestInputs::Circle(64, 1.0) }, 2.5), TestInputs::FourOnDisk(), 0.15));
    FilterChecks::UpdateWithoutError(solver);
    this->Field = solver->GetOutput();
    this->Glyphs->SetInputData(this->Field);
  }

  std::vector<Stroke> Strokes()
  {
    FilterChecks::UpdateWithoutError(this->Glyphs);
    vtkPolyData* output = this->Glyphs->GetOutput();
    EXPECT_EQ(output->GetNumberOfCells(), output->GetNumberOfLines());
    vtkDataArray* norms = FilterChecks::RequireArray(output->GetCellData(), "CrossNorm");
    EXPECT_EQ(norms->GetNumberOfTuples(), output->GetNumberOfCells());
    EXPECT_EQ(norms->GetNumberOfComponents(), 1);
    EXPECT_EQ(norms->GetDataType(), VTK_DOUBLE);
    std::vector<Stroke> strokes;
    for (vtkIdType line = 0; line < output->GetNumberOfCells(); ++line)
    {
      EXPECT_EQ(output->GetCellType(line), VTK_LINE);
      Vector ends[2];
      output->GetCell(line)->GetPoints()->GetPoint(0, ends[0].data());
      output->GetCell(line)->GetPoints()->GetPoint(1, ends[1].data());
      strokes.push_back({ Combine(0.5, ends[0], 0.5, ends[1]), Combine(-1.0, ends[0], 1.0, ends[1]),
        norms->GetTuple1(line) });
    }
    return strokes;
  }

  std::vector<vtkIdType> Triangles()
  {
    std::vector<vtkIdType> cells;
    for (vtkIdType cell = 0; cell < this->Field->GetNumberOfCells(); ++cell)
    {
      if (this->Field->GetCellType(cell) == VTK_TRIANGLE)
      {
        cells.push_back(cell);
      }
    }
    return cells;
  }

  Vector Centre(vtkIdType cell)
  {
    Vector centre = {};
    for (vtkIdType i = 0; i < 3; ++i)
    {
      Vector corner;
      this->Field->GetCell(cell)->GetPoints()->GetPoint(i, corner.data());
      centre = Combine(1.0, centre, 1.0 / 3.0, corner);
    }
    return centre;
  }

  bool Contains(vtkIdType cell, const Vector& place)
  {
    double smallest = 1.0;
    for (vtkIdType i = 0; i < 3; ++i)
    {
      Vector from;
      Vector to;
      this->Field->GetCell(cell)->GetPoints()->GetPoint(i, from.data());
      this->Field->GetCell(cell)->GetPoints()->GetPoint((i + 1) % 3, to.data());
      smallest = std::min(smallest,
        (to[0] - from[0]) * (place[1] - from[1]) - (to[1] - from[1]) * (place[0] - from[0]));
    }
    return smallest >= 0.0; // to the left of all three sides
  }

  Vector Value(const char* name, vtkIdType cell)
  {
    Vector value = {};
    FilterChecks::RequireArray(this->Field->GetCellData(), name)->GetTuple(cell, value.data());
    return value;
  }

  vtkSmartPointer<vtkUnstructuredGrid> Field;
  vtkNew<vtkCrossGlyphs> Glyphs;
};
}

TEST_F(CrossGlyphs, FollowsFilterConventions)
{
  FilterChecks::CheckRunTwice(
    this->Glyphs, [this] { this->Glyphs->SetInputData(this->Field); },
    [this]
    {
      vtkNew<vtkPerforatedCrossField> solver;
      solver->SetInputData(TestInputs::DrilledDisk(0.3));
      solver->Update();
      this->Glyphs->SetInputData(solver->GetOutput());
    });
  FilterChecks::CheckInputUntouched(this->Glyphs);
  FilterChecks::CheckProgressAndAbort(this->Glyphs);
  FilterChecks::CheckEmptyInput(this->Glyphs);
  FilterChecks::CheckPrintSelf(this->Glyphs, { "Spacing", "Scale", "ScaleByNorm" });
}

TEST_F(CrossGlyphs, OneCrossPerTriangleByDefault)
{
  const std::vector<Stroke> strokes = this->Strokes();
  const std::vector<vtkIdType> cells = this->Triangles();
  ASSERT_EQ(strokes.size(), 2 * cells.size());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    auto* triangle = vtkTriangle::SafeDownCast(this->Field->GetCell(cells[i]));
    const double length = 0.8 * std::sqrt(triangle->ComputeArea());
    for (std::size_t branch : { 0u, 1u })
    {
      const Stroke& stroke = strokes[2 * i + branch];
      const Vector expected = this->Value(branch == 0 ? "Cross" : "Cross2", cells[i]);
      EXPECT_NEAR(Length(Combine(1.0, stroke.middle, -1.0, this->Centre(cells[i]))), 0.0, 1e-14);
      EXPECT_NEAR(Length(Combine(1.0, stroke.along, -length, expected)), 0.0, 1e-14);
      EXPECT_EQ(stroke.norm, this->Value("CrossNorm", cells[i])[0]);
    }
  }
}

TEST_F(CrossGlyphs, LengthDependsOnScaleAndNorm)
{
  const std::vector<Stroke> plain = this->Strokes();
  this->Glyphs->SetScale(0.2);
  this->Glyphs->ScaleByNormOn();
  const std::vector<Stroke> scaled = this->Strokes();
  ASSERT_EQ(scaled.size(), plain.size());
  double smallestNorm = 1.0;
  double largestNorm = 1.0;
  for (std::size_t i = 0; i < plain.size(); ++i)
  {
    const double expected = 0.25 * plain[i].norm * Length(plain[i].along);
    EXPECT_NEAR(Length(scaled[i].along), expected, 1e-14);
    smallestNorm = std::min(smallestNorm, plain[i].norm);
    largestNorm = std::max(largestNorm, plain[i].norm);
  }
  EXPECT_LT(smallestNorm, 0.9 * largestNorm) << "the norms must vary for this test";
}

TEST_F(CrossGlyphs, SpacingGivesOneCrossPerGridSquare)
{
  constexpr double Spacing = 0.3;
  using Square = std::array<double, 2>;
  const auto square = [](const Vector& place) {
    return Square{ std::floor(place[0] / Spacing), std::floor(place[1] / Spacing) };
  };
  const auto middle = [](const Square& of) {
    return Vector{ (of[0] + 0.5) * Spacing, (of[1] + 0.5) * Spacing, 2.5 };
  };
  const auto distance = [](const Vector& a, const Vector& b)
  { return Length(Combine(1.0, a, -1.0, b)); };
  // The mesh is symmetric, so two triangles may be equally near.
  const auto offset = [&](vtkIdType cell)
  { return distance(this->Centre(cell), middle(square(this->Centre(cell)))); };
  constexpr double Rounding = 1e-12;
  std::map<Square, std::vector<vtkIdType>> nearest;
  for (vtkIdType cell : this->Triangles())
  {
    std::vector<vtkIdType>& cells = nearest[square(this->Centre(cell))];
    if (!cells.empty() && offset(cell) < offset(cells.front()) - Rounding)
    {
      cells.clear();
    }
    if (cells.empty() || offset(cell) < offset(cells.front()) + Rounding)
    {
      cells.push_back(cell);
    }
  }

  this->Glyphs->SetSpacing(Spacing);
  const std::vector<Stroke> strokes = this->Strokes();
  ASSERT_EQ(strokes.size(), 2 * nearest.size());
  std::map<Square, int> count;
  int inTheMiddle = 0;
  for (const Stroke& stroke : strokes)
  {
    const Square here = square(stroke.middle);
    ASSERT_EQ(nearest.count(here), 1u);
    const auto isDrawn = [&](vtkIdType cell)
    {
      const Vector expected =
        this->Contains(cell, middle(here)) ? middle(here) : this->Centre(cell);
      return distance(stroke.middle, expected) < Rounding &&
        stroke.norm == this->Value("CrossNorm", cell)[0];
    };
    const auto drawn = std::find_if(nearest[here].begin(), nearest[here].end(), isDrawn);
    ASSERT_NE(drawn, nearest[here].end());
    EXPECT_NEAR(Length(stroke.along), 0.8 * Spacing, 1e-7); // directions are in single precision
    ++count[here];
    inTheMiddle += this->Contains(*drawn, middle(here)) ? 1 : 0;
  }
  EXPECT_GT(inTheMiddle, 0);
  EXPECT_LT(inTheMiddle, static_cast<int>(strokes.size())) << "squares at the boundary";
  for (const auto& entry : count)
  {
    EXPECT_EQ(entry.second, 2) << "one cross in a square";
  }
}

TEST_F(CrossGlyphs, AreComputedFromTheExactField)
{
  const std::vector<Stroke> expected = this->Strokes();
  for (const auto& missing : std::vector<std::vector<const char*>>{
         { "Cross2" }, { "Cross" }, { "CrossNorm" }, { "Cross", "Cross2", "CrossNorm" } })
  {
    vtkNew<vtkUnstructuredGrid> field;
    field->DeepCopy(this->Field);
    for (const char* name : missing)
    {
      field->GetCellData()->RemoveArray(name);
    }
    this->Glyphs->SetInputData(field);
    const std::vector<Stroke> found = this->Strokes();
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      // The arrays are in single precision.
      EXPECT_LT(Length(Combine(1.0, found[i].along, -1.0, expected[i].along)), 1e-6);
      EXPECT_LT(Length(Combine(1.0, found[i].middle, -1.0, expected[i].middle)), 1e-12);
      EXPECT_NEAR(found[i].norm, expected[i].norm, 1e-6);
    }
  }
}

TEST_F(CrossGlyphs, RejectsAMeshWithoutTheField)
{
  for (const char* name : { "Cross", "CrossNorm" })
  {
    vtkNew<vtkUnstructuredGrid> bare;
    bare->DeepCopy(this->Field);
    bare->GetCellData()->RemoveArray(name);
    bare->GetCellData()->GetArray("CrossFieldCR")->SetName("Other");
    this->Glyphs->SetInputData(bare);
    EXPECT_EQ(FilterChecks::CaptureError(this->Glyphs, { "'" + std::string(name) + "'" }),
      vtkErrorCode::UserError);
  }
  for (const char* name : { "Cross", "Cross2", "CrossNorm" })
  {
    vtkNew<vtkUnstructuredGrid> other;
    other->DeepCopy(this->Field);
    other->GetCellData()->RemoveArray(name);
    other->GetCellData()->GetArray("CrossFieldCR")->SetName(name); // has six components
    this->Glyphs->SetInputData(other);
    FilterChecks::CaptureError(this->Glyphs, { "'" + std::string(name) + "'" });
  }
  this->Glyphs->SetInputData(this->Field);
  FilterChecks::UpdateWithoutError(this->Glyphs);
}
