// Periodic sides: field data, motions in space, order 2, errors.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkQuadMeshWriter.h"
#include "vtkQuadMesher.h"
#include "vtkQuadsToHigherOrder.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTransform.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace
{
/** Returns a sector of a ring, whose straight sides are outer sides 1 and 3 in some order. */
vtkSmartPointer<vtkPolyData> Sector(double angle)
{
  std::vector<std::array<double, 2>> loop;
  constexpr int Count = 16;
  for (const double radius : { 1.0, 2.0 })
  {
    for (int i = 0; i <= Count; ++i)
    {
      const double part = static_cast<double>(radius == 1.0 ? Count - i : i) / Count;
      loop.push_back(
        { radius * std::cos(0.2 + angle * part), radius * std::sin(0.2 + angle * part) });
    }
  }
  return TestInputs::Loops({ loop });
}

class QuadMesherPeriodic : public testing::Test
{
protected:
  vtkFieldData* Report() { return this->Filter->GetOutputDataObject(8)->GetFieldData(); }

  /** Returns the points of the lines of a side. */
  static std::set<vtkIdType> PointsOf(vtkUnstructuredGrid* mesh, const std::string& side)
  {
    auto* sides = vtkStringArray::SafeDownCast(mesh->GetCellData()->GetAbstractArray("Side"));
    std::set<vtkIdType> points;
    vtkNew<vtkIdList> ids;
    for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
    {
      if (sides->GetValue(cell) == side)
      {
        mesh->GetCellPoints(cell, ids);
        points.insert(ids->begin(), ids->end());
      }
    }
    return points;
  }

  /** Expects that the motion of the field data takes all points of the first side to the second. */
  static void ExpectMatch(vtkUnstructuredGrid* mesh, vtkIdType pair = 0)
  {
    auto* sides =
      vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("PeriodicSides"));
    ASSERT_NE(sides, nullptr);
    vtkDataArray* motions = FilterChecks::RequireArray(mesh->GetFieldData(), "PeriodicMotion");
    vtkNew<vtkMatrix4x4> matrix;
    for (int i = 0; i < 16; ++i)
    {
      matrix->SetElement(i / 4, i % 4, motions->GetComponent(pair, i));
    }
    const std::set<vtkIdType> first = PointsOf(mesh, sides->GetValue(2 * pair));
    const std::set<vtkIdType> second = PointsOf(mesh, sides->GetValue(2 * pair + 1));
    ASSERT_GT(first.size(), 2U);
    ASSERT_EQ(first.size(), second.size());
    const double extent = mesh->GetLength();
    for (const vtkIdType point : first)
    {
      double place[4] = { 0.0, 0.0, 0.0, 1.0 };
      mesh->GetPoint(point, place);
      matrix->MultiplyPoint(place, place);
      double distance = extent;
      for (const vtkIdType other : second)
      {
        double image[3];
        mesh->GetPoint(other, image);
        distance = std::min(
          distance, std::hypot(image[0] - place[0], image[1] - place[1], image[2] - place[2]));
      }
      EXPECT_LE(distance, 1e-12 * extent);
    }
  }

  vtkNew<vtkQuadMesher> Filter;
};
}

