#include "FilterChecks.h"
#include "TestInputs.h"
#include "vtkConfigurationProposal.h"
#include "vtkPlanarDomainSource.h"
#include "vtkQuadMesher.h"
#include "vtkSingularitySource.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkStructuredGrid.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

namespace
{
/** How many sentences the field data of a mesh hold; −1 without the array. */
vtkIdType FieldStrings(vtkQuadMesher* mesher, const char* name)
{
  vtkAbstractArray* array = mesher->GetOutput()->GetFieldData()->GetAbstractArray(name);
  return array == nullptr ? -1 : array->GetNumberOfTuples();
}

class QuadMesher : public testing::Test
{
public:
  void SetUp() override
  {
    this->Domain->SetEdgeLength(0.1);
    this->Filter->SetInputConnection(this->Domain->GetOutputPort());
    this->Filter->SetSingularitiesConnection(this->Singularities->GetOutputPort());
    this->Filter->SetMeshSize(0.1);
    this->Filter->SetQuadSize(0.1);
  }

  vtkNew<vtkPlanarDomainSource> Domain;
  vtkNew<vtkSingularitySource> Singularities;
  vtkNew<vtkQuadMesher> Filter;
};
}

TEST_F(QuadMesher, KeepsTheRulesOfAFilter)
{
  FilterChecks::UpdateWithoutError(this->Filter);
  FilterChecks::CheckInputUntouched(this->Filter);
  FilterChecks::CheckProgressAndAbort(this->Filter);
  FilterChecks::CheckPrintSelf(this->Filter,
    { "QuadSize", "QuadCount", "Sizing", "Coarse", "MeshSize", "CapCorners", "RepairHolonomy",
      "StageSeconds" });
  FilterChecks::CheckEmptyInput(this->Filter);
}

TEST_F(QuadMesher, BlocksAreTheQuadsAndShareTheirPoints)
{
  this->Filter->Update();
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(this->Filter->GetOutputDataObject(1));
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 5U);
  std::set<std::array<double, 3>> places;
  for (vtkIdType p = 0; p < quads->GetNumberOfPoints(); ++p)
  {
    std::array<double, 3> place{};
    quads->GetPoint(p, place.data());
    places.insert(place);
  }
  vtkIdType cells = 0;
  for (unsigned int b = 0; b < blocks->GetNumberOfBlocks(); ++b)
  {
    auto* grid = vtkStructuredGrid::SafeDownCast(blocks->GetBlock(b));
    ASSERT_NE(grid, nullptr);
    cells += grid->GetNumberOfCells();
    for (vtkIdType p = 0; p < grid->GetNumberOfPoints(); ++p)
    {
      std::array<double, 3> place{};
      grid->GetPoint(p, place.data());
      EXPECT_EQ(places.count(place), 1U);
    }
  }
  const auto count = static_cast<vtkIdType>(
    FilterChecks::RequireArray(quads->GetFieldData(), "Quads")->GetComponent(0, 0));
  EXPECT_EQ(cells, count);
  EXPECT_GT(quads->GetNumberOfCells(), count); // and the boundary's lines
}

TEST_F(QuadMesher, ValencesAreThoseAskedFor)
{
  this->Filter->Update();
  vtkUnstructuredGrid* quads = this->Filter->GetOutput();
  vtkDataArray* valence = FilterChecks::RequireArray(quads->GetPointData(), "Valence");
  vtkDataArray* irregular = FilterChecks::RequireArray(quads->GetPointData(), "Irregular");
  vtkDataArray* side = FilterChecks::RequireArray(quads->GetPointData(), "BoundarySide");
  int singular = 0;
  for (vtkIdType p = 0; p < quads->GetNumberOfPoints(); ++p)
  {
    const double regular = side->GetComponent(p, 0) < 0.0 ? 4.0 : 2.0;
    EXPECT_EQ(valence->GetComponent(p, 0), regular - irregular->GetComponent(p, 0));
    singular += irregular->GetComponent(p, 0) != 0.0 ? 1 : 0;
  }
  EXPECT_EQ(singular, 4);
  EXPECT_EQ(
    vtkPolyData::SafeDownCast(this->Filter->GetOutputDataObject(2))->GetNumberOfLines(), 24);
}

TEST_F(QuadMesher, ChoosesSingularitiesAsTheProposalDoes)
{
  const auto domain = TestInputs::Loops({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 0.4, 0.9 } } });
  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputData(domain);
  proposal->AutomaticOn();
  proposal->SetMeshSize(0.15);
  this->Filter->SetInputData(domain);
  this->Filter->SetMeshSize(0.15);
  this->Filter->SetSingularitiesConnection(proposal->GetOutputPort());
  this->Filter->SetCornersConnection(proposal->GetOutputPort(1));
  FilterChecks::UpdateWithoutError(this->Filter);
  EXPECT_EQ(FieldStrings(this->Filter, "Events"), 0);

  vtkNew<vtkQuadMesher> alone;
  alone->SetInputData(domain);
  alone->SetMeshSize(0.15);
  alone->SetQuadSize(0.1);
  FilterChecks::UpdateWithoutError(alone);
  EXPECT_GT(FieldStrings(alone, "Events"), 0);
  alone->GetOutput()->GetFieldData()->RemoveArray("Events");
  this->Filter->GetOutput()->GetFieldData()->RemoveArray("Events");
  EXPECT_EQ(FilterChecks::Fingerprint(alone->GetOutput()),
    FilterChecks::Fingerprint(this->Filter->GetOutput()));
}
