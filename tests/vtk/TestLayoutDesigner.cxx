#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkCrossFieldMap.h"
#include "vtkHField.h"
#include "vtkLayoutDesigner.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSeparatrices.h"
#include "vtkSingularitySource.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace
{
class LayoutDesigner : public testing::Test
{
public:
  void SetUp() override
  {
    this->Domain->SetEdgeLength(0.1);
    this->Filter->SetInputConnection(this->Domain->GetOutputPort());
    this->Filter->SetMeshSize(0.1);
    this->Filter->SetQuadSize(0.1);
  }

  void SetFour(double radius = 0.6)
  {
    for (int i = 0; i < 4; ++i)
    {
      const double angle = 0.25 * 3.14159265358979 * (2 * i + 1);
      this->Filter->SetSingularity(i, radius * std::cos(angle), radius * std::sin(angle), 1, 0.1);
    }
  }

  double Value(const char* name)
  {
    return FilterChecks::RequireArray(this->Filter->GetOutput()->GetFieldData(), name)
      ->GetComponent(0, 0);
  }

  std::string Text(const char* name)
  {
    auto* text = vtkStringArray::SafeDownCast(
      this->Filter->GetOutput()->GetFieldData()->GetAbstractArray(name));
    return text == nullptr ? std::string() : std::string(text->GetValue(0));
  }

  std::string ReasonOf(vtkIdType row) { return this->Filter->GetReasons()->GetValue(row); }

  std::string TextInView(bool isAlarm)
  {
    const auto [text, alarm] = FilterChecks::TextForView(this->Filter, 4, "Summary");
    EXPECT_EQ(alarm, isAlarm) << text;
    return text;
  }

  std::set<double> Shades()
  {
    vtkDataArray* shades =
      FilterChecks::RequireArray(this->Filter->GetOutput()->GetCellData(), "Shade");
    std::set<double> values;
    for (vtkIdType i = 0; i < shades->GetNumberOfTuples(); ++i)
    {
      values.insert(shades->GetComponent(i, 0));
    }
    return values;
  }

  /** Returns the colour of each patch, by the number of the patch. */
  std::map<int, int> Colours()
  {
    vtkCellData* data =
      vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(1))->GetCellData();
    vtkDataArray* colours = FilterChecks::RequireArray(data, "Colour");
    vtkDataArray* patches = FilterChecks::RequireArray(data, "FaceId");
    std::map<int, int> found;
    for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i)
    {
      const auto colour = static_cast<int>(colours->GetTuple1(i));
      const auto [patch, isNew] = found.insert({ static_cast<int>(patches->GetTuple1(i)), colour });
      EXPECT_EQ(patch->second, colour) << "one colour on a patch";
    }
    return found;
  }

  /** Returns the distances of the points of output 2 from the rows. */
  std::vector<double> Moves()
  {
    auto* points = vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(2));
    std::vector<double> moves;
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      const double* row = this->Filter->GetRows()->GetTuple(i);
      const double* place = points->GetPoint(i);
      moves.push_back(std::hypot(place[0] - row[0], place[1] - row[1]));
    }
    return moves;
  }

  vtkIdType CountOf(int port)
  {
    return vtkDataSet::SafeDownCast(this->Filter->GetOutputDataObject(port))->GetNumberOfCells();
  }

  vtkNew<vtkPlanarDomainSource> Domain;
  vtkNew<vtkLayoutDesigner> Filter;
};
}

