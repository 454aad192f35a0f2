#include "support/FilterChecks.h"
#include "support/MeshReading.h"
#include "support/ResultFiles.h"
#include "support/SolverTest.h"
#include "support/TestInputs.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>
#include <string>

namespace
{
using Complex = std::complex<double>;
using TestInputs::Circle;

constexpr double MeshSize = 0.15;

vtkSmartPointer<vtkUnstructuredGrid> Disk()
{
  return TestInputs::Drill(TestInputs::Loops({ Circle(42, 1.0) }), {}, MeshSize);
}

vtkSmartPointer<vtkUnstructuredGrid> Ring()
{
  return TestInputs::Drill(TestInputs::Loops({ Circle(60, 1.0), Circle(24, 0.4) }), {}, 0.1);
}

/** Adds a cell array with the value `inside` on triangles in a disk and `outside` elsewhere. */
void AddCellArray(vtkUnstructuredGrid* mesh, const char* name, double outside, double inside,
  Complex centre = 0.0, double radius = 0.0)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(mesh->GetNumberOfCells());
  array->FillValue(outside);
  const MeshReading reading(mesh);
  for (const MeshReading::Triangle& triangle : reading.triangles)
  {
    Complex middle = 0.0;
    for (const vtkIdType point : triangle.points)
    {
      middle += reading.points[static_cast<std::size_t>(point)] / 3.0;
    }
    if (std::abs(middle - centre) < radius)
    {
      array->SetValue(triangle.cell, inside);
    }
  }
  mesh->GetCellData()->AddArray(array);
}

using GinzburgLandauCrossField = SolverTest<vtkGinzburgLandauCrossField>;

TEST_F(GinzburgLandauCrossField, Defaults)
{
  EXPECT_EQ(this->Filter->GetEpsilon(), 0.0);
  EXPECT_EQ(this->Filter->GetStart(), vtkGinzburgLandauCrossField::StartHarmonic);
  EXPECT_EQ(this->Filter->GetNormArrayName(), "");
  EXPECT_EQ(this->Filter->GetGradientWeightArrayName(), "");
  EXPECT_EQ(this->Filter->GetMaximumIterations(), 500);
  EXPECT_EQ(this->Filter->GetTolerance(), 1e-10);
}

TEST_F(GinzburgLandauCrossField, FollowsFilterConventions)
{
  this->Filter->SetInputData(Disk());
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->Filter->SetInputData(Disk()); },
    [this] { this->Filter->SetInputData(Ring()); });
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "Epsilon", "Start", "NormArrayName", "GradientWeightArrayName", "MaximumIterations",
      "Tolerance" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(GinzburgLandauCrossField, WritesTheFieldAndBothPartsOfItsEnergy)
{
  this->Filter->SetEpsilon(0.1);
  vtkUnstructuredGrid* output = this->Solve(Disk());
  for (const char* name : { "Representation", "Cross", "Cross2", "CrossNorm" })
  {
    FilterChecks::RequireArray(output->GetCellData(), name);
    FilterChecks::RequireArray(output->GetPointData(), name);
  }
  vtkDataArray* exact = FilterChecks::RequireArray(output->GetCellData(), "CrossFieldCR");
  ASSERT_EQ(exact->GetNumberOfComponents(), 6);

  // Both parts of the energy, computed from the exact field triangle by triangle.
  const MeshReading mesh(output);
  double gradient = 0.0;
  double penalty = 0.0;
  for (const MeshReading::Triangle& triangle : mesh.triangles)
  {
    double values[6];
    exact->GetTuple(triangle.cell, values);
    const Complex sides[3] = { { values[0], values[1] }, { values[2], values[3] },
      { values[4], values[5] } };
    for (std::size_t i = 0; i < 3; ++i)
    {
      penalty += triangle.area / 3.0 * std::pow(std::norm(sides[i]) - 1.0, 2) / (4.0 * 0.01);
      // The Crouzeix-Raviart element matrix is edge vector · edge vector / area.
      for (std::size_t j = 0; j < 3; ++j)
      {
        const auto along = [&](std::size_t k)
        {
          return mesh.points[static_cast<std::size_t>(triangle.points[(k + 1) % 3])] -
            mesh.points[static_cast<std::size_t>(triangle.points[k])];
        };
        gradient += 0.5 * std::real(std::conj(along(i)) * along(j)) / triangle.area *
          std::real(std::conj(sides[i]) * sides[j]);
      }
    }
  }
  EXPECT_NEAR(this->Value("GradientEnergy"), gradient, 1e-9 * gradient);
  EXPECT_NEAR(this->Value("PenaltyEnergy"), penalty, 1e-9 * penalty);
  EXPECT_NEAR(this->Value("Energy"), gradient + penalty, 1e-9 * gradient);
  EXPECT_EQ(this->Value("Epsilon"), 0.1);
  EXPECT_EQ(this->Value("Converged"), 1.0);
  EXPECT_LE(this->Value("Residual"), 1e-10);
  EXPECT_GT(this->Value("ConvexifiedSteps"), 0.0);
  EXPECT_EQ(this->Value("RequiredInteriorQuarters"), 4.0);
  EXPECT_EQ(this->Value("GivenInteriorQuarters"), 4.0);
  EXPECT_EQ(this->Value("Consistent"), 1.0);
  EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
  EXPECT_EQ(
    FilterChecks::RequireArray(output->GetFieldData(), "HoleDegree")->GetNumberOfTuples(), 0);
}

