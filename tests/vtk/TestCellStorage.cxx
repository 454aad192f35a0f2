// Cells are read from lists with ids of 32 bits as well, which readers and other filters make.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkHField.h"
#include "vtkPerforatedCrossField.h"

#include "vtkCellArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

namespace
{
/** Expects the same bytes from an input and from a copy of it with ids of 32 bits. */
template <class DataSet>
void CheckStorage(vtkAlgorithm* filter, DataSet* input, vtkCellArray* (*cells)(DataSet*))
{
  ASSERT_TRUE(cells(input)->IsStorage64Bit());
  filter->SetInputDataObject(0, input);
  FilterChecks::UpdateWithoutError(filter);
  const std::string expected = FilterChecks::Fingerprint(FilterChecks::Output(filter));
  vtkNew<DataSet> copy;
  copy->DeepCopy(input);
  ASSERT_TRUE(cells(copy)->ConvertTo32BitStorage());
  filter->SetInputDataObject(0, copy);
  FilterChecks::UpdateWithoutError(filter);
  EXPECT_EQ(FilterChecks::Fingerprint(FilterChecks::Output(filter)), expected);
  EXPECT_FALSE(cells(copy)->IsStorage64Bit());
}

TEST(CellStorage, DrilledMesh)
{
  vtkNew<vtkPerforatedCrossField> filter;
  CheckStorage<vtkUnstructuredGrid>(
    filter, TestInputs::DrilledDisk(), [](vtkUnstructuredGrid* grid) { return grid->GetCells(); });
}

TEST(CellStorage, Surface)
{
  vtkNew<vtkHField> filter;
  CheckStorage<vtkPolyData>(
    filter, TestInputs::FrameMesh(), [](vtkPolyData* surface) { return surface->GetPolys(); });
}

TEST(CellStorage, Lines)
{
  vtkNew<vtkHField> filter;
  CheckStorage<vtkPolyData>(filter,
    TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 3.0, 2.0 }) }),
    [](vtkPolyData* loops) { return loops->GetLines(); });
}
}