TEST_F(LayoutDesigner, FollowsFilterConventions)
{
  this->SetFour();
  FilterChecks::UpdateWithoutError(this->Filter);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckRunTwice(
    this->Filter, [this] { this->SetFour(0.6); }, [this] { this->SetFour(0.5); });
  FilterChecks::CheckPrintSelf(this->Filter,
    { "Singularities", "MeshSize", "CapCorners", "Quads", "Merge", "QuadSize", "QuadCount",
      "StageSeconds" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(LayoutDesigner, AgreesWithTheOtherFilters)
{
  this->SetFour();
  this->Filter->SetQuadsToSmooth();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->CountOf(0), 12); // separatrices
  EXPECT_EQ(this->CountOf(2), 4);  // singularities
  EXPECT_EQ(this->Value("Faces"), 9);
  EXPECT_EQ(this->Value("Stale"), 0);
  // docs/method.md §9: W of four +1 at radius 0.6 is 2.05; on this polygon it is smaller.
  EXPECT_NEAR(this->Value("RenormalizedEnergy"), 2.05, 0.8);
  // docs/method.md §14.11: number of quads at h = 0.1 of five patches around one at 0.6.
  EXPECT_NEAR(static_cast<double>(this->CountOf(3)), 297 + 60, 60);
  EXPECT_GT(this->Value("MinimumAngle"), 50);
  EXPECT_NE(this->Text("Summary").find("quads in"), std::string::npos) << this->Text("Summary");
  EXPECT_EQ(this->TextInView(false), this->Text("Summary"));
  this->Filter->SetQuadsToNone();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->CountOf(3), 0);
}

TEST_F(LayoutDesigner, KeepsTheLastValidLayout)
{
  this->SetFour();
  FilterChecks::UpdateWithoutError(this->Filter);
  const vtkIdType lines = this->CountOf(0);
  this->Filter->SetSingularity(0, 3.0, 0.0, 1, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->CountOf(0), lines);
  EXPECT_EQ(this->Value("Stale"), 1);
  EXPECT_EQ(this->Shades(), std::set<double>({ 0.0 })) << "a stale layout is grey";
  EXPECT_NE(this->Text("Reason").find("outside"), std::string::npos) << this->Text("Reason");
  EXPECT_EQ(this->Text("Summary"), this->Text("Reason"));
  EXPECT_EQ(this->TextInView(true), this->Text("Reason"));
  EXPECT_EQ(this->CountOf(2), 4) << "the handles keep their positions";
  // A valid position makes the layout current again.
  this->SetFour();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Shades(), std::set<double>({ 1.0 }));
  EXPECT_EQ(this->Value("Stale"), 0);
  // A quarter index that makes the sum inconsistent.
  this->Filter->SetSingularity(0, 0.4, 0.4, 2, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Stale"), 1);
  EXPECT_NE(this->Text("Reason").find("total"), std::string::npos) << this->Text("Reason");
  // A quarter index that is not an integer.
  this->Filter->SetSingularity(0, 0.4, 0.4, 0.5, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Stale"), 1);
}

TEST_F(LayoutDesigner, UsesACoarserMeshAndDraftsWhileDragging)
{
  this->SetFour();
  this->Filter->SetSingularity(
    0, 0.5, 0.38, 1, 0.1); // no separatrices that coincide on one mesh only
  this->Filter->SetMeshSize(0.015);
  FilterChecks::UpdateWithoutError(this->Filter);
  const double energy = this->Value("RenormalizedEnergy");
  const double angle = this->Value("MinimumAngle");
  const double arc = this->Value("ShortestArc");
  const vtkIdType points = this->Filter->GetOutput()->GetNumberOfPoints();
  this->Filter->DraggingOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_LT(static_cast<double>(this->Filter->GetOutput()->GetNumberOfPoints()),
    0.7 * static_cast<double>(points))
    << "a separatrix has a point on every side of a triangle that it crosses";
  EXPECT_LT(this->Value("MinimumAngle"), angle) << "drafts are not smoothed";
  // The same results up to the error of the coarser mesh.
  EXPECT_EQ(this->Value("Faces"), 9);
  EXPECT_NEAR(this->Value("RenormalizedEnergy"), energy, 0.02);
  EXPECT_NEAR(this->Value("ShortestArc"), arc, 0.02 * arc);
  this->Filter->SetSingularity(0, 0.5, 0.3, 1, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  this->Filter->SetSingularity(0, 0.5, 0.38, 1, 0.1);
  this->Filter->DraggingOff();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RenormalizedEnergy"), energy);
  EXPECT_EQ(this->Value("MinimumAngle"), angle);
  EXPECT_EQ(this->Filter->GetOutput()->GetNumberOfPoints(), points);
}

TEST_F(LayoutDesigner, PatchesKeepTheirColours)
{
  this->SetFour();
  this->Filter->SetSingularity(0, 0.5, 0.38, 1, 0.1);
  this->Filter->DraggingOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  const std::map<int, int> first = this->Colours();
  EXPECT_EQ(first.size(), 9u);
  for (const auto& [patch, colour] : first)
  {
    EXPECT_GE(colour, 0);
    EXPECT_LT(colour, 5);
  }
  for (int step = 1; step <= 5; ++step)
  {
    this->Filter->SetSingularity(0, 0.5, 0.38 - 0.002 * step, 1, 0.1);
    FilterChecks::UpdateWithoutError(this->Filter);
  }
  this->Filter->DraggingOff();
  FilterChecks::UpdateWithoutError(this->Filter);
  // Patches may be numbered in another order.
  std::multiset<int> before;
  std::multiset<int> after;
  for (const auto& [patch, colour] : first)
  {
    before.insert(colour);
  }
  for (const auto& [patch, colour] : this->Colours())
  {
    after.insert(colour);
  }
  EXPECT_EQ(before, after);
  this->Filter->SetSingularity(0, 3.0, 0.0, 1, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  for (const auto& [patch, colour] : this->Colours())
  {
    EXPECT_EQ(colour, -1) << "a stale layout is grey";
  }
}

TEST_F(LayoutDesigner, ReportsAndShowsNodesThatMoved)
{
  // At their rows.
  this->SetFour();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("MovedNodes"), 0);
  EXPECT_EQ(this->Text("Summary").find("moved"), std::string::npos) << this->Text("Summary");
  for (const double move : this->Moves())
  {
    EXPECT_NEAR(move, 0.0, 1e-12);
  }
  // Separatrices that pass singularities closely meet them if these move.
  this->Filter->SetSingularity(0, 0.5, 0.35, 1, 0.1);
  this->Filter->SetQuadSize(0.03);
  this->Filter->SetMergeToClean();
  FilterChecks::UpdateWithoutError(this->Filter);
  const std::vector<double> moves = this->Moves();
  EXPECT_GT(*std::max_element(moves.begin(), moves.end()), 0.01);
  EXPECT_NEAR(this->Value("Moved"), *std::max_element(moves.begin(), moves.end()), 1e-12);
  EXPECT_EQ(this->Filter->GetRows()->GetComponent(0, 0), 0.5) << "the handles stay";
  EXPECT_EQ(this->Value("MovedNodes"), 4);
  EXPECT_NE(this->Text("Summary").find("4 nodes moved by up to 0.02"), std::string::npos)
    << this->Text("Summary");
  EXPECT_EQ(this->Text("Summary").find("Snap"), std::string::npos) << "there is nothing to snap";
  // A stale layout has no nodes of the present rows.
  this->Filter->SetSingularity(0, 3.0, 0.0, 1, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Moves(), std::vector<double>(4, 0.0));
}

TEST_F(LayoutDesigner, ReleasedNodesAreReported)
{
  // Singularities placed at random in a plate with three holes. Quads at them would be inverted.
  this->Filter->SetInputData(TestInputs::Loops(
    { TestInputs::Rectangle({ 0.0, 0.0 }, { 4.0, 3.0 }), TestInputs::Circle(24, 0.25, { 0.9, 0.9 }),
      TestInputs::Circle(24, 0.3, { 2.9, 0.8 }), TestInputs::Circle(24, 0.2, { 2.0, 2.1 }) }));
  this->Filter->SetMeshSize(0.0);
  this->Filter->SetQuadSize(0.0);
  this->Filter->SetQuadCount(500);
  const double places[12][2] = { { 1.1, 0.18 }, { 1.26, 1.98 }, { 3.5, 1.93 }, { 1.79, 2.56 },
    { 0.88, 1.31 }, { 3.13, 2.62 }, { 3.41, 1.19 }, { 2.31, 1.0 }, { 0.65, 1.49 }, { 3.25, 2.44 },
    { 2.78, 2.72 }, { 1.17, 0.61 } };
  for (int i = 0; i < 12; ++i)
  {
    this->Filter->SetSingularity(i, places[i][0], places[i][1], -1, 0.1);
  }
  FilterChecks::UpdateWithoutError(this->Filter);
  ASSERT_EQ(this->Value("Stale"), 0) << this->Text("Reason");
  vtkFieldData* report = this->Filter->GetOutputDataObject(4)->GetFieldData();
  ASSERT_EQ(FilterChecks::RequireArray(report, "Released")->GetTuple1(0), 1.0)
    << "the test needs another configuration";
  const std::vector<double> moves = this->Moves();
  EXPECT_GT(this->Value("MovedNodes"), 0);
  const auto moved = std::max_element(moves.begin(), moves.end()) - moves.begin();
  EXPECT_NE(this->ReasonOf(moved).find("Placed by you. Its node is "), std::string::npos)
    << this->ReasonOf(moved);
  EXPECT_NEAR(this->Value("Moved"), *std::max_element(moves.begin(), moves.end()), 1e-12);
  EXPECT_NE(this->Text("Summary").find("moved by"), std::string::npos) << this->Text("Summary");
  // Drafts are at the handles.
  this->Filter->DraggingOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("MovedNodes"), 0);
}

TEST_F(LayoutDesigner, MergesBlocksWhenAHandleIsReleased)
{
  this->SetFour();
  this->Filter->SetSingularity(0, 0.5, 0.35, 1, 0.1);
  this->Filter->SetQuadSize(0.03);
  FilterChecks::UpdateWithoutError(this->Filter);
  const auto blocks = [this]
  {
    return FilterChecks::RequireArray(
      this->Filter->GetOutputDataObject(4)->GetFieldData(), "Blocks")
      ->GetTuple1(0);
  };
  const double separate = blocks();
  this->Filter->SetMergeToClean();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_LT(blocks(), separate);
  EXPECT_EQ(this->Value("Stale"), 0);
  this->Filter->SetMergeToCoarse();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_LT(blocks(), separate);
  this->Filter->SetMergeToClean();
  this->Filter->DraggingOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("MovedNodes"), 0) << "blocks are not merged while a handle is dragged";
  EXPECT_EQ(blocks(), separate);
}

TEST_F(LayoutDesigner, IsStaleIfTheFirstConfigurationIsInvalid)
{
  this->Filter->SetSingularity(0, 0.4, 0.4, 2, 0.1);
  this->Filter->Update();
  EXPECT_EQ(this->Filter->GetErrorCode(), 0u);
  EXPECT_EQ(this->CountOf(0), 0);
  EXPECT_EQ(this->CountOf(2), 1);
  EXPECT_EQ(this->Value("Stale"), 1);
}

TEST_F(LayoutDesigner, ReportsAnInvalidDomain)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_FALSE(this->TextInView(false).empty());
  this->Filter->SetInputData(TestInputs::OpenCurve({ { 0, 0 }, { 1, 0 }, { 1, 1 } }));
  FilterChecks::CaptureError(this->Filter, { "open curve" });
  EXPECT_NE(this->TextInView(true).find("open curve"), std::string::npos);
  EXPECT_EQ(this->Filter->GetRows()->GetNumberOfTuples(), 0);
  this->Filter->SetInputConnection(this->Domain->GetOutputPort());
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->TextInView(false), this->Text("Summary"));
  EXPECT_EQ(this->Filter->GetRows()->GetNumberOfTuples(), 4);
}

