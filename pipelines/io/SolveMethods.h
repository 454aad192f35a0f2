#ifndef SolveMethods_h
#define SolveMethods_h

#include "CommandLine.h"
#include "vtkCrossFieldArraySets.h"

#include <string>
#include <vector>

class vtkGinzburgLandauCrossField;
class vtkPerforatedCrossField;
class vtkUnstructuredGrid;

/** Options of `crossfield solve`. */
struct SolveOptions : MeshOptions
{
  std::string method; ///< If empty, DefaultMethod chooses.
  std::string start = "best";
  std::string mode = "perforate";
  bool unitHoles = false;
  std::vector<int> unitHoleRows;
  bool globalConstraint = false;
  double epsilon = 0.0;
  std::string corners;
  std::string json;
  std::string savedSingularities;
  bool strict = false;
  int arrays = vtkCrossFieldArraySets::All;
};

/**
 * Methods of `crossfield solve` and the options that belong to each. The Ginzburg-Landau method is
 * the reference: it has no holes and places the singularities itself.
 */
namespace SolveMethods
{
const char* const Reference = "ginzburg-landau";

/** Returns the values of --start of all methods. */
std::vector<std::string> AllStarts();

/** Returns the method if none was named: constrained if there are options that only it has, else
 * unit-norm. */
std::string DefaultMethod(const SolveOptions& options);

/** Throws CLI::ValidationError if an option does not belong to the method. */
void CheckUsage(const SolveOptions& options);

/** Pass the options to a solver. */
///@{
void Configure(const SolveOptions& options, vtkPerforatedCrossField* solver);
void Configure(const SolveOptions& options, vtkGinzburgLandauCrossField* solver);
///@}

/** Print energy, convergence and singularities of a field. */
///@{
void PrintSummary(vtkUnstructuredGrid* field);
void PrintReferenceSummary(vtkUnstructuredGrid* field);
///@}
}

#endif
