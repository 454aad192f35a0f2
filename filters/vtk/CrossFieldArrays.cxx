#include "CrossFieldArrays.h"

#include "ColumnWriting.h"
#include "CrossSamples.h"
#include "Error.h"
#include "SingularityRecord.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>

namespace
{
using ColumnWriting::AddIntegers;
using ColumnWriting::AddNumbers;
using crossfield::Complex;

vtkSmartPointer<vtkDoubleArray> NewArray(
  vtkFieldData* data, const char* name, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(tuples);
  array->Fill(0.0); // what points that no cell uses keep
  data->AddArray(array);
  return array;
}

/** The arrays that show one value of u per tuple. */
class ShownField
{
public:
  ShownField(const crossfield::DomainPlane& plane, vtkFieldData* data, vtkIdType tuples)
    : Plane(plane)
    , Representation(NewArray(data, vtkCrossFieldArrayNames::Representation, 3, tuples))
    , Cross(NewArray(data, vtkCrossFieldArrayNames::Cross, 3, tuples))
    , Cross2(NewArray(data, vtkCrossFieldArrayNames::Cross2, 3, tuples))
    , CrossNorm(NewArray(data, vtkCrossFieldArrayNames::CrossNorm, 1, tuples))
  {
  }

  void Set(vtkIdType tuple, const Complex& u)
  {
    const crossfield::Point branch = crossfield::CrossBranch(u);
    this->Representation->SetTuple3(tuple, u.real(), u.imag(), 0.0);
    this->Cross->SetTuple(tuple, this->Plane.DirectionToSpace(branch).data());
    this->Cross2->SetTuple(tuple, this->Plane.DirectionToSpace({ -branch.y(), branch.x() }).data());
    this->CrossNorm->SetTuple1(tuple, std::abs(u));
  }

private:
  const crossfield::DomainPlane& Plane;
  vtkSmartPointer<vtkDoubleArray> Representation;
  vtkSmartPointer<vtkDoubleArray> Cross;
  vtkSmartPointer<vtkDoubleArray> Cross2;
  vtkSmartPointer<vtkDoubleArray> CrossNorm;
};
}

namespace CrossFieldArrays
{
//------------------------------------------------------------------------------
void AddField(const DomainConversion::DrilledMesh& cells, const crossfield::CrossField& field,
  vtkUnstructuredGrid* output)
{
  const crossfield::CrossSamples samples =
    crossfield::SampleField(field.topology->mesh, field.topology->edges, field.u);

  ShownField points(cells.plane, output->GetPointData(), output->GetNumberOfPoints());
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    points.Set(cells.pointIds[i], samples.atVertices[static_cast<Eigen::Index>(i)]);
  }

  auto exact = NewArray(
    output->GetCellData(), vtkCrossFieldArrayNames::CrossFieldCR, 6, output->GetNumberOfCells());
  ShownField shown(cells.plane, output->GetCellData(), output->GetNumberOfCells());
  const auto setExact = [&](vtkIdType cell, Complex a, Complex b, Complex c)
  { exact->SetTuple6(cell, a.real(), a.imag(), b.real(), b.imag(), c.real(), c.imag()); };
  for (std::size_t t = 0; t < cells.triangleCells.size(); ++t)
  {
    const auto& edges = field.topology->edges.ofTriangle[t];
    setExact(cells.triangleCells[t], field.u[edges[0]], field.u[edges[1]], field.u[edges[2]]);
    shown.Set(cells.triangleCells[t], samples.atTriangles[static_cast<Eigen::Index>(t)]);
  }
  for (std::size_t i = 0; i < cells.lineCells.size(); ++i)
  {
    const Complex u = field.u[field.topology->edges.ofBoundary[i]];
    setExact(cells.lineCells[i], u, u, u);
    shown.Set(cells.lineCells[i], u);
  }
  for (std::size_t i = 0; i < cells.imprintedCells.size(); ++i)
  {
    const Complex u = field.u[field.topology->edges.ofImprinted[i]];
    setExact(cells.imprintedCells[i], u, u, u);
    shown.Set(cells.imprintedCells[i], u);
  }
  // What ParaView colours a new field by.
  output->GetPointData()->SetActiveScalars(vtkCrossFieldArrayNames::CrossNorm);
}

//------------------------------------------------------------------------------
crossfield::CrossField ReadField(
  const DomainConversion::DrilledMesh& cells, vtkUnstructuredGrid* input)
{
  vtkDataArray* exact = input->GetCellData()->GetArray(vtkCrossFieldArrayNames::CrossFieldCR);
  if (exact == nullptr || exact->GetNumberOfComponents() != 6)
  {
    throw crossfield::Error("The mesh has no cell array 'CrossFieldCR' with 6 components; give a "
                            "field made by one of the cross field filters.");
  }
  const crossfield::EdgeNumbering& edges = cells.topology->edges;
  crossfield::ComplexVector u = crossfield::ComplexVector::Zero(edges.Count());
  for (std::size_t t = 0; t < cells.triangleCells.size(); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      u[edges.ofTriangle[t][static_cast<std::size_t>(i)]] =
        Complex(exact->GetComponent(cells.triangleCells[t], 2 * i),
          exact->GetComponent(cells.triangleCells[t], 2 * i + 1));
    }
  }
  return { cells.topology, std::move(u) };
}

