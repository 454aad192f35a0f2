// Filters that do not choose singularities refuse a missing connection in one sentence.

#include "support/FilterChecks.h"
#include "vtkDrillHoles.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularityEnergy.h"
#include "vtkSingularityOptimizer.h"
#include "vtkSingularitySource.h"

#include "vtkErrorCode.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <string>

namespace
{
template <class Filter>
void ExpectRefusal(const std::string& input)
{
  vtkNew<vtkPlanarDomainSource> domain;
  domain->SetEdgeLength(0.2);
  vtkNew<Filter> filter;
  filter->SetInputConnection(domain->GetOutputPort());
  filter->SetMeshSize(0.2);
  EXPECT_EQ(FilterChecks::CaptureError(
              filter, { "The input " + input + " has no connection", "a Singularity Source" }),
    vtkErrorCode::UserError);
  vtkNew<vtkSingularitySource> four;
  filter->AddInputConnection(1, four->GetOutputPort());
  FilterChecks::UpdateWithoutError(filter);
  filter->RemoveAllInputConnections(1);
  FilterChecks::CaptureError(filter, { input });
}
}

TEST(MissingInput, OfDrillHolesIsNamed)
{
  ExpectRefusal<vtkDrillHoles>("Singularities");
}

TEST(MissingInput, OfSingularityOptimizerIsNamed)
{
  ExpectRefusal<vtkSingularityOptimizer>("Singularities");
}

TEST(MissingInput, OfSingularityEnergyIsNamed)
{
  ExpectRefusal<vtkSingularityEnergy>("Configurations");
}
