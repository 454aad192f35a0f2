#ifndef EnergyConversion_h
#define EnergyConversion_h

#include "ConfigurationEnergy.h"
#include "DomainPlane.h"
#include "SingularityOptimizer.h"

class vtkDataObject;
class vtkPolyData;
class vtkTable;

/** Conversion of energies of configurations and of the optimiser's report to VTK data. */
namespace EnergyConversion
{
/** Writes one row per configuration; see vtkSingularityEnergy. */
void WriteEnergies(const std::vector<crossfield::ConfigurationEnergy>& energies, vtkTable* output);

/** Writes points with `Configuration`, `QuarterIndex` and `Gradient`, in the given plane. */
void WriteGradients(const std::vector<crossfield::ConfigurationEnergy>& energies,
  const crossfield::DomainPlane& plane, vtkPolyData* output);

/** Writes the field data of vtkSingularityOptimizer. */
void WriteOptimizerReport(const crossfield::OptimizerResult& result, vtkPolyData* output);

/** Writes the field data `Events`, one sentence each. */
void WriteEvents(const std::vector<std::string>& events, vtkDataObject* output);

/** Writes the field data `Warnings`, one sentence each; nothing if there are none. */
void WriteWarnings(const std::vector<std::string>& warnings, vtkDataObject* output);

/** Writes one row per iteration; see vtkSingularityOptimizer. */
void WriteHistory(const crossfield::OptimizerResult& result, vtkTable* output);
}

#endif
