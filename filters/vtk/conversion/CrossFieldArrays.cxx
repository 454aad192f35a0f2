#include "CrossFieldArrays.h"

#include "ColumnWriting.h"
#include "CrossSamples.h"
#include "Error.h"
#include "SingularityRecord.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldArraySets.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace
{
using ColumnWriting::AddIntegers;
using ColumnWriting::AddNumbers;
using ColumnWriting::NewArray; // initially zero, as for points that no cell uses
using crossfield::Complex;

/** Display arrays of a field, with one value of u per tuple. */
class DisplayArrays
{
public:
  DisplayArrays(
    const crossfield::DomainPlane& plane, vtkFieldData* data, vtkIdType tuples, int arrays)
    : Plane(plane)
  {
    namespace names = vtkCrossFieldArrayNames;
    for (const char* name :
      { names::Representation, names::Cross, names::Cross2, names::CrossNorm })
    {
      data->RemoveArray(name); // from an earlier field of the mesh
    }
    const auto add = [data, tuples](const char* name, int components)
    { return NewArray<vtkFloatArray>(data, name, components, tuples)->GetPointer(0); };
    if (arrays >= vtkCrossFieldArraySets::All)
    {
      this->Representation = add(names::Representation, 3);
      this->Cross2 = add(names::Cross2, 3);
    }
    if (arrays >= vtkCrossFieldArraySets::Display)
    {
      this->Cross = add(names::Cross, 3);
      this->CrossNorm = add(names::CrossNorm, 1);
    }
  }

  void Set(vtkIdType tuple, const Complex& u)
  {
    if (this->Cross == nullptr)
    {
      return;
    }
    const crossfield::Point branch = crossfield::CrossBranch(u);
    this->SetDirection(this->Cross, tuple, branch);
    this->CrossNorm[tuple] = static_cast<float>(std::abs(u));
    if (this->Cross2 != nullptr)
    {
      this->SetDirection(this->Cross2, tuple, { -branch.y(), branch.x() });
      this->Representation[3 * tuple] = static_cast<float>(u.real());
      this->Representation[3 * tuple + 1] = static_cast<float>(u.imag());
    }
  }

private:
  void SetDirection(float* array, vtkIdType tuple, const crossfield::Point& direction)
  {
    Eigen::Map<Eigen::Vector3f>(array + 3 * tuple) =
      this->Plane.DirectionToSpace(direction).cast<float>();
  }

  const crossfield::DomainPlane& Plane;
  float* Representation = nullptr;
  float* Cross = nullptr;
  float* Cross2 = nullptr;
  float* CrossNorm = nullptr;
};
}

namespace CrossFieldArrays
{
//------------------------------------------------------------------------------
void AddField(const DrilledMeshConversion::DrilledMesh& cells, const crossfield::CrossField& field,
  int arrays, vtkUnstructuredGrid* output)
{
  const crossfield::CrossSamples samples =
    crossfield::SampleField(field.topology->mesh, field.topology->edges, field.u);

  DisplayArrays points(cells.plane, output->GetPointData(), output->GetNumberOfPoints(), arrays);
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    points.Set(cells.pointIds[i], samples.atVertices[static_cast<Eigen::Index>(i)]);
  }

  double* exact = NewArray<vtkDoubleArray>(
    output->GetCellData(), vtkCrossFieldArrayNames::CrossFieldCR, 6, output->GetNumberOfCells())
                    ->GetPointer(0);
  DisplayArrays shown(cells.plane, output->GetCellData(), output->GetNumberOfCells(), arrays);
  const auto setExact = [exact](vtkIdType cell, Complex a, Complex b, Complex c)
  {
    const double values[] = { a.real(), a.imag(), b.real(), b.imag(), c.real(), c.imag() };
    std::copy_n(values, 6, exact + 6 * cell);
  };
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
  // ParaView colours a new field by this array.
  output->GetPointData()->SetActiveScalars(vtkCrossFieldArrayNames::CrossNorm);
}

//------------------------------------------------------------------------------
crossfield::CrossField ReadField(
  const DrilledMeshConversion::DrilledMesh& cells, vtkUnstructuredGrid* input)
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
    std::array<double, 6> values = {};
    exact->GetTuple(cells.triangleCells[t], values.data());
    for (std::size_t i = 0; i < 3; ++i)
    {
      u[edges.ofTriangle[t][i]] = Complex(values[2 * i], values[2 * i + 1]);
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
  auto norms = NewArray<vtkDoubleArray>(
    data, names::HoleNormRange, 2, static_cast<vtkIdType>(field.holes.size()));
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
    data->RemoveArray(name); // from an earlier field of the mesh
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
void AddH(const DrilledMeshConversion::DrilledMesh& cells, const crossfield::HField& field,
  const crossfield::Configuration& configuration, int arrays, vtkUnstructuredGrid* output)
{
  namespace names = vtkCrossFieldArrayNames;
  const vtkIdType count = output->GetNumberOfPoints();
  output->GetPointData()->RemoveArray(names::SizeMap); // from an earlier field
  auto h = NewArray<vtkDoubleArray>(output->GetPointData(), names::H, 1, count);
  for (std::size_t i = 0; i < cells.pointIds.size(); ++i)
  {
    h->SetValue(cells.pointIds[i], field.h[static_cast<Eigen::Index>(i)]);
  }
  if (arrays >= vtkCrossFieldArraySets::Display)
  {
    auto sizes = NewArray<vtkFloatArray>(output->GetPointData(), names::SizeMap, 1, count);
    for (const vtkIdType point : cells.pointIds)
    {
      sizes->SetValue(point, static_cast<float>(std::exp(h->GetValue(point))));
    }
  }
  output->GetPointData()->SetActiveScalars(names::SizeMap);
  if (field.periods.empty())
  {
    AddNumbers(output->GetFieldData(), names::HolonomyDefect, {});
  }
  output->GetFieldData()->RemoveArray(names::RenormalizedEnergy); // from an earlier field
  if (!std::isnan(field.renormalizedEnergy))
  {
    AddNumbers(output->GetFieldData(), names::RenormalizedEnergy, { field.renormalizedEnergy });
    SingularityRecord::Write(
      names::PointSingularities, configuration, cells.plane, output->GetFieldData());
  }
}

//------------------------------------------------------------------------------
Eigen::VectorXd ReadOnTriangles(const DrilledMeshConversion::DrilledMesh& cells,
  const std::string& name, vtkUnstructuredGrid* input)
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
