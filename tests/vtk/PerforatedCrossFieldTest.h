#ifndef PerforatedCrossFieldTest_h
#define PerforatedCrossFieldTest_h

#include "FilterChecks.h"
#include "vtkPerforatedCrossField.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

/** What the files of tests of vtkPerforatedCrossField share. */
class PerforatedCrossField : public testing::Test
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

  vtkNew<vtkPerforatedCrossField> Filter;
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
