#include "support/FilterChecks.h"
#include "support/ResultFiles.h"
#include "support/TestInputs.h"
#include "vtkDrillHoles.h"
#include "vtkHField.h"
#include "vtkPerforatedCrossField.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

// Singularities on the boundary in vtkPoincareHopfCheck, vtkDrillHoles, vtkPerforatedCrossField and
// vtkHField.
namespace
{
using TestInputs::Row;

constexpr int Sides = 48;

/** Returns four rows, the first one on the boundary at a vertex or in the middle of a side. */
std::vector<Row> Rows(bool atVertex)
{
  const double half = std::acos(-1.0) / Sides;
  const Row boundary = atVertex
    ? Row{ 1.0, 0.0, 1.0, 0.1 }
    : Row{ std::cos(half) * std::cos(half), std::cos(half) * std::sin(half), 1.0, 0.1 };
  return { boundary, { 0.5, 0.5, 1.0, 0.1 }, { -0.6, 0.3, 1.0, 0.1 }, { -0.3, -0.6, 1.0, 0.1 } };
}

double Value(vtkAlgorithm* filter, const char* name)
{
  vtkDataArray* array = FilterChecks::Output(filter)->GetFieldData()->GetArray(name);
  return array == nullptr ? std::nan("") : array->GetTuple1(0);
}

class BoundarySingularities : public testing::TestWithParam<bool>
{
public:
  vtkSmartPointer<vtkPolyData> Domain = TestInputs::Loops({ TestInputs::Circle(Sides, 1.0) });
  vtkSmartPointer<vtkPolyData> Points = TestInputs::Singularities(Rows(this->GetParam()));
};
}

TEST_P(BoundarySingularities, CountAtTheBoundary)
{
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputData(this->Domain);
  check->SetSingularitiesData(this->Points);
  FilterChecks::UpdateWithoutError(check);
  EXPECT_EQ(Value(check, "Consistent"), 1.0);
  EXPECT_EQ(Value(check, "RequiredInteriorQuarters"), 3.0);
  EXPECT_EQ(Value(check, "GivenInteriorQuarters"), 3.0);
}

TEST_P(BoundarySingularities, HaveAVertexAndNoHole)
{
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputData(this->Domain);
  drill->SetSingularitiesData(this->Points);
  FilterChecks::UpdateWithoutError(drill);
  vtkUnstructuredGrid* mesh = drill->GetOutput();
  std::set<double> holes;
  for (vtkIdType i = 0; i < mesh->GetNumberOfCells(); ++i)
  {
    if (mesh->GetCellData()->GetArray("BoundaryKind")->GetTuple1(i) == 3.0)
    {
      holes.insert(mesh->GetCellData()->GetArray("BoundaryId")->GetTuple1(i));
    }
  }
  EXPECT_EQ(holes, (std::set<double>{ 1.0, 2.0, 3.0 }));
  vtkDataArray* record = mesh->GetFieldData()->GetArray("BoundarySingularities");
  ASSERT_NE(record, nullptr);
  ASSERT_EQ(record->GetNumberOfTuples(), 1);
  EXPECT_EQ(record->GetComponent(0, 3), 1.0);
  // The mesh has a vertex at the singularity, also in the middle of a side.
  double nearest = 1.0;
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    nearest = std::min(nearest,
      std::hypot(point[0] - record->GetComponent(0, 0), point[1] - record->GetComponent(0, 1)));
  }
  EXPECT_LT(nearest, 1e-12);

  vtkNew<vtkPerforatedCrossField> solve;
  solve->SetInputConnection(drill->GetOutputPort());
  solve->SetMethodToUnitNorm();
  FilterChecks::UpdateWithoutError(solve);
  ResultFiles::Save(solve);
  EXPECT_EQ(Value(solve, "Converged"), 1.0);
  EXPECT_EQ(Value(solve, "UnwantedSingularities"), 0.0);
  EXPECT_EQ(Value(solve, "RequiredInteriorQuarters"), 3.0);
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputConnection(solve->GetOutputPort());
  FilterChecks::UpdateWithoutError(check);
  EXPECT_EQ(Value(check, "Consistent"), 1.0);
}

TEST_P(BoundarySingularities, HaveTheSameFieldAsH)
{
  // The energy of the unit-norm field with small holes is the coefficient of the logarithm times
  // log(1/ρ) plus W of the field of points, up to terms that vanish with ρ.
  vtkNew<vtkHField> points;
  points->SetInputData(this->Domain);
  points->SetSingularitiesData(this->Points);
  FilterChecks::UpdateWithoutError(points);
  const double finite = Value(points, "RenormalizedEnergy");
  double before = 0.0;
  for (const double radius : { 0.04, 0.02 })
  {
    auto rows = Rows(this->GetParam());
    for (Row& row : rows)
    {
      row[3] = radius;
    }
    vtkNew<vtkDrillHoles> drill;
    drill->SetInputData(this->Domain);
    drill->SetSingularitiesData(TestInputs::Singularities(rows));
    vtkNew<vtkPerforatedCrossField> solve;
    solve->SetInputConnection(drill->GetOutputPort());
    solve->SetMethodToUnitNorm();
    FilterChecks::UpdateWithoutError(solve);
    const double energy = Value(solve, "Energy");
    EXPECT_GT(energy, finite);
    if (before != 0.0)
    {
      // Three interior singularities add 3π log 2. The contribution at the boundary is the same for
      // both radii.
      EXPECT_NEAR(energy - before, 3.0 * std::acos(-1.0) * std::log(2.0), 0.05 * (energy - before));
    }
    before = energy;
  }
}

INSTANTIATE_TEST_SUITE_P(MidSideOrVertex, BoundarySingularities, testing::Bool());