TEST_F(LayoutDesigner, AppliesCommands)
{
  // Without rows the singularities are chosen automatically.
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfSingularities(), 0);
  ASSERT_EQ(this->Filter->GetRows()->GetNumberOfTuples(), 4);
  const double chosen = this->Value("RenormalizedEnergy");

  this->SetFour(0.45);
  FilterChecks::UpdateWithoutError(this->Filter);
  const double before = this->Value("RenormalizedEnergy");
  this->Filter->Optimise();
  FilterChecks::UpdateWithoutError(this->Filter);
  const double optimised = this->Value("RenormalizedEnergy");
  EXPECT_LT(optimised, before - 0.1);
  EXPECT_NEAR(optimised, chosen, 0.05);
  // A command is applied once.
  this->Filter->Modified();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RenormalizedEnergy"), optimised);

  this->Filter->AddPair();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfSingularities(), 6);
  EXPECT_EQ(this->Value("Stale"), 0) << this->Text("Reason");
  this->Filter->RemoveSingularity(4);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetNumberOfSingularities(), 5);
  EXPECT_EQ(this->Filter->GetRows()->GetComponent(4, 2), -1) << "the wrong row was removed";
  EXPECT_EQ(this->Value("Stale"), 1);
  this->Filter->Undo();
  FilterChecks::UpdateWithoutError(this->Filter);
  this->Filter->Undo();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RenormalizedEnergy"), optimised);
  this->Filter->Undo();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RenormalizedEnergy"), before);
  this->Filter->Undo(); // no command left
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RenormalizedEnergy"), before);
  this->Filter->Propose();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("RenormalizedEnergy"), chosen);
}

