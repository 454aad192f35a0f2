// Data sets from damaged files or incorrect scripts are refused with one sentence, for every kind
// of input.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkBoundarySimplifier.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossGlyphs.h"
#include "vtkDrillHoles.h"
#include "vtkPerforatedCrossField.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkErrorCode.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

namespace
{
using FilterChecks::CaptureError;

vtkSmartPointer<vtkIdTypeArray> Ids(const std::vector<vtkIdType>& values)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  for (const vtkIdType value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/** Returns the corners of a square with cells of one type, given by offsets and point ids. */
vtkSmartPointer<vtkUnstructuredGrid> Grid(
  int type, const std::vector<vtkIdType>& offsets, const std::vector<vtkIdType>& ids)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(
    TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }) })->GetPoints());
  vtkNew<vtkCellArray> cells;
  cells->SetData(Ids(offsets), Ids(ids));
  grid->SetCells(type, cells);
  return grid;
}

void ExpectDamaged(vtkDataSet* domain, const std::string& part)
{
  vtkNew<vtkDrillHoles> filter;
  filter->SetInputData(domain);
  filter->SetSingularitiesData(TestInputs::Singularities({ { 1.0, 1.0, 1.0, 0.2 } }));
  EXPECT_EQ(CaptureError(filter, { part, "damaged" }), vtkErrorCode::UserError);
  // The simplifier loops over the cells before it reads a domain.
  vtkNew<vtkBoundarySimplifier> simplifier;
  simplifier->SetInputData(domain);
  EXPECT_EQ(CaptureError(simplifier, { part, "damaged" }), vtkErrorCode::UserError);
}

TEST(DamagedInput, RejectsInvalidCellOffsets)
{
  // Offsets that decrease, exceed the list, or end before it.
  ExpectDamaged(Grid(VTK_TRIANGLE, { 0, 3, 1, 6 }, { 0, 1, 2, 0, 2, 3 }), "list of cells");
  ExpectDamaged(Grid(VTK_TRIANGLE, { 0, 3, 600 }, { 0, 1, 2, 0, 2, 3 }), "list of cells");
  ExpectDamaged(Grid(VTK_TRIANGLE, { 0, 3 }, { 0, 1, 2, 0, 2, 3 }), "list of cells");

  auto loop = TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }) });
  vtkNew<vtkCellArray> lines;
  lines->SetData(Ids({ 0, 500 }), Ids({ 0, 1, 2, 3, 0 }));
  loop->SetLines(lines);
  ExpectDamaged(loop, "list of cells");
}

TEST(DamagedInput, RejectsInvalidPointIds)
{
  ExpectDamaged(Grid(VTK_TRIANGLE, { 0, 3, 6 }, { 0, 1, 2, 0, 2, 4 }), "Cell 1 uses point 4 of 4");
  ExpectDamaged(Grid(VTK_TRIANGLE, { 0, 3, 6 }, { 0, -1, 2, 0, 2, 3 }), "Cell 0 uses point -1");
  ExpectDamaged(
    Grid(VTK_TRIANGLE, { 0, 3, 5 }, { 0, 1, 2, 0, 2 }), "Cell 1 has 2 points instead of 3");
  ExpectDamaged(Grid(VTK_PIXEL, { 0, 2 }, { 0, 1 }), "2 points instead of 4");
  ExpectDamaged(Grid(VTK_LINE, { 0, 1, 3 }, { 0, 1, 2 }), "Cell 0 has 1 points instead of 2");
}

TEST(DamagedInput, RejectsUnknownCellTypes)
{
  vtkNew<vtkDrillHoles> filter;
  filter->SetInputData(Grid(200, { 0, 3 }, { 0, 1, 2 }));
  filter->SetSingularitiesData(TestInputs::Singularities({ { 1.0, 1.0, 1.0, 0.2 } }));
  EXPECT_EQ(CaptureError(filter, { "cells of type" }), vtkErrorCode::UserError);
}

TEST(DamagedInput, RejectsShortArrays)
{
  vtkSmartPointer<vtkUnstructuredGrid> mesh = TestInputs::DrilledDisk(0.4);
  mesh->GetCellData()->GetArray(vtkCrossFieldArrayNames::BoundaryKind)->SetNumberOfTuples(5);
  vtkNew<vtkPerforatedCrossField> solver;
  solver->SetInputData(mesh);
  EXPECT_EQ(
    CaptureError(solver, { "'BoundaryKind' has 5 entries", "damaged" }), vtkErrorCode::UserError);

  vtkNew<vtkCrossGlyphs> glyphs;
  glyphs->SetInputData(mesh);
  EXPECT_EQ(CaptureError(glyphs, { "'BoundaryKind' has 5 entries" }), vtkErrorCode::UserError);

  auto singularities =
    TestInputs::Singularities({ { 1.0, 1.0, 1.0, 0.2 }, { 3.0, 3.0, 1.0, 0.2 } });
  singularities->GetPointData()
    ->GetArray(vtkCrossFieldArrayNames::QuarterIndex)
    ->SetNumberOfTuples(1);
  vtkNew<vtkDrillHoles> filter;
  filter->SetInputData(TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 4.0, 4.0 }) }));
  filter->SetSingularitiesData(singularities);
  EXPECT_EQ(
    CaptureError(filter, { "'QuarterIndex' has 1 entries for 2 points" }), vtkErrorCode::UserError);
}
}
