/** The property Arrays: the arrays it selects, and that other filters need the exact ones only. */
#include "support/FilterChecks.h"
#include "support/PerforatedCrossFieldTest.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldArraySets.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkHField.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace
{
using Names = std::set<std::string>;

/** Returns the names of the arrays that are computed from others. */
Names Derived(vtkFieldData* data)
{
  Names found;
  for (const char* name : { "Representation", "Cross", "Cross2", "CrossNorm", "SizeMap" })
  {
    if (data->HasArray(name) != 0)
    {
      found.insert(name);
    }
  }
  return found;
}

/** Returns the output of a filter with a selection of arrays. */
template <class Filter>
vtkSmartPointer<vtkUnstructuredGrid> Solve(vtkUnstructuredGrid* mesh, int arrays)
{
  vtkNew<Filter> filter;
  filter->SetArrays(arrays);
  filter->SetInputData(mesh);
  FilterChecks::UpdateWithoutError(filter);
  return filter->GetOutput();
}

const Names OnCells[] = { {}, { "Cross", "CrossNorm" },
  { "Cross", "Cross2", "CrossNorm", "Representation" } };

void ExpectSame(vtkDataArray* found, vtkDataArray* expected)
{
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->GetDataType(), VTK_DOUBLE);
  ASSERT_EQ(found->GetNumberOfValues(), expected->GetNumberOfValues());
  for (vtkIdType i = 0; i < found->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < found->GetNumberOfComponents(); ++j)
    {
      ASSERT_EQ(found->GetComponent(i, j), expected->GetComponent(i, j));
    }
  }
}
}

TEST(FieldArrays, SolverWritesSelectedArrays)
{
  const auto mesh = TestInputs::DrilledDisk();
  EXPECT_EQ(vtkNew<vtkPerforatedCrossField>()->GetArrays(), vtkCrossFieldArraySets::All);
  const auto all = Solve<vtkPerforatedCrossField>(mesh, vtkCrossFieldArraySets::All);
  for (int arrays = vtkCrossFieldArraySets::Exact; arrays <= vtkCrossFieldArraySets::All; ++arrays)
  {
    const auto field = Solve<vtkPerforatedCrossField>(mesh, arrays);
    EXPECT_EQ(Derived(field->GetCellData()), OnCells[arrays]);
    EXPECT_EQ(Derived(field->GetPointData()), OnCells[arrays]);
    ExpectSame(
      field->GetCellData()->GetArray("CrossFieldCR"), all->GetCellData()->GetArray("CrossFieldCR"));
    for (const std::string& name : OnCells[arrays])
    {
      EXPECT_EQ(field->GetCellData()->GetArray(name.c_str())->GetDataType(), VTK_FLOAT) << name;
      EXPECT_EQ(field->GetPointData()->GetArray(name.c_str())->GetDataType(), VTK_FLOAT) << name;
    }
  }
}

TEST(FieldArrays, HFieldWritesSelectedArrays)
{
  const auto mesh = TestInputs::DrilledDisk();
  const auto all = Solve<vtkHField>(mesh, vtkCrossFieldArraySets::All);
  for (int arrays = vtkCrossFieldArraySets::Exact; arrays <= vtkCrossFieldArraySets::All; ++arrays)
  {
    const auto field = Solve<vtkHField>(mesh, arrays);
    Names onPoints = OnCells[arrays];
    if (arrays > vtkCrossFieldArraySets::Exact)
    {
      onPoints.insert("SizeMap");
    }
    EXPECT_EQ(Derived(field->GetCellData()), OnCells[arrays]);
    EXPECT_EQ(Derived(field->GetPointData()), onPoints);
    ExpectSame(field->GetPointData()->GetArray("H"), all->GetPointData()->GetArray("H"));
  }
}

TEST(FieldArrays, RemovesArraysOfEarlierFields)
{
  const auto all = Solve<vtkHField>(TestInputs::DrilledDisk(), vtkCrossFieldArraySets::All);
  const auto exact = Solve<vtkHField>(all, vtkCrossFieldArraySets::Exact);
  EXPECT_EQ(Derived(exact->GetCellData()), Names());
  EXPECT_EQ(Derived(exact->GetPointData()), Names());
  EXPECT_EQ(Derived(all->GetPointData()).size(), 5) << "the input is left as it was";
}

TEST(FieldArrays, SingularitiesNeedTheExactFieldOnly)
{
  const auto mesh = TestInputs::DrilledDisk();
  vtkNew<vtkCrossFieldSingularities> found[2];
  for (int i = 0; i < 2; ++i)
  {
    found[i]->IncludeHolesOn();
    found[i]->SetInputData(Solve<vtkPerforatedCrossField>(
      mesh, i == 0 ? vtkCrossFieldArraySets::Exact : vtkCrossFieldArraySets::All));
    FilterChecks::UpdateWithoutError(found[i]);
  }
  EXPECT_EQ(found[0]->GetOutput()->GetNumberOfPoints(), 4);
  EXPECT_EQ(found[1]->GetOutput()->GetNumberOfPoints(), 4);
}
