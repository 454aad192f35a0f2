// Lines inside of the domain and nodes at positions in vtkQuadMesher and the filters before it.

#include "support/FilterChecks.h"
#include "vtkBoundarySimplifier.h"
#include "vtkPoincareHopfCheck.h"
#include "vtkQuadMesher.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace
{
/** Returns a square [−1, 1]² in the plane x = 5, with a line `crack` from the middle of a side to its centre. */
vtkSmartPointer<vtkPolyData> SquareWithCrack()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double places[][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 }, { -1, 0 }, { 0, 0 } };
  for (const auto& place : places)
  {
    points->InsertNextPoint(5.0, place[0], place[1]);
  }
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkStringArray> names;
  names->SetName("Side");
  for (vtkIdType i = 0; i < 4; ++i)
  {
    lines->InsertNextCell({ i, (i + 1) % 4 });
    names->InsertNextValue(i == 0 ? "bottom" : "");
  }
  lines->InsertNextCell({ 4, 5 });
  names->InsertNextValue("crack");
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetLines(lines);
  data->GetCellData()->AddArray(names);
  return data;
}

void ExpectError(vtkQuadMesher* mesher, const std::string& words)
{
  const FilterChecks::MessageRecorder messages(mesher);
  mesher->Update();
  ASSERT_EQ(messages.errors.size(), 1U);
  EXPECT_NE(messages.errors[0].find(words), std::string::npos) << messages.errors[0];
  EXPECT_NE(mesher->GetErrorCode(), 0U);
  EXPECT_TRUE(FilterChecks::IsEmpty(mesher->GetOutput()));
}

std::map<std::string, int> EdgesOfSides(vtkQuadMesher* mesher)
{
  auto* sides =
    vtkStringArray::SafeDownCast(vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(5))
                                   ->GetCellData()
                                   ->GetAbstractArray("Side"));
  std::map<std::string, int> edges;
  for (vtkIdType i = 0; sides != nullptr && i < sides->GetNumberOfValues(); ++i)
  {
    ++edges[sides->GetValue(i)];
  }
  return edges;
}

TEST(QuadMesherLines, AreWeldedOrOpen)
{
  const auto domain = SquareWithCrack();
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(domain);
  mesher->SetQuadCount(400);
  mesher->SetLines("crack");
  FilterChecks::UpdateWithoutError(mesher.Get());
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfPoints(), 441);
  EXPECT_EQ(EdgesOfSides(mesher)["crack"], 10);
  mesher->SetLines("");
  mesher->SetOpenLines("crack");
  FilterChecks::UpdateWithoutError(mesher.Get());
  EXPECT_EQ(mesher->GetOutput()->GetNumberOfPoints(), 451);
  EXPECT_EQ(EdgesOfSides(mesher)["crack.left"], 10);
  EXPECT_EQ(EdgesOfSides(mesher)["crack.right"], 10);
  EXPECT_EQ(EdgesOfSides(mesher)["bottom"], 20);
  EXPECT_EQ(domain->GetNumberOfCells(), 5);
}

TEST(QuadMesherLines, NodesAreAtPositions)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(SquareWithCrack());
  mesher->SetQuadCount(400);
  mesher->SetLines("crack");
  mesher->AddNode(5.0, 0.33, 0.41);
  FilterChecks::UpdateWithoutError(mesher.Get());
  double nearest = 1.0;
  for (vtkIdType i = 0; i < mesher->GetOutput()->GetNumberOfPoints(); ++i)
  {
    const double* const place = mesher->GetOutput()->GetPoint(i);
    nearest = std::min(nearest, std::hypot(place[1] - 0.33, place[2] - 0.41));
  }
  EXPECT_LT(nearest, 1e-12);
  mesher->ClearNodes();
  mesher->AddNode(0.0, 0.33, 0.41); // not in the plane
  ExpectError(mesher, "The position of a node");
}

TEST(QuadMesherLines, PassTheFiltersBefore)
{
  vtkNew<vtkBoundarySimplifier> simplifier;
  simplifier->SetInputData(SquareWithCrack());
  simplifier->SetLines("crack");
  FilterChecks::UpdateWithoutError(simplifier.Get());
  vtkNew<vtkPoincareHopfCheck> check;
  check->SetInputConnection(simplifier->GetOutputPort());
  check->SetLines("crack");
  FilterChecks::UpdateWithoutError(check.Get());
  EXPECT_EQ(check->GetOutput()->GetFieldData()->GetArray("Consistent")->GetTuple1(0), 1.0);
}

TEST(QuadMesherLines, UnknownNamesAreErrors)
{
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputData(SquareWithCrack());
  mesher->SetLines("weld");
  ExpectError(mesher, "No line of the domain has the name 'weld'");
  mesher->SetLines("crack");
  mesher->SetOpenLines("weld");
  ExpectError(mesher, "There is no line or interface 'weld' to open");
}
}