TEST_F(QuadMesherPeriodic, MotionsAreThoseOfSpaceInAnyPlane)
{
  for (const bool isTilted : { false, true })
  {
    vtkNew<vtkTransform> place;
    place->Translate(3.0, -1.0, 0.5);
    place->RotateWXYZ(isTilted ? 50.0 : 0.0, 1.0, 2.0, 0.5);
    vtkSmartPointer<vtkPolyData> sector = Sector(0.8);
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    place->TransformPoints(sector->GetPoints(), points);
    sector->SetPoints(points);
    this->Filter->SetInputData(sector);
    this->Filter->SetQuadCount(120);
    // The sides between the arcs are the second and fourth of one order or the first and third.
    this->Filter->SetPeriodic("");
    FilterChecks::UpdateWithoutError(this->Filter);
    auto* names = vtkStringArray::SafeDownCast(this->Report()->GetAbstractArray("SideNames"));
    vtkDataArray* lengths = FilterChecks::RequireArray(this->Report(), "SideLengths");
    std::string pair;
    for (vtkIdType i = 0; i < names->GetNumberOfValues(); ++i)
    {
      if (std::abs(lengths->GetTuple1(i) - 1.0) < 1e-6)
      {
        pair += (pair.empty() ? "" : ":") + names->GetValue(i);
      }
    }
    this->Filter->SetPeriodic(pair);
    FilterChecks::UpdateWithoutError(this->Filter);
    vtkNew<vtkUnstructuredGrid> mesh;
    this->Filter->CopyMesh(mesh);
    ExpectMatch(mesh);
    auto* kinds =
      vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("PeriodicKind"));
    ASSERT_NE(kinds, nullptr);
    EXPECT_EQ(kinds->GetValue(0), "rotation");
    vtkFieldData* data = mesh->GetFieldData();
    EXPECT_NEAR(
      std::abs(FilterChecks::RequireArray(data, "PeriodicAngle")->GetTuple1(0)), 0.8, 1e-12);
    vtkDataArray* centre = FilterChecks::RequireArray(data, "PeriodicCentre");
    const double origin[3] = { 3.0, -1.0, 0.5 };
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_NEAR(centre->GetComponent(0, i), origin[i], 1e-11);
    }
    // joined and of order 2, as in ParaView
    vtkNew<vtkQuadsToHigherOrder> raiser;
    raiser->SetInputConnection(0, this->Filter->GetOutputPort(0));
    raiser->SetInputConnection(1, this->Filter->GetOutputPort(5));
    FilterChecks::UpdateWithoutError(raiser);
    ExpectMatch(vtkUnstructuredGrid::SafeDownCast(raiser->GetOutputDataObject(0)));
    vtkNew<vtkQuadMeshWriter> writer;
    writer->SetInputConnection(raiser->GetOutputPort());
    writer->SetFileName("a.msh");
    writer->WriteToOutputStringOn();
    ASSERT_EQ(writer->Write(), 1);
    EXPECT_NE(writer->GetOutputFiles().at(0).second.find("$Periodic\n1\n1 "), std::string::npos);
  }
}

TEST_F(QuadMesherPeriodic, FieldDataOfAnEarlierMeshAreRemoved)
{
  this->Filter->SetInputData(
    TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 2.0, 1.0 }) }));
  this->Filter->SetQuadSize(0.25);
  this->Filter->SetPeriodic("outer3:outer1; outer0:outer2");
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkNew<vtkUnstructuredGrid> mesh;
  this->Filter->CopyMesh(mesh);
  ExpectMatch(mesh, 0);
  ExpectMatch(mesh, 1);
  vtkNew<vtkQuadMesher> again; // the lines and quads of the first mesh are the domain
  again->SetInputData(mesh);
  again->SetQuadSize(0.25);
  FilterChecks::UpdateWithoutError(again);
  for (const int port : { 5, 8 })
  {
    EXPECT_EQ(
      again->GetOutputDataObject(port)->GetFieldData()->GetAbstractArray("PeriodicSides"), nullptr);
  }
}

TEST_F(QuadMesherPeriodic, PairsThatAreNotOfTheirFormAreRefused)
{
  this->Filter->SetInputData(
    TestInputs::Loops({ TestInputs::Rectangle({ 0.0, 0.0 }, { 2.0, 1.0 }) }));
  for (const auto& [pairs, reason] : std::map<std::string, std::string>{
         { "outer0", "has no colon between a name and a value; give A:B" },
         { "outer0:", "has no colon between a name and a value; give A:B" },
         { "outer0:outer1", "are not images of each other" },
         { "outer0:wall", "has no side 'wall' for a periodic pair" } })
  {
    this->Filter->SetPeriodic(pairs);
    FilterChecks::CaptureError(this->Filter, { reason });
  }
  EXPECT_EQ(this->Filter->GetPeriodic(), "outer0:wall");
}
