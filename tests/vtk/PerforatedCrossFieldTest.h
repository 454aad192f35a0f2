#ifndef PerforatedCrossFieldTest_h
#define PerforatedCrossFieldTest_h

#include "SolverTest.h"
#include "vtkPerforatedCrossField.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"

#include <gtest/gtest.h>

/** What the files of tests of vtkPerforatedCrossField share. */
class PerforatedCrossField : public SolverTest<vtkPerforatedCrossField>
{
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
