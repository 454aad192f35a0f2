#ifndef CommandLine_h
#define CommandLine_h

#include "BoundaryInput.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}
class vtkDataObject;
class vtkFieldData;
class vtkUnstructuredGrid;

/** Exit statuses of the program. */
enum ExitStatus
{
  Done = 0,
  AnswerIsNo = 1,
  BadInput = 2
};

/** Add the subcommands; each sets `status` after its run. */
///@{
void AddCheckCommand(CLI::App& app, int& status);
void AddCompareCommand(CLI::App& app, int& status);
void AddCornersCommand(CLI::App& app, int& status);
void AddDomainCommand(CLI::App& app, int& status);
void AddDrillCommand(CLI::App& app, int& status);
void AddEnergyCommand(CLI::App& app, int& status);
void AddHFieldCommand(CLI::App& app, int& status);
void AddOptimizeCommand(CLI::App& app, int& status);
void AddFiguresCommand(CLI::App& app, int& status);
void AddQuadsCommand(CLI::App& app, int& status);
void AddSeparatricesCommand(CLI::App& app, int& status);
void AddSolveCommand(CLI::App& app, int& status);
///@}

/** Options of all subcommands that mesh a domain and read a configuration. */
struct MeshOptions
{
  BoundaryOptions boundary;
  std::string domain;
  std::string singularities;
  std::string output;
  double size = 0.0;
  bool verbose = false;

  void AddTo(CLI::App& command);
};

/** Options that several subcommands share; each function adds one of them. */
///@{
/** Adds -s; `fallback` describes what is used without it. */
CLI::Option* AddSingularitiesTo(
  CLI::App& command, std::string& file, const std::string& fallback = "chosen for the domain");
void AddSizeTo(CLI::App& command, double& size);
void AddCornersTo(CLI::App& command, std::string& corners);
void AddSaveSingularitiesTo(CLI::App& command, std::string& file);
void AddJsonTo(CLI::App& command, std::string& json);
/** Adds --verbose, which prints what the report has: how singularities were chosen, and more measures. */
void AddVerboseTo(CLI::App& command, bool& verbose);
void AddModeTo(CLI::App& command, std::string& mode);
void AddCoreRadiusTo(CLI::App& command, double& radius);
/** Adds --clearance; `fallback` is the default in words. */
void AddClearanceTo(CLI::App& command, double& clearance, const std::string& fallback);
void AddPairsTo(CLI::App& command, int& pairs);
/**
 * Adds the flag that sets `cap` and, if `names` has a second one, the flag that clears it; `names`
 * as for CLI11.
 */
void AddCapCornersTo(CLI::App& command, bool& cap, const std::string& names);
void AddRepairHolonomyTo(CLI::App& command, bool& repair);
void AddFeatureAngleTo(CLI::App& command, double& angle);
/** Adds --arrays; `arrays` is one of vtkCrossFieldArraySets. */
void AddArraysTo(CLI::App& command, int& arrays);
///@}

/** Returns the code of vtkDrillHoles for a value of --mode. */
int DrillModeCode(const std::string& mode);

/** Returns the first value of an array of field data, which must exist. */
double FieldValue(vtkDataObject* data, const char* name);

/** Returns the first text of an array of field data, which must exist. */
std::string FieldText(vtkDataObject* data, const char* name);

/** Prints the sentences in the array `Events` of the field data, if there are any. */
void PrintEvents(vtkDataObject* data);

/** Prints the field data `AmbiguousCorners`, if there are any. */
void PrintAmbiguous(vtkFieldData* data);

/** Returns the number of triangles among the cells of a mesh. */
long long CountTriangles(vtkUnstructuredGrid* mesh);

#endif
