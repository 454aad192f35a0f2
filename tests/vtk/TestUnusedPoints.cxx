// Points that no cell uses are ignored, wherever they are: every filter that reads a domain or a
// mesh produces the same bytes without them.

#include "support/FilterChecks.h"
#include "support/TestInputs.h"
#include "vtkBoundaryCornerClassifier.h"
#include "vtkBoundarySimplifier.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldMap.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkCrossGlyphs.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkHField.h"
#include "vtkLayoutDesigner.h"
#include "vtkPerforatedCrossField.h"
#include "vtkPoincareHopfCheck.h"
#include "vtkQuadMesher.h"
#include "vtkSeparatrices.h"
#include "vtkSingularityEnergy.h"
#include "vtkSingularityOptimizer.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <array>
#include <limits>

namespace
{
using Vector = std::array<double, 3>;

/** Positions of unused points: off the plane, extremely far away, and not finite. */
const std::array<Vector, 3> Strays = { Vector{ 1.0, 2.0, 0.5 }, Vector{ 1e70, -1e70, 1e70 },
  Vector{ std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0 } };

/**
 * Copies points, cells and arrays with `shift` points added, or removed if negative, at either end.
 */
template <class DataSet>
vtkSmartPointer<vtkDataSet> Renumbered(DataSet* input, vtkIdType shift, const Vector& stray = {})
{
  const vtkIdType before = input->GetNumberOfPoints();
  const vtkIdType after = before + 2 * shift;
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  auto result = vtkSmartPointer<DataSet>::New();
  result->Allocate(input->GetNumberOfCells());
  for (int i = 0; i < input->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = input->GetPointData()->GetArray(i);
    const auto copy = vtk::TakeSmartPointer(array->NewInstance());
    copy->SetName(array->GetName());
    copy->SetNumberOfComponents(array->GetNumberOfComponents());
    copy->SetNumberOfTuples(after);
    copy->Fill(0.0);
    result->GetPointData()->AddArray(copy);
  }
  for (vtkIdType i = 0; i < after; ++i)
  {
    const vtkIdType old = i - shift;
    const bool isStray = old < 0 || old >= before;
    points->InsertNextPoint(isStray ? stray.data() : input->GetPoint(old));
    for (int j = 0; !isStray && j < input->GetPointData()->GetNumberOfArrays(); ++j)
    {
      result->GetPointData()->GetArray(j)->SetTuple(i, old, input->GetPointData()->GetArray(j));
    }
  }
  result->SetPoints(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell)
  {
    input->GetCellPoints(cell, ids);
    for (vtkIdType i = 0; i < ids->GetNumberOfIds(); ++i)
    {
      ids->SetId(i, ids->GetId(i) + shift);
    }
    result->InsertNextCell(input->GetCellType(cell), ids);
  }
  result->GetCellData()->ShallowCopy(input->GetCellData());
  result->GetFieldData()->ShallowCopy(input->GetFieldData());
  return result;
}

vtkSmartPointer<vtkDataSet> Renumbered(vtkDataSet* input, vtkIdType shift, const Vector& stray = {})
{
  auto* grid = vtkUnstructuredGrid::SafeDownCast(input);
  return grid != nullptr ? Renumbered<vtkUnstructuredGrid>(grid, shift, stray)
                         : Renumbered<vtkPolyData>(vtkPolyData::SafeDownCast(input), shift, stray);
}

/**
 * Returns all outputs and warnings of a run. An input that is passed through is returned without
 * the added points.
 */
std::vector<std::string> Outputs(vtkAlgorithm* filter, vtkDataSet* input, bool hasStrays)
{
  filter->SetInputDataObject(0, input);
  FilterChecks::MessageRecorder messages(filter);
  filter->Update();
  EXPECT_TRUE(messages.errors.empty()) << messages.errors.front();
  EXPECT_FALSE(FilterChecks::IsEmpty(filter->GetOutputDataObject(0)));
  std::vector<std::string> outputs;
  for (int port = 0; port < filter->GetNumberOfOutputPorts(); ++port)
  {
    vtkDataObject* output = filter->GetOutputDataObject(port);
    auto* set = vtkDataSet::SafeDownCast(output);
    const bool isPassedThrough = set != nullptr &&
      set->GetNumberOfPoints() == input->GetNumberOfPoints() &&
      set->GetNumberOfCells() == input->GetNumberOfCells();
    outputs.push_back(FilterChecks::Fingerprint(
      isPassedThrough ? Renumbered(set, hasStrays ? -1 : 0).GetPointer() : output));
  }
  outputs.insert(outputs.end(), messages.warnings.begin(), messages.warnings.end());
  return outputs;
}

void ExpectIgnored(vtkAlgorithm* filter, vtkDataSet* input)
{
  const std::vector<std::string> expected = Outputs(filter, input, false);
  for (const Vector& stray : Strays)
  {
    const std::vector<std::string> found = Outputs(filter, Renumbered(input, 1, stray), true);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t port = 0; port < expected.size(); ++port)
    {
      EXPECT_TRUE(found[port] == expected[port])
        << "output " << port << " of " << filter->GetClassName() << " with a point at " << stray[0]
        << ", " << stray[1] << ", " << stray[2];
    }
  }
}

