#include "CommandLine.h"

#include "DomainReader.h"
#include "vtkCrossFieldArraySets.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <map>

void MeshOptions::AddTo(CLI::App& command)
{
  command.add_option("DOMAIN", this->domain, DomainReader::Help)->required();
  command.add_option("-s,--singularities", this->singularities,
    "configuration: .csv with the header x,y,quarter_index[,radius], or .vtp, or - for standard "
    "input; left out: chosen for the domain");
  command.add_option("-o,--output", this->output, "the .vtu file to write, or - for output");
  command.add_option(
    "--size", this->size, "target edge length; default: 1/40 of the domain's diagonal");
  this->boundary.AddTo(command);
}

void AddCornersTo(CLI::App& command, std::string& corners)
{
  command.add_option("--corners", corners,
    "quarter indices of corners: .vtp written by `crossfield corners`, or .csv");
}

void AddSaveSingularitiesTo(CLI::App& command, std::string& file)
{
  command.add_option("--save-singularities", file,
    "write the singularities, given or chosen, to this .csv file, or - for output");
}

void AddJsonTo(CLI::App& command, std::string& json)
{
  command.add_option("--json", json, "write the numbers to this file, or - for output");
}

const std::vector<std::string>& DrillModes()
{
  static const std::vector<std::string> modes = { "perforate", "imprint", "triangle" };
  return modes;
}

void AddModeTo(CLI::App& command, std::string& mode)
{
  command
    .add_option("--mode", mode,
      "what a singularity becomes: perforate, a hole; imprint, a circle of edges whose inside is "
      "kept; triangle, the edges of the one triangle at its place")
    ->capture_default_str()
    ->check(CLI::IsMember(DrillModes()));
}

int DrillModeCode(const std::string& mode)
{
  return static_cast<int>(
    std::find(DrillModes().begin(), DrillModes().end(), mode) - DrillModes().begin());
}

void AddArraysTo(CLI::App& command, int& arrays)
{
  const std::map<std::string, int> sets = { { "exact", vtkCrossFieldArraySets::Exact },
    { "display", vtkCrossFieldArraySets::Display }, { "all", vtkCrossFieldArraySets::All } };
  command
    .add_option("--arrays", arrays,
      "which arrays the file has: exact, the field itself, which is all that other subcommands need; "
      "display, also crosses, their norm and the size map, to look at; or all, also what follows from "
      "these; default: all")
    ->transform(CLI::CheckedTransformer(sets).description("{exact,display,all}"))
    ->type_name("TEXT");
}

double FieldValue(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

long long CountTriangles(vtkUnstructuredGrid* mesh)
{
  long long count = 0;
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfCells(); ++cell)
  {
    count += mesh->GetCellType(cell) == VTK_TRIANGLE ? 1 : 0;
  }
  return count;
}
