#ifndef DiskTest_h
#define DiskTest_h

#include "FilterChecks.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

/** Test of a filter with four singularities on the unit disk, the defaults of the sources. */
template <class Algorithm>
class DiskTest : public testing::Test
{
public:
  void SetUp() override
  {
    this->Domain->SetEdgeLength(0.1);
    this->Filter->SetInputConnection(this->Domain->GetOutputPort());
    this->Filter->SetSingularitiesConnection(this->Singularities->GetOutputPort());
    this->Filter->SetMeshSize(0.1);
  }

  double Value(const char* name)
  {
    return FilterChecks::RequireArray(this->Filter->GetOutput()->GetFieldData(), name)
      ->GetComponent(0, 0);
  }

  vtkNew<vtkPlanarDomainSource> Domain;
  vtkNew<vtkSingularitySource> Singularities;
  vtkNew<Algorithm> Filter;
};

#endif
