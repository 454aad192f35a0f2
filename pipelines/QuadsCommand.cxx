/**
 * crossfield quads DOMAIN [-s S.csv] -o Q.vtu: an all-quad mesh with exactly the chosen irregular
 * nodes.
 *
 *   crossfield quads builtin:disk -s four.csv -o quads.vtu --quads 1000 --blocks blocks.vtm --json
 *   -
 */
#include "BoundaryInput.h"
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "ReportJson.h"
#include "SingularityInput.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkQuadMesher.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <iostream>
#include <memory>

namespace
{
namespace names = vtkCrossFieldArrayNames;
using Json = nlohmann::ordered_json;

struct QuadsOptions
{
  BoundaryOptions boundary;
  std::string domain;
  std::string singularities;
  std::string corners;
  std::string output;
  std::string blocks;
  std::string layout;
  std::string json;
  std::string savedSingularities;
  double size = 0.0;
  double meshSize = 0.0;
  int quads = 1000;
  bool countIsGiven = false;
  std::vector<std::string> sizing = { "conformal" };
  bool coarse = false;
  double clearance = 0.0;
  int pairs = 0;
  bool capCorners = true;
  bool repairHolonomy = false;
};

double Value(vtkUnstructuredGrid* quads, const char* name, vtkIdType i = 0)
{
  return quads->GetFieldData()->GetArray(name)->GetTuple1(i);
}

/** Returns the singularities that the mesh was made of, at their positions after repair. */
vtkDataSet* Singularities(vtkQuadMesher* mesher)
{
  return vtkDataSet::SafeDownCast(mesher->GetOutputDataObject(3));
}

/** Returns the numbers of nodes by valence. */
Json ByValence(vtkUnstructuredGrid* quads, const char* name)
{
  Json counts = Json::object();
  vtkDataArray* valences = quads->GetFieldData()->GetArray(names::IrregularValence);
  for (vtkIdType i = 0; i < valences->GetNumberOfTuples(); ++i)
  {
    const auto count = static_cast<int>(Value(quads, name, i));
    if (count > 0)
    {
      counts[std::to_string(static_cast<int>(valences->GetTuple1(i)))] = count;
    }
  }
  return counts;
}

std::string WriteJson(vtkQuadMesher* mesher)
{
  vtkUnstructuredGrid* quads = mesher->GetOutput();
  const auto count = [quads](const char* name)
  { return static_cast<long long>(Value(quads, name)); };
  Json report = Json::object();
  report["quads"] = count(names::Quads);
  report["irregular"] = ByValence(quads, names::IrregularObtained);
  report["asked"] = ByValence(quads, names::IrregularRequested);
  report["blocks"] = count(names::Blocks);
  report["scaled_jacobian"] = { { "min", Value(quads, names::ScaledJacobianRange) },
    { "mean", Value(quads, names::ScaledJacobianRange, 1) },
    { "bound", Value(quads, names::ScaledJacobianBound) } };
  report["eta"] = { { "min", Value(quads, names::EtaRange) },
    { "mean", Value(quads, names::EtaRange, 1) } };
  report["sizes"] = { { "min", Value(quads, names::SizeRange) },
    { "mean", Value(quads, names::SizeRange, 1) }, { "max", Value(quads, names::SizeRange, 2) } };
  report["size_variation"] = Value(quads, names::SizeVariation);
  report["zero_arcs"] = count(names::ZeroArcs);
  const double* seconds = mesher->GetStageSeconds();
  report["integers"] = { { "variables", count(names::IntegerVariables) }, { "seconds", seconds[3] },
    { "optimal", count(names::IntegerOptimal) != 0 }, { "gap", Value(quads, names::IntegerGap) } };
  report["inverted"] = count(names::Inverted);
  report["moved"] = Value(quads, names::Moved);
  report["seconds"] = { { "mesh", seconds[0] }, { "map", seconds[1] }, { "trace", seconds[2] },
    { "integers", seconds[3] }, { "layout", seconds[4] }, { "smooth", seconds[5] },
    { "choose", seconds[6] } };
  ReportJson::AddRepair(report, quads->GetFieldData());
  ReportJson::AddSingularities(report, Singularities(mesher), DomainReader::HasHeight(quads));
  return report.dump(2) + "\n";
}

void SetSizing(const QuadsOptions& options, vtkQuadMesher* mesher)
{
  const std::string& sizing = options.sizing[0];
  if (sizing == "field")
  {
    mesher->SetSizingToField();
    mesher->SetSizeArray(options.sizing[1]);
    mesher->SetQuadSize(options.countIsGiven ? 0.0 : 1.0); // factor of the array's lengths
  }
  else
  {
    sizing == "uniform" ? mesher->SetSizingToUniform() : mesher->SetSizingToConformal();
  }
}

/** Returns what is wrong with the words after --sizing; empty if nothing is. */
std::string CheckSizing(const QuadsOptions& options)
{
  const std::string& sizing = options.sizing[0];
  if (sizing != "conformal" && sizing != "uniform" && sizing != "field")
  {
    return "--sizing: there is no '" + sizing + "'; give conformal, uniform or field NAME";
  }
  if (options.sizing.size() != (sizing == "field" ? 2U : 1U))
  {
    return "--sizing: give conformal, uniform, or field and the name of a point array of the domain";
  }
  return sizing == "field" && options.size > 0.0
    ? "--sizing field has the sizes in the array; leave --size out, or give --quads"
    : "";
}

int Mesh(const QuadsOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable({ { options.output, ".vtu" }, { options.blocks, ".vtm" },
    { options.layout, ".vtp" }, { options.json, "" }, { options.savedSingularities, ".csv" } });

  // 2. Read the domain and the configuration.
  const auto domain = BoundaryInput::Open(options.domain, options.meshSize, options.boundary);
  vtkNew<vtkQuadMesher> mesher;
  mesher->SetInputConnection(domain->GetOutputPort());
  mesher->SetQuadSize(options.size);
  mesher->SetQuadCount(options.quads);
  SetSizing(options, mesher);
  mesher->SetCoarse(options.coarse);
  mesher->SetMeshSize(options.meshSize);
  mesher->SetCapCorners(options.capCorners);
  mesher->SetRepairHolonomy(options.repairHolonomy);
  mesher->SetPairs(options.pairs);
  mesher->SetClearance(options.clearance);
  if (!options.singularities.empty())
  {
    mesher->SetSingularitiesConnection(
      OpenPointsOf(domain, options.singularities)->GetOutputPort());
  }
  if (!options.corners.empty())
  {
    mesher->SetCornersConnection(OpenPointsOf(domain, options.corners)->GetOutputPort());
  }

  // 3. Mesh.
  PipelineRun::Update(mesher, "meshing");
  vtkUnstructuredGrid* quads = mesher->GetOutput();

  // 4. Write.
  OutputTransaction outputs;
  OutputFile::WriteIfNamed(quads, options.output, outputs);
  OutputFile::WriteIfNamed(mesher->GetOutputDataObject(2), options.layout, outputs);
  if (!options.blocks.empty())
  {
    auto* grids = vtkMultiBlockDataSet::SafeDownCast(mesher->GetOutputDataObject(1));
    OutputFile::Blocks blocks;
    for (unsigned int b = 0; b < grids->GetNumberOfBlocks(); ++b)
    {
      blocks.emplace_back("block" + std::to_string(b), grids->GetBlock(b));
    }
    OutputFile::WriteBlocks(blocks, options.blocks, outputs);
  }
  const bool hasHeight =
    DomainReader::HasHeight(vtkDataSet::SafeDownCast(domain->GetOutputDataObject(0)));
  if (!options.savedSingularities.empty())
  {
    OutputFile::WriteConfiguration(
      Singularities(mesher), hasHeight, options.savedSingularities, outputs);
  }
  if (!options.json.empty())
  {
    outputs.Write(BoundaryInput::AddTo(WriteJson(mesher), domain), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    PrintRepair(quads->GetFieldData());
    if (options.singularities.empty())
    {
      PrintChosen(Singularities(mesher), hasHeight);
    }
    std::cout << Value(quads, names::Quads) << " quads in " << Value(quads, names::Blocks)
              << " blocks, irregular nodes by valence "
              << ByValence(quads, names::IrregularObtained).dump() << ", least scaled Jacobian "
              << Value(quads, names::ScaledJacobianRange) << " (attainable "
              << Value(quads, names::ScaledJacobianBound) << ")\n";
  }
  outputs.Commit();
  return Value(quads, names::Inverted) > 0.0 ? AnswerIsNo : Done;
}
}

void AddQuadsCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<QuadsOptions>();
  CLI::App* command = app.add_subcommand(
    "quads", "make an all-quad mesh with exactly the chosen irregular nodes, and its blocks");
  command->footer(
    "Example: crossfield quads builtin:disk -s four.csv -o quads.vtu --quads 1000 --json -");
  command->add_option("DOMAIN", options->domain, "a file, or builtin:NAME")->required();
  options->boundary.AddTo(*command);
  command->add_option("-s,--singularities", options->singularities,
    "singularities: .csv with the header x,y,quarter_index, or .vtp, or - for standard input; left out: "
    "chosen for the domain");
  command->add_option("-o,--output", options->output, "the .vtu file to write, with the quads")
    ->required();
  CLI::Option* size = command->add_option("--size", options->size, "mean side length of quads")
                        ->check(CLI::PositiveNumber);
  CLI::Option* count =
    command->add_option("--quads", options->quads, "target number of quads; default 1000")
      ->check(CLI::PositiveNumber)
      ->excludes(size);
  command
    ->add_option("--sizing", options->sizing,
      "conformal: sizes of the field, the best shapes; uniform: the same everywhere, singularities may move; "
      "field NAME: the lengths in a point array of the domain, with --quads their proportions")
    ->expected(1, 2)
    ->type_name("WORD");
  command->add_flag("--coarse", options->coarse, "the smallest number of blocks with sound quads");
  command
    ->add_option(
      "--mesh-size", options->meshSize, "edge length of the triangles on which the map is solved")
    ->check(CLI::PositiveNumber);
  command->add_option("--blocks", options->blocks, "write the structured blocks to this .vtm file");
  command->add_option("--layout", options->layout, "write the layout to this .vtp file");
  command
    ->add_option("--clearance", options->clearance,
      "minimum distance of chosen singularities to the boundary and to each other; default: 0.7 of the size of "
      "quads")
    ->check(CLI::PositiveNumber);
  command
    ->add_option("--pairs", options->pairs,
      "maximum number of pairs of quarter indices 1 and -1 that are added to chosen singularities where they make "
      "sizes more uniform")
    ->check(CLI::Range(0, 100));
  command->add_flag("--cap-corners,!--no-cap-corners", options->capCorners,
    "give sharp corners of quarter index 2 index 1; given singularities must make up for it; default: on");
  command->add_flag("--repair-holonomy", options->repairHolonomy,
    "move the singularities by the smallest distances after which no inner loop has a holonomy defect");
  AddCornersTo(*command, options->corners);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddJsonTo(*command, options->json);
  command->callback(
    [options, count, &status]
    {
      options->countIsGiven = count->count() > 0;
      const std::string problem = CheckSizing(*options);
      if (!problem.empty())
      {
        throw CLI::ValidationError(problem);
      }
      status = Mesh(*options);
    });
}
