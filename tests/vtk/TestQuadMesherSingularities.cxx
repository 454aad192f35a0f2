// The singularities and corners that QuadMesher used: its outputs at ports 3 and 4.

#include "support/DiskTest.h"
#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkConfigurationProposal.h"
#include "vtkPlanarDomainSource.h"
#include "vtkQuadMesher.h"
#include "vtkSingularitySource.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace
{
/** Returns the field data of the summary of a mesh. */
vtkFieldData* ReportOf(vtkQuadMesher* mesher)
{
  return mesher->GetOutputDataObject(8)->GetFieldData();
}

/**
 * Returns the number of sentences in an array of the field data of a mesh; −1 without the array.
 */
vtkIdType FieldStrings(vtkQuadMesher* mesher, const char* name)
{
  vtkAbstractArray* array = ReportOf(mesher)->GetAbstractArray(name);
  return array == nullptr ? -1 : array->GetNumberOfTuples();
}

using Place = std::array<double, 3>;

/** Returns the data of an output port that holds singularities or corners. */
vtkPolyData* UsedPoints(vtkQuadMesher* mesher, int port)
{
  return vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(port));
}

Place PositionOf(vtkDataSet* points, vtkIdType i)
{
  Place position{};
  points->GetPoint(i, position.data());
  return position;
}

class QuadMesherSingularities : public DiskTest<vtkQuadMesher>
{
public:
  void SetUp() override
  {
    DiskTest::SetUp();
    this->Filter->SetQuadSize(0.1);
  }
};
}

TEST_F(QuadMesherSingularities, OutputsGivenSingularitiesAsTheyAre)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  auto* given = this->Singularities->GetOutput();
  vtkPolyData* used = UsedPoints(this->Filter, 3);
  ASSERT_EQ(used->GetNumberOfPoints(), given->GetNumberOfPoints());
  for (vtkIdType i = 0; i < given->GetNumberOfPoints(); ++i)
  {
    EXPECT_EQ(PositionOf(used, i), PositionOf(given, i));
    for (const char* name : { "QuarterIndex", "Radius" })
    {
      EXPECT_EQ(FilterChecks::RequireArray(used->GetPointData(), name)->GetTuple1(i),
        FilterChecks::RequireArray(given->GetPointData(), name)->GetTuple1(i));
    }
  }
  EXPECT_EQ(used->GetFieldData()->GetAbstractArray("Events"), nullptr);
  EXPECT_EQ(UsedPoints(this->Filter, 4)->GetNumberOfPoints(), 0);
  EXPECT_EQ(this->Filter->GetStageSeconds()[6], 0.0);
}

TEST_F(QuadMesherSingularities, OutputsAllCornersWithTheirIndices)
{
  this->Domain->SetDomainName("star");
  this->Filter->SetSingularitiesConnection(nullptr);
  FilterChecks::UpdateWithoutError(this->Filter);
  double sum = 0.0;
  for (const int port : { 3, 4 })
  {
    vtkPolyData* used = UsedPoints(this->Filter, port);
    for (vtkIdType i = 0; i < used->GetNumberOfPoints(); ++i)
    {
      const double quarters =
        FilterChecks::RequireArray(used->GetPointData(), "QuarterIndex")->GetTuple1(i);
      EXPECT_LE(quarters, 1.0);
      sum += quarters;
    }
  }
  EXPECT_EQ(UsedPoints(this->Filter, 4)->GetNumberOfPoints(), 10);
  EXPECT_EQ(sum, 4.0);
}

TEST_F(QuadMesherSingularities, OutputsPositionsAfterRepair)
{
  this->Domain->SetDomainName("ring");
  std::vector<TestInputs::Row> rows;
  for (int i = 0; i < 4; ++i)
  {
    const double turn = 0.5 * vtkMath::Pi() * i;
    rows.push_back({ 0.8 * std::cos(turn + 0.25), 0.8 * std::sin(turn + 0.25), 1.0, 0.02 });
    rows.push_back({ 0.55 * std::cos(turn + 0.1), 0.55 * std::sin(turn + 0.1), -1.0, 0.02 });
  }
  this->Filter->SetSingularitiesData(TestInputs::Singularities(rows));
  this->Filter->RepairHolonomyOn();
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkFieldData* field = ReportOf(this->Filter);
  vtkDataArray* repaired = FilterChecks::RequireArray(field, "RepairedPositions");
  vtkPolyData* used = UsedPoints(this->Filter, 3);
  ASSERT_EQ(used->GetNumberOfPoints(), 8);
  double largest = 0.0;
  for (vtkIdType i = 0; i < 8; ++i)
  {
    const Place position = PositionOf(used, i);
    const TestInputs::Row& row = rows[static_cast<std::size_t>(i)];
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(position[static_cast<std::size_t>(axis)], repaired->GetComponent(i, axis));
    }
    largest = std::max(largest, std::hypot(position[0] - row[0], position[1] - row[1]));
  }
  EXPECT_NEAR(FilterChecks::RequireArray(field, "RepairDistance")->GetTuple1(0), largest, 1e-14);
  EXPECT_GT(largest, 0.01);
}

