#ifndef SolverTest_h
#define SolverTest_h

#include "FilterChecks.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

/** Fixture of the tests of filters that solve for a field. */
template <class Solver>
class SolverTest : public testing::Test
{
public:
  vtkUnstructuredGrid* Solve(vtkUnstructuredGrid* mesh)
  {
    this->Filter->SetInputData(mesh);
    FilterChecks::UpdateWithoutError(this->Filter);
    return this->Filter->GetOutput();
  }

  double Value(const char* name)
  {
    vtkDataArray* array =
      FilterChecks::RequireArray(this->Filter->GetOutput()->GetFieldData(), name);
    EXPECT_EQ(array->GetNumberOfValues(), 1) << name;
    return array->GetComponent(0, 0);
  }

  vtkNew<Solver> Filter;
};

#endif