//------------------------------------------------------------------------------
void AddReport(const crossfield::SolvedField& field, vtkUnstructuredGrid* output)
{
  namespace names = vtkCrossFieldArrayNames;
  vtkFieldData* data = output->GetFieldData();
  AddNumbers(data, names::Energy, { field.energy });
  AddIntegers(data, names::Iterations, { field.iterations });
  AddNumbers(data, names::Residual, { field.residual });
  AddIntegers(data, names::Converged, { field.converged ? 1 : 0 });
  AddIntegers(data, names::StartedFromUnitNorm, { field.startedFromUnitNorm ? 1 : 0 });
  AddIntegers(data, names::UnitHoles, { field.unitHoles ? 1 : 0 });
  ColumnWriting::AddColumn<vtkIntArray>(data, names::HoleDegree, field.holes,
    [](const crossfield::HoleReading& hole) { return hole.degree; });
  ColumnWriting::AddColumn<vtkIntArray>(data, names::HoleDegreeReliable, field.holes,
    [](const crossfield::HoleReading& hole) { return hole.Reliable() ? 1 : 0; });
  auto norms = NewArray(data, names::HoleNormRange, 2, static_cast<vtkIdType>(field.holes.size()));
  for (std::size_t i = 0; i < field.holes.size(); ++i)
  {
    norms->SetTuple2(
      static_cast<vtkIdType>(i), field.holes[i].minimumNorm, field.holes[i].maximumNorm);
  }
  AddIntegers(data, names::DegreesReached, { field.degreesReached ? 1 : 0 });
  AddIntegers(data, names::UnwantedSingularities, { field.unwantedSingularities });
  AddIntegers(data, names::EulerCharacteristic, { field.count.eulerCharacteristic });
  AddNumbers(data, names::Valence, { field.count.valence });
  AddNumbers(data, names::TangentTurning, { field.count.tangentTurning });
  AddIntegers(data, names::RequiredInteriorQuarters, { field.count.requiredInteriorQuarters });
  AddIntegers(data, names::GivenInteriorQuarters, { field.count.givenInteriorQuarters });
  AddIntegers(data, names::Consistent, { field.count.Consistent() ? 1 : 0 });
  for (const char* name : { names::HolonomyDefect, names::Epsilon, names::GradientEnergy,
         names::PenaltyEnergy, names::ConvexifiedSteps, names::PointSingularities })
  {
    data->RemoveArray(name); // of a field that the mesh carried before
  }
  if (field.epsilon > 0.0)
  {
    AddNumbers(data, names::Epsilon, { field.epsilon });
    AddNumbers(data, names::GradientEnergy, { field.gradientEnergy });
    AddNumbers(data, names::PenaltyEnergy, { field.penaltyEnergy });
  }
  if (!field.holonomyDefect.empty())
  {
    AddNumbers(data, names::HolonomyDefect, field.holonomyDefect);
  }
}

//------------------------------------------------------------------------------
void AddConvexifiedSteps(int steps, vtkUnstructuredGrid* output)
{
  AddIntegers(output->GetFieldData(), vtkCrossFieldArrayNames::ConvexifiedSteps, { steps });
}

//------------------------------------------------------------------------------
void AddH(const DomainConversion::DrilledMesh& cells, const crossfield::HField& field,
  const crossfield::Configuration& configuration, vtkUnstructuredGrid* output)
{
  namespace names = vtkCrossFieldArrayNames;
  const vtkIdType count = output->GetNumberOfPoints();
  auto h = NewArray(output->GetPointData(), names::H, 1, count);
  auto sizes = NewArray(output->GetPointData(), names::SizeMap, 1, count);
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    const double value = field.h[static_cast<Eigen::Index>(i)];
    h->SetValue(cells.pointIds[i], value);
    sizes->SetValue(cells.pointIds[i], std::exp(value));
  }
  output->GetPointData()->SetActiveScalars(names::SizeMap);
  if (field.periods.empty())
  {
    AddNumbers(output->GetFieldData(), names::HolonomyDefect, {});
  }
  output->GetFieldData()->RemoveArray(names::RenormalizedEnergy); // of another field
  if (!std::isnan(field.renormalizedEnergy))
  {
    AddNumbers(output->GetFieldData(), names::RenormalizedEnergy, { field.renormalizedEnergy });
    SingularityRecord::Write(
      names::PointSingularities, configuration, cells.plane, output->GetFieldData());
  }
}

//------------------------------------------------------------------------------
Eigen::VectorXd ReadOnTriangles(
  const DomainConversion::DrilledMesh& cells, const std::string& name, vtkUnstructuredGrid* input)
{
  Eigen::VectorXd values;
  if (name.empty())
  {
    return values;
  }
  vtkDataArray* array = input->GetCellData()->GetArray(name.c_str());
  if (array == nullptr || array->GetNumberOfComponents() != 1)
  {
    throw crossfield::Error("The mesh has no cell array '" + name +
      "' with one component; add it, or leave the name empty.");
  }
  values.resize(static_cast<Eigen::Index>(cells.triangleCells.size()));
  for (std::size_t t = 0; t < cells.triangleCells.size(); ++t)
  {
    values[static_cast<Eigen::Index>(t)] = array->GetComponent(cells.triangleCells[t], 0);
  }
  return values;
}
}
