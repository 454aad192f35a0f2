// Invalid input in planes of space.

#include "support/PlanesTest.h"
#include "vtkBoundaryCornerClassifier.h"

#include <gtest/gtest.h>

namespace
{
using namespace PlanesTest;

TEST(PlanesRefusals, SingularityOffThePlane)
{
  Pipeline pipeline(Tilt({ 0.3, -0.4, 0.8 }));
  pipeline.Drill->SetSingularitiesData(Pair());
  FilterChecks::CaptureError(pipeline.Drill, { "The singularity 1 at (1, 3, 0)", "off the plane" });
  pipeline.Drill->SetSingularitiesData(pipeline.Singularities);
  FilterChecks::UpdateWithoutError(pipeline.Drill);
}

TEST(PlanesRefusals, CornerOffThePlane)
{
  Pipeline pipeline(Tilt({ 0.3, -0.4, 0.8 }));
  vtkNew<vtkBoundaryCornerClassifier> corners;
  corners->SetInputData(LShape()); // in the plane z = 0
  pipeline.Solver->SetCornersConnection(corners->GetOutputPort());
  FilterChecks::CaptureError(pipeline.Solver, { "The corner ", "off the plane" });
}

TEST(PlanesRefusals, SurfaceThatBulgesFromAPlanarBoundary)
{
  auto mesh = TestInputs::FrameMesh();
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputData(mesh);
  drill->SetSingularitiesData(TestInputs::Singularities({}));
  FilterChecks::UpdateWithoutError(drill);
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    const bool isInner = point[0] == 1.0 && point[1] == 1.0; // not on a loop
    mesh->GetPoints()->SetPoint(i, point[0], point[1], isInner ? 0.5 : 0.0);
  }
  mesh->Modified();
  FilterChecks::CaptureError(drill, { "not planar" });
}
}