/** Adds the array `Size`, the target edge length of quads, which increases to the right. */
void AddSizes(vtkDataSet* domain)
{
  vtkNew<vtkDoubleArray> sizes;
  sizes->SetName("Size");
  for (vtkIdType i = 0; i < domain->GetNumberOfPoints(); ++i)
  {
    sizes->InsertNextValue(0.5 + 0.05 * domain->GetPoint(i)[0]);
  }
  domain->GetPointData()->AddArray(sizes);
}

/** Square with a square hole, as loops, as triangles and as cells of a grid. */
class UnusedPointsOfDomain : public testing::TestWithParam<int>
{
public:
  template <class Filter>
  void Expect(Filter* filter)
  {
    ExpectIgnored(filter, this->Input());
  }

  vtkSmartPointer<vtkPolyData> Pair =
    TestInputs::Singularities({ { 1.0, 1.1, 1.0, 0.3 }, { 5.0, 4.8, -1.0, 0.3 } });

  /** Pair on a line of symmetry, so that there is no holonomy defect. */
  vtkSmartPointer<vtkPolyData> NearPair =
    TestInputs::Singularities({ { 0.6, 0.6, 1.0, 0.1 }, { 1.4, 1.4, -1.0, 0.1 } });

  vtkSmartPointer<vtkDataSet> Input() const
  {
    if (GetParam() == 0)
    {
      return TestInputs::Loops(TestInputs::FrameCurves());
    }
    const auto mesh = TestInputs::FrameMesh();
    return GetParam() == 1 ? vtkSmartPointer<vtkDataSet>(mesh)
                           : vtkSmartPointer<vtkDataSet>(TestInputs::AsUnstructuredGrid(mesh));
  }
};

TEST_P(UnusedPointsOfDomain, CornerClassifier)
{
  vtkNew<vtkBoundaryCornerClassifier> filter;
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Proposal)
{
  vtkNew<vtkConfigurationProposal> filter;
  filter->SetSingularitiesData(TestInputs::Singularities({ { 1.0, 1.1, 1.0, 0.3 } }));
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Drill)
{
  vtkNew<vtkDrillHoles> filter;
  filter->SetSingularitiesData(this->Pair);
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Check)
{
  vtkNew<vtkPoincareHopfCheck> filter;
  filter->SetSingularitiesData(this->Pair);
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, H)
{
  vtkNew<vtkHField> filter;
  filter->SetSingularitiesData(this->Pair);
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Energy)
{
  vtkNew<vtkSingularityEnergy> filter;
  filter->AddConfigurationData(this->Pair);
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Simplifier)
{
  vtkNew<vtkBoundarySimplifier> filter;
  filter->SetThinningLength(0.0); // no change
  this->Expect(filter.Get());
  filter->SetSmoothingLength(0.5);
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Map)
{
  vtkNew<vtkCrossFieldMap> filter;
  filter->SetSingularitiesData(this->NearPair);
  filter->SetMeshSize(0.3);
  this->Expect(filter.Get());
  filter->KeepMeshOn();
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Quads)
{
  vtkNew<vtkQuadMesher> filter;
  filter->SetSingularitiesData(this->NearPair);
  filter->SetMeshSize(0.3);
  filter->SetQuadCount(100);
  this->Expect(filter.Get());
  filter->SetSizing(vtkQuadMesher::SizingField);
  filter->SetSizeArray("Size");
  const auto input = this->Input();
  AddSizes(input);
  ExpectIgnored(filter, input);
}

