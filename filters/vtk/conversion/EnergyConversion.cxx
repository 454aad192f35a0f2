#include "EnergyConversion.h"

#include "ColumnWriting.h"
#include "vtkCrossFieldArrayNames.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <cmath>
#include <limits>

namespace
{
namespace names = vtkCrossFieldArrayNames;
using ColumnWriting::AddColumn;
using crossfield::ConfigurationEnergy;

/** Returns the defect of largest magnitude, with its sign. */
double LargestDefect(const std::vector<double>& defects)
{
  double largest = 0.0;
  for (double defect : defects)
  {
    largest = std::abs(defect) > std::abs(largest) ? defect : largest;
  }
  return largest;
}

/** Singularity with the derivative of W with respect to its position. */
struct GradientRow
{
  crossfield::Point position;
  int configuration;
  int quarterIndex;
  crossfield::Point gradient;
};
}

namespace EnergyConversion
{
//------------------------------------------------------------------------------
void WriteEnergies(const std::vector<ConfigurationEnergy>& energies, vtkTable* output)
{
  vtkFieldData* data = output->GetRowData();
  AddColumn<vtkIntArray>(data, names::Configuration, energies,
    [](const ConfigurationEnergy& energy) { return energy.configuration; });
  AddColumn<vtkIntArray>(data, names::Consistent, energies,
    [](const ConfigurationEnergy& energy) { return energy.consistent ? 1 : 0; });
  const auto add = [&](const char* name, auto value)
  {
    AddColumn<vtkDoubleArray>(data, name, energies,
      [&value](const ConfigurationEnergy& energy)
      { return energy.consistent ? value(energy) : std::numeric_limits<double>::quiet_NaN(); });
  };
  const auto addPerforated = [&](const char* name, auto value)
  {
    add(name,
      [&value](const ConfigurationEnergy& energy)
      {
        return energy.perforated ? value(*energy.perforated)
                                 : std::numeric_limits<double>::quiet_NaN();
      });
  };
  using Perforated = crossfield::PerforatedEnergy;
  addPerforated(names::Energy, [](const Perforated& e) { return e.Aligned(); });
  addPerforated(names::EnergyLowerBound, [](const Perforated& e) { return e.alignedLower; });
  addPerforated(names::EnergyUpperBound, [](const Perforated& e) { return e.alignedUpper; });
  addPerforated(names::EnergyDegreeOnly, [](const Perforated& e) { return e.DegreeOnly(); });
  addPerforated(
    names::EnergyDegreeOnlyLowerBound, [](const Perforated& e) { return e.degreeOnlyLower; });
  addPerforated(
    names::EnergyDegreeOnlyUpperBound, [](const Perforated& e) { return e.degreeOnlyUpper; });
  using Energy = ConfigurationEnergy;
  add(names::LogarithmCoefficient,
    [](const Energy& e) { return e.renormalized.logarithmCoefficient; });
  add(names::RenormalizedEnergy, [](const Energy& e) { return e.renormalized.energy; });
  add(names::CoreRadius, [](const Energy& e) { return e.coreRadius; });
  add(names::EnergyAtCoreRadius, [](const Energy& e) { return e.atCoreRadius; });
  add(names::HolonomyDefect,
    [](const Energy& e) { return LargestDefect(e.renormalized.holonomyDefect); });
}

//------------------------------------------------------------------------------
void WriteGradients(const std::vector<ConfigurationEnergy>& energies,
  const crossfield::DomainPlane& plane, vtkPolyData* output)
{
  std::vector<GradientRow> rows;
  for (const ConfigurationEnergy& energy : energies)
  {
    for (std::size_t i = 0; energy.consistent && i < energy.interior.size(); ++i)
    {
      rows.push_back(
        { energy.interior[i].position, energy.configuration, energy.interior[i].quarterIndex,
          energy.renormalized.gradient.col(static_cast<Eigen::Index>(i)) });
    }
  }
  ColumnWriting::WritePlaces(rows, plane, output);
  vtkFieldData* data = output->GetPointData();
  AddColumn<vtkIntArray>(
    data, names::Configuration, rows, [](const GradientRow& row) { return row.configuration; });
  AddColumn<vtkIntArray>(
    data, names::QuarterIndex, rows, [](const GradientRow& row) { return row.quarterIndex; });
  vtkNew<vtkDoubleArray> gradients;
  gradients->SetName(names::Gradient);
  gradients->SetNumberOfComponents(3);
  for (const GradientRow& row : rows)
  {
    gradients->InsertNextTuple(plane.DirectionToSpace(row.gradient).data());
  }
  data->AddArray(gradients);
}

//------------------------------------------------------------------------------
void WriteOptimizerReport(const crossfield::OptimizerResult& result, vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  ColumnWriting::AddNumbers(data, names::RenormalizedEnergyBefore, { result.energyBefore });
  ColumnWriting::AddNumbers(data, names::RenormalizedEnergyAfter, { result.energyAfter });
  if (result.sizeSpreads)
  {
    ColumnWriting::AddNumbers(data, names::SizeSpreadBefore, { result.sizeSpreads->before });
    ColumnWriting::AddNumbers(data, names::SizeSpreadAfter, { result.sizeSpreads->after });
    using crossfield::FrontPoint;
    AddColumn<vtkIntArray>(data, names::FrontSingularities, result.front,
      [](const FrontPoint& point) { return point.singularities; });
    AddColumn<vtkDoubleArray>(data, names::FrontSizeSpread, result.front,
      [](const FrontPoint& point) { return point.sizeSpread; });
    AddColumn<vtkDoubleArray>(data, names::FrontRenormalizedEnergy, result.front,
      [](const FrontPoint& point) { return point.energy; });
    AddColumn<vtkDoubleArray>(data, names::FrontHolonomyDefect, result.front,
      [](const FrontPoint& point) { return point.holonomyDefect; });
  }
  ColumnWriting::AddIntegers(data, names::Iterations, { result.iterations });
  ColumnWriting::AddIntegers(data, names::Converged, { result.converged ? 1 : 0 });
  ColumnWriting::AddNumbers(data, names::HolonomyDefect, result.holonomyDefect);
  vtkNew<vtkIntArray> pairs;
  pairs->SetName(names::Annihilation);
  pairs->SetNumberOfComponents(2);
  for (const auto& pair : result.annihilations)
  {
    pairs->InsertNextTuple2(pair[0], pair[1]);
  }
  data->AddArray(pairs);
  ColumnWriting::AddText(data, names::Reason, result.reason);
  AddColumn<vtkStringArray>(
    data, names::Events, result.events, [](const std::string& event) { return event; });
}

//------------------------------------------------------------------------------
void WriteEvents(const std::vector<std::string>& events, vtkDataObject* output)
{
  AddColumn<vtkStringArray>(
    output->GetFieldData(), names::Events, events, [](const std::string& event) { return event; });
}

//------------------------------------------------------------------------------
void WriteWarnings(const std::vector<std::string>& warnings, vtkDataObject* output)
{
  if (warnings.empty())
  {
    return;
  }
  AddColumn<vtkStringArray>(output->GetFieldData(), names::Warnings, warnings,
    [](const std::string& warning) { return warning; });
}

//------------------------------------------------------------------------------
void WriteHistory(const crossfield::OptimizerResult& result, vtkTable* output)
{
  using crossfield::OptimizerStep;
  vtkFieldData* data = output->GetRowData();
  int iteration = 0;
  AddColumn<vtkIntArray>(data, names::Iteration, result.history,
    [&iteration](const OptimizerStep&) { return iteration++; });
  const auto add = [&](const char* name, auto value)
  { AddColumn<vtkDoubleArray>(data, name, result.history, value); };
  add(names::RenormalizedEnergy, [](const OptimizerStep& step) { return step.energy; });
  add(names::GradientNorm, [](const OptimizerStep& step) { return step.gradientNorm; });
  add(names::HolonomyDefect, [](const OptimizerStep& step) { return step.holonomyDefect; });
  add(names::StepLength, [](const OptimizerStep& step) { return step.stepLength; });
}
}