TEST_F(GinzburgLandauCrossField, EpsilonIsTheMeanEdgeLengthByDefault)
{
  this->Solve(Disk());
  EXPECT_GT(this->Value("Epsilon"), 0.6 * MeshSize);
  EXPECT_LT(this->Value("Epsilon"), 1.2 * MeshSize);
}

TEST_F(GinzburgLandauCrossField, ImprintedCirclesPrescribeNothing)
{
  this->Filter->SetEpsilon(0.05);
  vtkUnstructuredGrid* field = this->Solve(TestInputs::Drill(TestInputs::Loops({ Circle(60, 1.0) }),
    { { 0.42, 0.42, 1.0, 0.1 }, { -0.42, 0.42, 1.0, 0.1 }, { -0.42, -0.42, 1.0, 0.1 },
      { 0.42, -0.42, 1.0, 0.1 } },
    0.1, vtkDrillHoles::ModeImprint));
  EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
  EXPECT_EQ(this->Value("DegreesReached"), 1.0);
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputData(field);
  FilterChecks::UpdateWithoutError(check);
  vtkFieldData* found = check->GetOutput()->GetFieldData();
  for (const char* name : { "HoleDegree", "HoleDegreeReliable", "UnwantedSingularities" })
  {
    vtkDataArray* stated = FilterChecks::RequireArray(field->GetFieldData(), name);
    vtkDataArray* read = FilterChecks::RequireArray(found, name);
    ASSERT_EQ(read->GetNumberOfTuples(), stated->GetNumberOfTuples());
    for (vtkIdType i = 0; i < read->GetNumberOfTuples(); ++i)
    {
      EXPECT_EQ(read->GetTuple1(i), stated->GetTuple1(i)) << name;
      EXPECT_TRUE(name != std::string("HoleDegree") || read->GetTuple1(i) == 0.0) << "elsewhere";
    }
  }
  EXPECT_EQ(FilterChecks::RequireArray(found, "Consistent")->GetTuple1(0), 1.0);
}

TEST_F(GinzburgLandauCrossField, StartsLeadToDifferentMinimaOnARing)
{
  this->Filter->SetEpsilon(0.02);
  this->Solve(Ring());
  const double radial = this->Value("Energy");
  EXPECT_EQ(this->Value("UnwantedSingularities"), 0.0);
  this->Filter->SetStartToConstant();
  const auto broken = vtkSmartPointer<vtkUnstructuredGrid>::New();
  broken->DeepCopy(this->Solve(Ring()));
  const double energy = this->Value("Energy");
  EXPECT_GT(energy, 1.5 * radial);
  EXPECT_EQ(this->Value("UnwantedSingularities"), 8.0);
  EXPECT_EQ(this->Value("Consistent"), 1.0);

  // A minimum is a fixed point of the iteration.
  this->Filter->SetStartToGiven();
  this->Solve(broken);
  EXPECT_EQ(this->Value("Iterations"), 0.0);
  EXPECT_NEAR(this->Value("Energy"), energy, 1e-12 * energy);
  this->Filter->SetStartToZero();
  this->Solve(Ring());
  EXPECT_NEAR(this->Value("Energy"), radial, 1e-9 * radial);
}

