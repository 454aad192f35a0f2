#include "support/DiskTest.h"
#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldMap.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using CrossFieldMap = DiskTest<vtkCrossFieldMap>;
}

TEST_F(CrossFieldMap, FollowsFilterConventions)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(
    this->Filter, { "MeshSize", "CapCorners", "RepairHolonomy", "StageSeconds" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(CrossFieldMap, HasTheAreaOfTheDomainAndIsCutAtSingularities)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkUnstructuredGrid* map = this->Filter->GetOutput();
  vtkDataArray* uv = FilterChecks::RequireArray(map->GetPointData(), "UV");
  ASSERT_EQ(uv->GetNumberOfComponents(), 2);
  double mapped = 0.0;
  double area = 0.0;
  for (vtkIdType cell = 0; cell < map->GetNumberOfCells(); ++cell)
  {
    if (map->GetCellType(cell) != VTK_TRIANGLE)
    {
      continue;
    }
    vtkNew<vtkIdList> ids;
    map->GetCellPoints(cell, ids);
    const auto twice = [&ids](const auto& at)
    {
      const std::array<double, 2> a = at(ids->GetId(0));
      const std::array<double, 2> b = at(ids->GetId(1));
      const std::array<double, 2> c = at(ids->GetId(2));
      return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    };
    const double inMap = twice(
      [uv](vtkIdType i) {
        return std::array<double, 2>{ uv->GetComponent(i, 0), uv->GetComponent(i, 1) };
      });
    EXPECT_GT(inMap, 0.0);
    mapped += 0.5 * inMap;
    area += 0.5 *
      twice(
        [map](vtkIdType i) {
          return std::array<double, 2>{ map->GetPoint(i)[0], map->GetPoint(i)[1] };
        });
  }
  EXPECT_NEAR(mapped, area, 1e-10 * area);
  vtkDataArray* quarters = FilterChecks::RequireArray(map->GetPointData(), "QuarterIndex");
  double sum = 0.0;
  for (vtkIdType i = 0; i < quarters->GetNumberOfTuples(); ++i)
  {
    sum += quarters->GetTuple1(i); // points at the ends of seams are not duplicated
  }
  EXPECT_EQ(sum, 4.0);
}

TEST_F(CrossFieldMap, RepairsTheHolonomy)
{
  this->Domain->SetDomainName("ring");
  this->Filter->SetSingularitiesData(
    TestInputs::Singularities({ { 0.7, 0.1, 1, 0.1 }, { 0.5, -0.1, -1, 0.1 } }));
  this->Filter->RepairHolonomyOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkFieldData* field = this->Filter->GetOutput()->GetFieldData();
  EXPECT_GT(std::abs(FilterChecks::RequireArray(field, "DefectBefore")->GetTuple1(0)), 0.1);
  EXPECT_LT(std::abs(FilterChecks::RequireArray(field, "HolonomyDefect")->GetTuple1(0)), 0.01);
  vtkDataArray* places = FilterChecks::RequireArray(field, "RepairedPositions");
  ASSERT_EQ(places->GetNumberOfTuples(), 2);
  const double moved =
    std::max(std::hypot(places->GetComponent(0, 0) - 0.7, places->GetComponent(0, 1) - 0.1),
      std::hypot(places->GetComponent(1, 0) - 0.5, places->GetComponent(1, 1) + 0.1));
  EXPECT_NEAR(FilterChecks::RequireArray(field, "RepairDistance")->GetTuple1(0), moved, 1e-14);
  this->Filter->SetInputData(TestInputs::DrilledDisk());
  FilterChecks::CaptureError(this->Filter, { "cannot be moved to repair", "give the domain" });
}