TEST_F(LayoutDesigner, SnapJoinsNearlyCoincidentSeparatrices)
{
  this->SetFour();
  this->Filter->SetSingularity(0, 0.44, 0.41, 1, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  const double thin = this->Value("ShortestArc");
  EXPECT_LT(thin, 0.5);
  EXPECT_NE(this->Text("Summary").find(": try Snap."), std::string::npos);
  EXPECT_EQ(this->Text("Summary").find("lower is better"), std::string::npos) << "blocks are thin";
  const double patches = this->Value("Faces");
  this->Filter->Snap();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_GT(this->Value("ShortestArc"), 1.0);
  EXPECT_LT(this->Value("Faces"), patches);
  EXPECT_NE(this->Text("Events").find("separatrices were joined: "), std::string::npos)
    << this->Text("Events");
  EXPECT_NE(this->Text("Summary").find("lower is better"), std::string::npos);
  EXPECT_EQ(this->ReasonOf(0), "Moved by Snap, to join separatrices.");
  this->Filter->SetSnapTolerance(1e-9);
  this->Filter->Undo();
  FilterChecks::UpdateWithoutError(this->Filter);
  this->Filter->Snap();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("ShortestArc"), thin);
  EXPECT_EQ(this->Text("Summary").find(": try Snap."), std::string::npos) << "it was tried";
  EXPECT_NE(this->Text("Summary").find("try Merge."), std::string::npos);
  // The remedy works.
  this->Filter->SetMergeToCoarse();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Text("Summary").find("coincide"), std::string::npos) << this->Text("Summary");
}

