#ifndef EnergyConversion_h
#define EnergyConversion_h

#include "ConfigurationEnergy.h"
#include "SingularityOptimizer.h"

class vtkPolyData;
class vtkTable;

/** Conversion of energies of configurations and of the optimiser's report to VTK data. */
namespace EnergyConversion
{
/** One row per configuration; see vtkSingularityEnergy. */
void WriteEnergies(const std::vector<crossfield::ConfigurationEnergy>& energies, vtkTable* output);

/** Points with `Configuration`, `QuarterIndex` and `Gradient`, in the plane of the given z. */
void WriteGradients(const std::vector<crossfield::ConfigurationEnergy>& energies, double z,
  vtkPolyData* output);

/** Field data; see vtkSingularityOptimizer. */
void WriteOptimizerReport(const crossfield::OptimizerResult& result, vtkPolyData* output);

/** One row per iteration; see vtkSingularityOptimizer. */
void WriteHistory(const crossfield::OptimizerResult& result, vtkTable* output);
}

#endif