TEST_P(UnusedPointsOfDomain, Designer)
{
  vtkNew<vtkLayoutDesigner> filter;
  filter->SetSingularitiesData(this->NearPair);
  filter->SetMeshSize(0.3);
  this->Expect(filter.Get());
}

TEST_P(UnusedPointsOfDomain, Optimizer)
{
  vtkNew<vtkSingularityOptimizer> filter;
  filter->SetSingularitiesData(this->Pair);
  filter->SetMaximumIterations(2);
  this->Expect(filter.Get());
}

std::string InputName(const testing::TestParamInfo<int>& info)
{
  const char* const names[] = { "Loops", "Triangles", "Grid" };
  return names[info.param];
}

INSTANTIATE_TEST_SUITE_P(As, UnusedPointsOfDomain, testing::Values(0, 1, 2), InputName);

/** Returns the unit disk with four holes in a tilted plane. */
vtkSmartPointer<vtkUnstructuredGrid> TiltedDisk()
{
  auto mesh = TestInputs::DrilledDisk();
  for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i)
  {
    const double* point = mesh->GetPoint(i);
    mesh->GetPoints()->SetPoint(i, point[0], 0.8 * point[1], 0.6 * point[1]);
  }
  return mesh;
}

TEST(UnusedPointsOfMesh, CrossField)
{
  vtkNew<vtkPerforatedCrossField> filter;
  ExpectIgnored(filter, TestInputs::DrilledDisk());
  ExpectIgnored(filter, TiltedDisk());
  filter->SetMethodToUnitNorm();
  ExpectIgnored(filter, TiltedDisk());
}

TEST(UnusedPointsOfMesh, GinzburgLandau)
{
  vtkNew<vtkGinzburgLandauCrossField> filter;
  ExpectIgnored(
    filter, TestInputs::Drill(TestInputs::Loops({ TestInputs::Circle(40, 1.0) }), {}, 0.2));
}

TEST(UnusedPointsOfMesh, H)
{
  vtkNew<vtkHField> filter;
  ExpectIgnored(filter, TestInputs::DrilledDisk());
  ExpectIgnored(filter, TiltedDisk());
}

TEST(UnusedPointsOfMesh, Map)
{
  vtkNew<vtkCrossFieldMap> map;
  map->SetInputData(TestInputs::Loops({ TestInputs::Circle(40, 1.0) }));
  map->SetSingularitiesData(TestInputs::Singularities({ { 0.4, 0.4, 1.0, 0.1 },
    { -0.4, 0.4, 1.0, 0.1 }, { -0.4, -0.4, 1.0, 0.1 }, { 0.4, -0.4, 1.0, 0.1 } }));
  map->SetMeshSize(0.1);
  FilterChecks::UpdateWithoutError(map);
  vtkNew<vtkSeparatrices> lines;
  ExpectIgnored(lines, map->GetOutput());
}

TEST(UnusedPointsOfMesh, ReadersOfAField)
{
  vtkNew<vtkPerforatedCrossField> solver;
  solver->SetInputData(TiltedDisk());
  FilterChecks::UpdateWithoutError(solver);
  vtkNew<vtkCrossFieldSingularities> finder;
  finder->IncludeHolesOn();
  ExpectIgnored(finder, solver->GetOutput());
  vtkNew<vtkPoincareHopfCheck> check;
  ExpectIgnored(check, solver->GetOutput());
  vtkNew<vtkCrossGlyphs> glyphs;
  ExpectIgnored(glyphs, solver->GetOutput());
  glyphs->SetSpacing(0.2);
  ExpectIgnored(glyphs, solver->GetOutput());
}
}