TEST_F(LayoutDesigner, ExplainsRowsAndTheirSum)
{
  const auto sum = [this]
  {
    vtkIntArray* required = this->Filter->GetRequiredSum();
    return required->GetNumberOfValues() == 1 ? required->GetValue(0) : -1000;
  };
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(sum(), 4);
  ASSERT_EQ(this->Filter->GetReasons()->GetNumberOfValues(), 4);
  EXPECT_EQ(this->ReasonOf(3), "Chosen for this domain.");
  this->SetFour();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->ReasonOf(3), "Placed by you.");
  // Rows that do not add up, one of them outside.
  this->Filter->SetSingularity(4, 3.0, 0.0, 1, 0.1);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Value("Stale"), 1);
  EXPECT_EQ(sum(), 4);
  EXPECT_EQ(this->Filter->GetReasons()->GetNumberOfValues(), 5);
  this->Filter->RemoveSingularity(4);
  this->Filter->Update();
  this->Filter->AddPair();
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->ReasonOf(3), "Placed by you.");
  EXPECT_EQ(this->ReasonOf(5), "Added by Add Pair, where there is most space.");
  // A singularity at a corner takes its place in the sum.
  this->Filter->RemoveAllSingularities();
  this->Domain->SetDomainName("square");
  this->Filter->Update(); // no separatrices
  EXPECT_EQ(sum(), 0);
  double bounds[6];
  this->Domain->GetOutput()->GetBounds(bounds);
  this->Filter->AddSingularity(bounds[0], bounds[2], 0, 0.1);
  this->Filter->Update();
  EXPECT_EQ(sum(), 1);
}

TEST_F(LayoutDesigner, StartsFromItsPortWithoutRows)
{
  vtkNew<vtkSingularitySource> source;
  this->Filter->SetSingularitiesConnection(source->GetOutputPort());
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_NEAR(this->Filter->GetRows()->GetComponent(0, 0), 0.6 * std::sqrt(0.5), 1e-15);
  this->SetFour(0.5);
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_NEAR(this->Filter->GetRows()->GetComponent(0, 0), 0.5 * std::sqrt(0.5), 1e-15);
}

TEST_F(LayoutDesigner, ResetsWhenTheDomainChanges)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetRows()->GetNumberOfTuples(), 4);
  this->Domain->SetDomainName("l-shape");
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(this->Filter->GetRows()->GetNumberOfTuples(), 0) << "an L-shape needs no singularities";
  EXPECT_EQ(this->Value("Stale"), 0);
}

TEST_F(LayoutDesigner, KeepMeshReusesTheMeshInMapAndHField)
{
  vtkNew<vtkSingularitySource> source;
  vtkNew<vtkHField> field;
  field->SetInputConnection(this->Domain->GetOutputPort());
  field->SetSingularitiesConnection(source->GetOutputPort());
  field->KeepMeshOn();
  FilterChecks::UpdateWithoutError(field);
  vtkNew<vtkPoints> first;
  first->DeepCopy(field->GetOutput()->GetPoints());
  source->SetSingularity(0, 0.3, 0.45, 1, 0.1);
  FilterChecks::UpdateWithoutError(field);
  ASSERT_EQ(field->GetOutput()->GetNumberOfPoints(), first->GetNumberOfPoints());
  EXPECT_EQ(field->GetStageSeconds()[2], 0.0) << "the mesh was factored again";
  FilterChecks::CheckInputUntouched(field);
  FilterChecks::CheckEmptyInput(field);

  vtkNew<vtkCrossFieldMap> map;
  map->SetInputConnection(this->Domain->GetOutputPort());
  map->SetSingularitiesConnection(source->GetOutputPort());
  map->KeepMeshOn();
  vtkNew<vtkSeparatrices> lines;
  lines->SetInputConnection(map->GetOutputPort());
  FilterChecks::UpdateWithoutError(lines);
  const double patches =
    FilterChecks::RequireArray(lines->GetOutput()->GetFieldData(), "Faces")->GetComponent(0, 0);
  map->KeepMeshOff();
  FilterChecks::UpdateWithoutError(lines);
  EXPECT_EQ(
    FilterChecks::RequireArray(lines->GetOutput()->GetFieldData(), "Faces")->GetComponent(0, 0),
    patches);
}
