#include "CommandLine.h"

#include "DomainReader.h"
#include "NumberCheck.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldArraySets.h"

#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

namespace
{
/** Values of --mode, in the order of the codes of vtkDrillHoles. */
const std::vector<std::string> DrillModes = { "perforate", "imprint", "triangle" };
}

void MeshOptions::AddTo(CLI::App& command)
{
  command.add_option("DOMAIN", this->domain, DomainReader::Help)->required();
  AddSingularitiesTo(command, this->singularities);
  command.add_option(
    "-o,--output", this->output, "write the result to this .vtu file, or to standard output for -");
  AddSizeTo(command, this->size);
  this->boundary.AddTo(command);
}

CLI::Option* AddSingularitiesTo(CLI::App& command, std::string& file, const std::string& fallback)
{
  return command.add_option("-s,--singularities", file,
    "singularities: a .csv file with the header x,y,quarter_index[,radius], a .vtp file, or - for "
    "standard input; default: " +
      fallback);
}

void AddSizeTo(CLI::App& command, double& size)
{
  command
    .add_option("--size", size,
      "target edge length of the triangle mesh, positive; default: 1/40 of the domain's diagonal")
    ->check(NumberCheck::Positive());
}

void AddCornersTo(CLI::App& command, std::string& corners)
{
  command.add_option("--corners", corners,
    "quarter indices of the corners: a .vtp file from `crossfield corners`, or a .csv file; "
    "default: "
    "from the angle of each corner");
}

void AddSaveSingularitiesTo(CLI::App& command, std::string& file)
{
  command.add_option("--save-singularities", file,
    "write the singularities that were used, given or chosen, to this .csv file, or to standard "
    "output for -");
}

void AddJsonTo(CLI::App& command, std::string& json)
{
  command.add_option("--json", json,
    "write the numbers of the run as JSON to this file, or to standard output for -");
}

void AddVerboseTo(CLI::App& command, bool& verbose)
{
  command.add_flag("--verbose", verbose,
    "print more than the result: how singularities were chosen and moved, and further measures, which "
    "--json has as well");
}

void AddModeTo(CLI::App& command, std::string& mode)
{
  command
    .add_option("--mode", mode,
      "how a singularity enters the mesh: perforate cuts out a hole; imprint makes a circle of "
      "edges "
      "and keeps its inside; triangle uses the edges of the triangle that contains it")
    ->capture_default_str()
    ->check(CLI::IsMember(DrillModes));
}

void AddCoreRadiusTo(CLI::App& command, double& radius)
{
  command
    .add_option("--core-radius", radius,
      "radius of the cores for which the energies of configurations are compared, not negative; "
      "default: 1/100 of the domain's diagonal")
    ->check(NumberCheck::NotNegative());
}

void AddClearanceTo(CLI::App& command, double& clearance, const std::string& fallback)
{
  command
    .add_option("--clearance", clearance,
      "minimum distance of the chosen singularities to the boundary and to each other, not "
      "negative; "
      "default: " +
        fallback)
    ->check(NumberCheck::NotNegative());
}

void AddPairsTo(CLI::App& command, int& pairs)
{
  command
    .add_option("--pairs", pairs,
      "maximum number of pairs of quarter indices 1 and -1 to add where they make sizes more "
      "uniform, "
      "0 to 100; default: 0")
    ->transform(NumberCheck::Whole(0, 100));
}

void AddCapCornersTo(CLI::App& command, bool& cap, const std::string& names)
{
  command.add_flag(names, cap,
    std::string("treat very sharp corners (quarter index 2) as ordinary ones (quarter index 1), "
                "with one quad; "
                "given singularities must add up accordingly; default: ") +
      (cap ? "on" : "off"));
}

void AddRepairHolonomyTo(CLI::App& command, bool& repair)
{
  command.add_flag("--repair-holonomy", repair,
    "move the singularities slightly so that grid lines close up around each hole");
}

void AddFeatureAngleTo(CLI::App& command, double& angle)
{
  command
    .add_option("--feature-angle", angle,
      "of a surface in space: quads follow edges whose triangles' normals differ by more degrees; 180: "
      "none; default: 35")
    ->check(NumberCheck::NotNegative());
}

void AddArraysTo(CLI::App& command, int& arrays)
{
  const std::vector<std::pair<std::string, int>> sets = { { "exact",
                                                            vtkCrossFieldArraySets::Exact },
    { "display", vtkCrossFieldArraySets::Display }, { "all", vtkCrossFieldArraySets::All } };
  command
    .add_option("--arrays", arrays,
      "arrays to write: exact, only the field itself, which is all that other subcommands need; "
      "display, also the crosses, their norm and the size field; all, also the arrays that follow "
      "from these; default: all")
    ->transform(NumberCheck::Word(sets))
    ->type_name("TEXT");
}

int DrillModeCode(const std::string& mode)
{
  return static_cast<int>(
    std::find(DrillModes.begin(), DrillModes.end(), mode) - DrillModes.begin());
}

double FieldValue(vtkDataObject* data, const char* name)
{
  return data->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

std::string FieldText(vtkDataObject* data, const char* name)
{
  return vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray(name))->GetValue(0);
}

void PrintEvents(vtkDataObject* data)
{
  auto* events = vtkStringArray::SafeDownCast(
    data->GetFieldData()->GetAbstractArray(vtkCrossFieldArrayNames::Events));
  for (vtkIdType i = 0; events != nullptr && i < events->GetNumberOfValues(); ++i)
  {
    std::cout << events->GetValue(i) << "\n";
  }
}

void PrintAmbiguous(vtkFieldData* data)
{
  if (vtkDataArray* corners = data->GetArray(vtkCrossFieldArrayNames::AmbiguousCorners))
  {
    const double count = corners->GetTuple1(0);
    std::cout << count << (count == 1.0 ? " corner turns" : " corners turn")
              << " by 45 or 135 degrees within 1 degree: the quarter index there is ambiguous\n";
  }
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
