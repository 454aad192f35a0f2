#ifndef CommandLine_h
#define CommandLine_h

#include "BoundaryInput.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}
class vtkDataObject;
class vtkUnstructuredGrid;

/** Exit statuses of the program. */
enum ExitStatus
{
  Done = 0,
  AnswerIsNo = 1,
  BadInput = 2
};

/** The subcommands; each sets `status` when it has run. */
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

/** Options that several subcommands share. */
struct MeshOptions
{
  BoundaryOptions boundary;
  std::string domain;
  std::string singularities;
  std::string output;
  double size = 0.0;

  void AddTo(CLI::App& command);
};

/** Adds the option --corners. */
void AddCornersTo(CLI::App& command, std::string& corners);

/** Adds the option --save-singularities. */
void AddSaveSingularitiesTo(CLI::App& command, std::string& file);

/** Adds the option --json. */
void AddJsonTo(CLI::App& command, std::string& json);

/** Names of the modes of vtkDrillHoles, in the order of its codes. */
const std::vector<std::string>& DrillModes();

/** Adds the option --mode. */
void AddModeTo(CLI::App& command, std::string& mode);

/** The code of a mode. */
int DrillModeCode(const std::string& mode);

/** Adds the option --arrays; `arrays` is one of vtkCrossFieldArraySets. */
void AddArraysTo(CLI::App& command, int& arrays);

/** The first, or only, value of an array of field data, which must be there. */
double FieldValue(vtkDataObject* data, const char* name);

/** Number of triangles among the cells of a drilled mesh. */
long long CountTriangles(vtkUnstructuredGrid* mesh);

#endif