TEST_F(QuadMesherSingularities, MakesTheSameMeshOfWhatItChoseUnlessItMoved)
{
  // On an ellipse, sizes at the minimum of the energy are not far from uniform.
  constexpr int Count = 40;
  TestInputs::Curve ellipse;
  vtkNew<vtkDoubleArray> lengths;
  lengths->SetName("Length");
  for (int i = 0; i < Count; ++i)
  {
    const double angle = 2.0 * vtkMath::Pi() * i / Count;
    ellipse.push_back({ 0.8 * std::cos(angle), 0.5 * std::sin(angle) });
    lengths->InsertNextValue(1.0 + 0.4 * std::cos(angle));
  }
  const auto domain = TestInputs::Loops({ ellipse });
  domain->GetPointData()->AddArray(lengths);
  std::set<double> abscissas;
  for (const int sizing :
    { vtkQuadMesher::SizingConformal, vtkQuadMesher::SizingUniform, vtkQuadMesher::SizingField })
  {
    vtkNew<vtkQuadMesher> chosen;
    vtkNew<vtkQuadMesher> given;
    for (vtkQuadMesher* mesher : { chosen.Get(), given.Get() })
    {
      mesher->SetInputData(domain);
      mesher->SetMeshSize(0.15);
      mesher->SetQuadSize(0.1);
      mesher->SetSizing(sizing);
      mesher->SetSizeArray("Length");
    }
    given->SetSingularitiesConnection(chosen->GetOutputPort(3));
    given->SetCornersConnection(chosen->GetOutputPort(4));
    const FilterChecks::MessageRecorder first(
      chosen); // sizes are met on less than 90 % of the area
    const FilterChecks::MessageRecorder second(given);
    given->Update();
    EXPECT_TRUE(first.errors.empty() && second.errors.empty());
    const bool moves = sizing != vtkQuadMesher::SizingConformal;
    if (!moves)
    {
      EXPECT_EQ(FieldStrings(given, "Events"), 0);
    }
    EXPECT_GT(FieldStrings(chosen, "Events"), 0);
    vtkPolyData* used = UsedPoints(chosen, 3);
    EXPECT_EQ(used->GetFieldData()->GetAbstractArray("Events")->GetNumberOfTuples(),
      FieldStrings(chosen, "Events"));
    EXPECT_GT(chosen->GetStageSeconds()[6], 0.0);
    std::array<vtkNew<vtkUnstructuredGrid>, 2> meshes;
    chosen->CopyMesh(meshes[0]);
    given->CopyMesh(meshes[1]);
    for (const auto& mesh : meshes)
    {
      for (const char* name :
        { "Events", "Attempts", "MoveSingularity", "MoveFrom", "MoveTo", "MoveDistance" })
      {
        mesh->GetFieldData()->RemoveArray(name); // of given singularities
      }
    }
    if (!moves)
    {
      EXPECT_EQ(FilterChecks::Fingerprint(meshes[0]), FilterChecks::Fingerprint(meshes[1]));
    }
    ASSERT_GT(used->GetNumberOfPoints(), 0);
    vtkDataArray* irregular =
      FilterChecks::RequireArray(chosen->GetOutput()->GetPointData(), "Irregular");
    for (vtkIdType i = 0; i < used->GetNumberOfPoints(); ++i)
    {
      const vtkIdType node = chosen->GetOutput()->FindPoint(used->GetPoint(i));
      EXPECT_EQ(PositionOf(used, i), PositionOf(chosen->GetOutput(), node));
      EXPECT_EQ(irregular->GetTuple1(node), 1.0);
    }
    abscissas.insert(used->GetPoint(0)[0]);
  }
  EXPECT_EQ(abscissas.size(), 3U); // each sizing has its own optimum
}

TEST_F(QuadMesherSingularities, ChoosesWhatTheProposalChoosesWhereSizesAreUniformEnough)
{
  // A clearance below that of the energy's minimum, and no target sizes: nothing moves after the
  // proposal.
  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputConnection(this->Domain->GetOutputPort());
  proposal->AutomaticOn();
  proposal->SetMeshSize(0.1);
  FilterChecks::UpdateWithoutError(proposal);
  this->Filter->SetSingularitiesConnection(nullptr);
  this->Filter->SetSizingToConformal();
  this->Filter->SetClearance(1e-3); // at most 1/400 of the diagonal
  FilterChecks::UpdateWithoutError(this->Filter);
  vtkPolyData* used = UsedPoints(this->Filter, 3);
  ASSERT_EQ(used->GetNumberOfPoints(), proposal->GetOutput()->GetNumberOfPoints());
  for (vtkIdType i = 0; i < used->GetNumberOfPoints(); ++i)
  {
    const Place position = PositionOf(used, i);
    const Place proposed = PositionOf(proposal->GetOutput(), i);
    EXPECT_NEAR(position[0], proposed[0], 1e-3);
    EXPECT_NEAR(position[1], proposed[1], 1e-3);
  }
}
