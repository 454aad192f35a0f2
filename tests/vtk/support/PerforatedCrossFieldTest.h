#ifndef PerforatedCrossFieldTest_h
#define PerforatedCrossFieldTest_h

#include "SolverTest.h"
#include "vtkPerforatedCrossField.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <gtest/gtest.h>

/** Fixture of the tests of vtkPerforatedCrossField. */
class PerforatedCrossField : public SolverTest<vtkPerforatedCrossField>
{
public:
  /** Solves by the constrained method, whose field may have unwanted singularities. */
  vtkUnstructuredGrid* SolveConstrained(vtkUnstructuredGrid* mesh)
  {
    this->Filter->SetMethodToConstrained();
    this->Filter->SetInputData(mesh);
    FilterChecks::MessageRecorder messages(this->Filter);
    this->Filter->Update();
    EXPECT_TRUE(messages.errors.empty());
    EXPECT_EQ(messages.warnings.empty(), this->Value("UnwantedSingularities") == 0.0);
    return this->Filter->GetOutput();
  }
};

inline void ExpectArray(
  vtkFieldData* data, const char* name, int type, int components, vtkIdType tuples)
{
  vtkDataArray* array = data->GetArray(name);
  ASSERT_NE(array, nullptr) << name;
  EXPECT_EQ(array->GetDataType(), type) << name;
  EXPECT_EQ(array->GetNumberOfComponents(), components) << name;
  EXPECT_EQ(array->GetNumberOfTuples(), tuples) << name;
}

#endif
