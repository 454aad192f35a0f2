#ifndef EnergyJson_h
#define EnergyJson_h

#include <string>
#include <vector>

class vtkDataSet;
class vtkSingularityEnergy;
class vtkSingularityOptimizer;

/** The results of the energy filters as JSON; each function says in which shape. */
namespace EnergyJson
{
/**
 * The list `configurations`, one object per row of the table with the file that it came from, and
 * the list `gradient` of its interior singularities. Of inconsistent ones only file and flag. Unless
 * null, what was chosen, as in ReportJson.h.
 */
std::string Write(
  vtkSingularityEnergy* energy, const std::vector<std::string>& files, vtkDataSet* chosen);

/** The report of the optimiser with its singularities, annihilations and reason. */
std::string Write(vtkSingularityOptimizer* optimizer);
}

#endif