TEST_F(GinzburgLandauCrossField, UsesPinningArrays)
{
  const auto mesh = vtkSmartPointer<vtkUnstructuredGrid>::New();
  mesh->DeepCopy(this->Solve(Disk()));
  const double plain = this->Value("Energy");
  AddCellArray(mesh, "One", 1.0, 1.0);
  AddCellArray(mesh, "Pin", 1.0, 0.05, Complex(0.3, 0.2), 0.2);
  this->Filter->SetStartToGiven();
  this->Filter->SetNormArrayName("One");
  this->Filter->SetGradientWeightArrayName("One");
  this->Solve(mesh);
  EXPECT_EQ(this->Value("Iterations"), 0.0);
  EXPECT_NEAR(this->Value("Energy"), plain, 1e-9 * plain);

  // Starting from the same field, a smaller weight can only reduce the energy.
  this->Filter->SetGradientWeightArrayName("Pin");
  this->Solve(mesh);
  EXPECT_LT(this->Value("Energy"), plain);
  this->Filter->SetGradientWeightArrayName("");
  this->Filter->SetNormArrayName("Pin");
  this->Solve(mesh);
  EXPECT_GT(this->Value("Iterations"), 0.0);
  EXPECT_GT(std::abs(this->Value("Energy") - plain), 0.01 * plain);
}

TEST_F(GinzburgLandauCrossField, WarnsWithoutConvergence)
{
  this->Filter->SetMaximumIterations(1);
  this->Filter->SetInputData(Disk());
  FilterChecks::MessageRecorder messages(this->Filter);
  this->Filter->Update();
  ResultFiles::Save(this->Filter);
  EXPECT_TRUE(messages.errors.empty());
  ASSERT_EQ(messages.warnings.size(), 1u);
  EXPECT_NE(messages.warnings[0].find("1 step"), std::string::npos) << messages.warnings[0];
  EXPECT_EQ(this->Filter->GetErrorCode(), vtkErrorCode::NoError);
  EXPECT_EQ(this->Value("Converged"), 0.0);
  EXPECT_EQ(this->Value("Iterations"), 1.0);
}

TEST_F(GinzburgLandauCrossField, MeasuresStages)
{
  this->Solve(Disk());
  for (int i = 0; i < 3; ++i)
  {
    EXPECT_GT(this->Filter->GetStageSeconds()[i], 0.0);
    EXPECT_LT(this->Filter->GetStageSeconds()[i], 60.0);
  }
}

TEST_F(GinzburgLandauCrossField, RejectsInvalidInput)
{
  this->Filter->SetInputData(TestInputs::DrilledDisk());
  FilterChecks::CaptureError(this->Filter, { "has holes", "without" });

  const auto mesh = Disk();
  AddCellArray(mesh, "Negative", -1.0, -1.0);
  AddCellArray(mesh, "Wild", std::numeric_limits<double>::infinity(), 1.0);
  this->Filter->SetInputData(mesh);
  this->Filter->SetNormArrayName("Missing");
  FilterChecks::CaptureError(this->Filter, { "no cell array 'Missing'" });
  this->Filter->SetNormArrayName("Negative");
  FilterChecks::CaptureError(this->Filter, { "norm", "negative" });
  this->Filter->SetNormArrayName("");
  this->Filter->SetGradientWeightArrayName("Negative");
  FilterChecks::CaptureError(this->Filter, { "weight", "not positive" });
  this->Filter->SetGradientWeightArrayName("Wild");
  FilterChecks::CaptureError(this->Filter, { "weight", "not finite" });
  this->Filter->SetGradientWeightArrayName("");
  this->Filter->SetStartToGiven();
  FilterChecks::CaptureError(this->Filter, { "CrossFieldCR" });

  this->Filter->SetStartToHarmonic();
  mesh->GetCellData()->RemoveArray("BoundaryKind");
  mesh->Modified();
  FilterChecks::CaptureError(this->Filter, { "BoundaryKind" });
}
}
