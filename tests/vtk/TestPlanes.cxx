// Domains in any plane of space: every filter gives the output for z = 0, moved to the plane.

#include "support/PlanesTest.h"
#include "vtkBoundaryCornerClassifier.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkCrossGlyphs.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkLayoutDesigner.h"
#include "vtkPoincareHopfCheck.h"
#include "vtkSingularitySource.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <vector>

namespace
{
using namespace PlanesTest;

class Planes : public testing::TestWithParam<Rotation>
{
public:
  Pipeline Flat{ Identity };
  Pipeline Tilted{ GetParam() };

  /** Expects the points in z = 0, rotated, in the same order. */
  void ExpectRotated(vtkDataSet* turned, vtkDataSet* flat, double tolerance = 1e-12)
  {
    ASSERT_EQ(turned->GetNumberOfPoints(), flat->GetNumberOfPoints());
    ASSERT_GT(flat->GetNumberOfPoints(), 0);
    for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
    {
      EXPECT_LT(Distance(Apply(GetParam(), flat->GetPoint(i)), turned->GetPoint(i)), tolerance);
    }
  }
};

TEST_P(Planes, MeshAndFieldRotate)
{
  for (Pipeline* pipeline : { &this->Flat, &this->Tilted })
  {
    FilterChecks::UpdateWithoutError(pipeline->Solver);
  }
  vtkUnstructuredGrid* flat = this->Flat.Solver->GetOutput();
  vtkUnstructuredGrid* turned = this->Tilted.Solver->GetOutput();
  ASSERT_EQ(turned->GetNumberOfPoints(), flat->GetNumberOfPoints());
  ASSERT_EQ(turned->GetNumberOfCells(), flat->GetNumberOfCells());
  EXPECT_NEAR(Value(turned, "Energy") / Value(flat, "Energy"), 1.0, 1e-12);

  const auto complex = [](vtkUnstructuredGrid* field, vtkIdType i)
  {
    const double* u = field->GetPointData()->GetArray("Representation")->GetTuple3(i);
    return std::complex<double>(u[0], u[1]);
  };
  const Vector normal = Apply(GetParam(), Identity[2].data());
  for (vtkIdType i = 0; i < flat->GetNumberOfPoints(); ++i)
  {
    // The numbering of points may differ, so each one is located.
    const Vector place = Apply(GetParam(), flat->GetPoint(i));
    vtkIdType found = 0;
    for (vtkIdType j = 1; j < turned->GetNumberOfPoints(); ++j)
    {
      found =
        Distance(place, turned->GetPoint(j)) < Distance(place, turned->GetPoint(found)) ? j : found;
    }
    ASSERT_LT(Distance(place, turned->GetPoint(found)), 1e-12);
    // Representation and crosses are in single precision.
    EXPECT_LT(std::abs(complex(flat, i) - complex(turned, found)), 1e-6)
      << "u in the plane's frame";

    Vector crosses[2];
    turned->GetPointData()->GetArray("Cross")->GetTuple(found, crosses[0].data());
    turned->GetPointData()->GetArray("Cross2")->GetTuple(found, crosses[1].data());
    Vector product;
    vtkMath::Cross(crosses[0].data(), crosses[1].data(), product.data());
    EXPECT_LT(Distance(normal, product.data()), 1e-6) << "orthogonal unit vectors in the plane";
    // Where arg(u) is near π rounding selects the branch; cos 4θ does not depend on it.
    double expected[3];
    flat->GetPointData()->GetArray("Cross")->GetTuple(i, expected);
    const double cosine = vtkMath::Dot(Apply(GetParam(), expected).data(), crosses[0].data());
    EXPECT_NEAR(8 * std::pow(cosine, 4) - 8 * std::pow(cosine, 2) + 1, 1.0, 1e-5);
  }
}

TEST_P(Planes, CornersAndOverridesRotate)
{
  vtkNew<vtkBoundaryCornerClassifier> classifiers[2];
  for (int i = 0; i < 2; ++i)
  {
    classifiers[i]->SetInputData(i == 0 ? this->Flat.Domain : this->Tilted.Domain);
    classifiers[i]->AddPointOverride(3, -2);
    classifiers[i]->AddOverride(4, 2, 2); // in the coordinates of the plane
    FilterChecks::UpdateWithoutError(classifiers[i]);
  }
  this->ExpectRotated(classifiers[1]->GetOutput(), classifiers[0]->GetOutput());
  for (const char* name : { "QuarterIndex", "Overridden", "QuarterIndexScarce" })
  {
    for (vtkIdType i = 0; i < 6; ++i)
    {
      EXPECT_EQ(classifiers[0]->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(i),
        classifiers[1]->GetOutput()->GetPointData()->GetArray(name)->GetTuple1(i))
        << name;
    }
  }
  // The corners are on the boundary of a mesh of the same domain, and the singularities fit their
  // sum.
  double energies[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkPerforatedCrossField* solver = (i == 0 ? this->Flat : this->Tilted).Solver;
    solver->SetMethodToUnitNorm();
    FilterChecks::UpdateWithoutError(solver);
    const double withoutCorners = Value(solver->GetOutput(), "Energy");
    solver->SetCornersConnection(classifiers[i]->GetOutputPort());
    FilterChecks::UpdateWithoutError(solver);
    energies[i] = Value(solver->GetOutput(), "Energy");
    EXPECT_GT(energies[i], 1.1 * withoutCorners);
  }
  EXPECT_NEAR(energies[1] / energies[0], 1.0, 1e-12);
}

TEST_P(Planes, CheckAndProposalRotate)
{
  vtkNew<vtkPoincareHopfCheck> checks[2];
  vtkNew<vtkConfigurationProposal> proposals[2];
  for (int i = 0; i < 2; ++i)
  {
    Pipeline& pipeline = i == 0 ? this->Flat : this->Tilted;
    checks[i]->SetInputData(pipeline.Domain);
    checks[i]->SetSingularitiesData(pipeline.Singularities);
    FilterChecks::UpdateWithoutError(checks[i]);
    EXPECT_EQ(Value(checks[i]->GetOutput(), "Consistent"), 1.0);
    proposals[i]->SetInputData(pipeline.Domain);
    proposals[i]->SetSingularitiesData(pipeline.Singularities);
    FilterChecks::UpdateWithoutError(proposals[i]);
  }
  this->ExpectRotated(vtkPolyData::SafeDownCast(checks[1]->GetOutputDataObject(2)),
    vtkPolyData::SafeDownCast(checks[0]->GetOutputDataObject(2)));
  this->ExpectRotated(proposals[1]->GetOutput(), proposals[0]->GetOutput());
  // The same check of a solved field.
  for (int i = 0; i < 2; ++i)
  {
    checks[i]->SetInputConnection((i == 0 ? this->Flat : this->Tilted).Solver->GetOutputPort());
    FilterChecks::UpdateWithoutError(checks[i]);
  }
  this->ExpectRotated(vtkPolyData::SafeDownCast(checks[1]->GetOutputDataObject(2)),
    vtkPolyData::SafeDownCast(checks[0]->GetOutputDataObject(2)));
}

TEST_P(Planes, SingularitiesRotate)
{
  vtkNew<vtkCrossFieldSingularities> finders[2];
  vtkNew<vtkGinzburgLandauCrossField> references[2];
  for (int i = 0; i < 2; ++i)
  {
    Pipeline& pipeline = i == 0 ? this->Flat : this->Tilted;
    finders[i]->SetIncludeHoles(true);
    finders[i]->SetInputConnection(pipeline.Solver->GetOutputPort());
    FilterChecks::UpdateWithoutError(finders[i]);
  }
  this->ExpectRotated(finders[1]->GetOutput(), finders[0]->GetOutput(), 1e-9);
  for (int i = 0; i < 2; ++i)
  {
    Pipeline& pipeline = i == 0 ? this->Flat : this->Tilted;
    pipeline.Drill->SetInputData(
      Rotated(TestInputs::Loops({ { { 0, 0 }, { 4, 0 }, { 5, 3 }, { 2, 5 }, { -1, 2 } } }),
        i == 0 ? Identity : GetParam()));
    pipeline.Drill->SetSingularitiesData(TestInputs::Singularities({}));
    references[i]->SetInputConnection(pipeline.Drill->GetOutputPort());
    references[i]->SetEpsilon(
      4.0); // a weak penalty has one minimum; otherwise rounding selects one
    FilterChecks::UpdateWithoutError(references[i]);
  }
  EXPECT_GT(Value(references[0]->GetOutput(), "Energy"), 1.0);
  EXPECT_NEAR(
    Value(references[1]->GetOutput(), "Energy") / Value(references[0]->GetOutput(), "Energy"), 1.0,
    1e-10);
}

TEST_P(Planes, GlyphsRotate)
{
  vtkNew<vtkCrossGlyphs> glyphs[2];
  for (int i = 0; i < 2; ++i)
  {
    glyphs[i]->SetInputConnection((i == 0 ? this->Flat : this->Tilted).Solver->GetOutputPort());
    glyphs[i]->SetSpacing(0.37); // no centre of a square is equally near to two triangles
    FilterChecks::UpdateWithoutError(glyphs[i]);
  }
  ASSERT_EQ(glyphs[1]->GetOutput()->GetNumberOfLines(), glyphs[0]->GetOutput()->GetNumberOfLines());
  for (vtkIdType i = 0; i < glyphs[0]->GetOutput()->GetNumberOfLines(); ++i)
  {
    double middles[2][3];
    for (int j = 0; j < 2; ++j)
    {
      double ends[2][3];
      glyphs[j]->GetOutput()->GetPoint(2 * i, ends[0]);
      glyphs[j]->GetOutput()->GetPoint(2 * i + 1, ends[1]);
      for (int k = 0; k < 3; ++k)
      {
        middles[j][k] = 0.5 * (ends[0][k] + ends[1][k]);
      }
    }
    EXPECT_LT(Distance(Apply(GetParam(), middles[0]), middles[1]), 1e-10);
  }
}

TEST_P(Planes, RowsAndLayoutUsePlaneCoordinates)
{
  // The rows are the same in every plane, since the frame rotates with it.
  const std::vector<std::array<double, 2>> rows = { { 1, 3 }, { 3, 1 } };
  vtkNew<vtkSingularitySource> sources[2];
  vtkNew<vtkLayoutDesigner> designers[2];
  for (int i = 0; i < 2; ++i)
  {
    vtkPolyData* domain = (i == 0 ? this->Flat : this->Tilted).Domain;
    sources[i]->SetDomainData(domain);
    sources[i]->RemoveAllSingularities();
    for (int row = 0; row < 2; ++row)
    {
      sources[i]->AddSingularity(rows[row][0], rows[row][1], 1 - 2 * row, 0.25);
    }
    FilterChecks::UpdateWithoutError(sources[i]);
    designers[i]->SetInputData(domain);
    designers[i]->SetSingularitiesConnection(sources[i]->GetOutputPort());
    FilterChecks::UpdateWithoutError(designers[i]);
    EXPECT_EQ(Value(designers[i]->GetOutput(), "Stale"), 0.0);
    for (int row = 0; row < 2; ++row)
    {
      for (int j = 0; j < 2; ++j)
      {
        EXPECT_NEAR(designers[i]->GetRows()->GetComponent(row, j), rows[row][j], 1e-12);
        EXPECT_NEAR(sources[i]->GetOutputRows()->GetComponent(row, j), rows[row][j], 1e-12);
      }
    }
    for (vtkDoubleArray* plane : { sources[i]->GetPlane(), designers[i]->GetPlane() })
    {
      ASSERT_EQ(plane->GetNumberOfTuples(), 3);
      EXPECT_LT(Distance({ 0, 0, 0 }, plane->GetTuple3(0)), 1e-12);
      for (int axis = 0; axis < 2; ++axis)
      {
        const Rotation& turn = i == 0 ? Identity : GetParam();
        EXPECT_LT(Distance(Apply(turn, Identity[axis].data()), plane->GetTuple3(1 + axis)), 1e-12);
      }
    }
  }
  this->ExpectRotated(sources[1]->GetOutput(), sources[0]->GetOutput());
  this->ExpectRotated(designers[1]->GetOutput(), designers[0]->GetOutput(), 1e-9);
}

TEST_P(Planes, RowsAreInThePlaneOfStart)
{
  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputData(this->Tilted.Domain);
  proposal->SetSingularitiesData(this->Tilted.Singularities);
  vtkNew<vtkSingularitySource> copied;
  copied->SetStartConnection(proposal->GetOutputPort());
  FilterChecks::UpdateWithoutError(copied);
  const vtkIdType count = copied->GetOutputRows()->GetNumberOfTuples();
  ASSERT_GT(count, 0);
  vtkNew<vtkSingularitySource> reset; // without a domain
  reset->SetStartConnection(copied->GetOutputPort());
  reset->RemoveAllSingularities();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double* row = copied->GetOutputRows()->GetTuple4(i);
    reset->AddSingularity(row[0], row[1], row[2], row[3]);
  }
  FilterChecks::UpdateWithoutError(reset);
  ASSERT_EQ(reset->GetOutput()->GetNumberOfPoints(), count);
  for (vtkIdType i = 0; i < count; ++i)
  {
    Vector place;
    proposal->GetOutput()->GetPoint(i, place.data());
    EXPECT_LT(Distance(place, reset->GetOutput()->GetPoint(i)), 1e-12);
  }
  // Points that another filter moved are no longer in the recorded plane.
  vtkNew<vtkPolyData> moved;
  moved->DeepCopy(proposal->GetOutput());
  for (vtkIdType i = 0; i < count; ++i)
  {
    moved->GetPoints()->SetPoint(i, 0.5 * static_cast<double>(i), 0.25, 3.0);
  }
  vtkNew<vtkSingularitySource> level;
  level->SetStartData(moved);
  FilterChecks::UpdateWithoutError(level);
  for (vtkIdType i = 0; i < count; ++i)
  {
    EXPECT_EQ(level->GetOutputRows()->GetComponent(i, 0), 0.5 * static_cast<double>(i));
    EXPECT_EQ(level->GetOutputRows()->GetComponent(i, 1), 0.25);
  }
  EXPECT_EQ(Distance({ 0, 0, 3 }, level->GetPlane()->GetTuple3(0)), 0.0);
}

TEST_P(Planes, InputIsUnchanged)
{
  FilterChecks::CheckInputUntouched(this->Tilted.Drill);
  FilterChecks::CheckInputUntouched(this->Tilted.Solver);
}

const std::array<Rotation, 4> Rotations = { Identity,
  Rotation{ { { 0, 0, 1 }, { 1, 0, 0 }, { 0, 1, 0 } } },
  Rotation{ { { 1, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 } } }, Tilt({ 0.3, -0.4, 0.8 }) };

std::string PlaneName(const testing::TestParamInfo<Rotation>& info)
{
  const char* const names[] = { "XY", "YZ", "XZ", "Tilted" };
  return names[info.index];
}

INSTANTIATE_TEST_SUITE_P(In, Planes, testing::ValuesIn(Rotations), PlaneName);
}
