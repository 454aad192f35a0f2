/**
 * crossfield separatrices DOMAIN -s S.csv -o LINES.vtp: the lines that leave the singularities of a cross
 * field, and the rectangles that they divide the domain into.
 *
 *   crossfield separatrices builtin:disk -s four.csv -o lines.vtp --faces faces.vtp --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "ReportJson.h"
#include "SingularityInput.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldMap.h"
#include "vtkSeparatrices.h"

#include "vtkAlgorithm.h"
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

struct SeparatricesOptions : MeshOptions
{
  std::string corners;
  std::string seeds;
  std::string faces;
  std::string map;
  std::string json;
  std::string savedSingularities;
  bool capCorners = false;
  bool repairHolonomy = false;
};

std::string WriteJson(vtkPolyData* lines, vtkCrossFieldMap* map, vtkSeparatrices* separatrices,
  vtkDataSet* singularities)
{
  const auto count = [lines](const char* name)
  { return static_cast<long long>(FieldValue(lines, name)); };
  nlohmann::ordered_json report = nlohmann::ordered_json::object();
  report["lines"] = count(names::Lines);
  report["faces"] = count(names::Faces);
  report["arcs"] = count(names::Arcs);
  report["extra_lines"] = count(names::ExtraLines);
  report["flips"] = count(names::Flips);
  report["longest"] = FieldValue(lines, names::Longest);
  report["mismatch"] = FieldValue(lines, names::Mismatch);
  report["map_residual"] = FieldValue(map->GetOutput(), names::MapResidual);
  report["seconds"] = { { "mesh", map->GetStageSeconds()[0] }, { "map", map->GetStageSeconds()[1] },
    { "trace", separatrices->GetStageSeconds() } };
  ReportJson::AddRepair(report, map->GetOutput()->GetFieldData());
  ReportJson::AddSingularities(report, singularities, DomainReader::HasHeight(map->GetOutput()));
  return report.dump(2) + "\n";
}

int Trace(const SeparatricesOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable({ { options.output, ".vtp" }, { options.faces, ".vtp" },
    { options.map, ".vtu" }, { options.json, "" }, { options.savedSingularities, ".csv" } });

  // 2. Read the domain and the configuration.
  const auto domain = BoundaryInput::Open(options.domain, options.size, options.boundary);
  vtkNew<vtkCrossFieldMap> map;
  map->SetInputConnection(domain->GetOutputPort());
  map->SetMeshSize(options.size);
  map->SetCapCorners(options.capCorners);
  map->SetRepairHolonomy(options.repairHolonomy);
  SingularityInput singularities(options.singularities, domain, options.size, options.corners);
  singularities.SetCapCorners(options.capCorners);
  singularities.Update();
  map->SetSingularitiesConnection(singularities.GetOutputPort());
  singularities.ConnectCorners(map.Get());
  vtkNew<vtkSeparatrices> separatrices;
  separatrices->SetInputConnection(map->GetOutputPort());
  if (!options.seeds.empty())
  {
    separatrices->SetSeedsConnection(DomainReader::OpenPoints(options.seeds)->GetOutputPort());
  }

  // 3. Map and trace.
  PipelineRun::Update(map, "mapping");
  PipelineRun::Update(separatrices, "tracing");
  vtkPolyData* lines = separatrices->GetOutput();
  singularities.ApplyRepair(map->GetOutput()->GetFieldData());

  // 4. Write.
  OutputTransaction outputs;
  OutputFile::WriteIfNamed(lines, options.output, outputs);
  OutputFile::WriteIfNamed(separatrices->GetOutput(1), options.faces, outputs);
  OutputFile::WriteIfNamed(map->GetOutput(), options.map, outputs);
  singularities.Save(options.savedSingularities, outputs);
  if (!options.json.empty())
  {
    outputs.Write(
      BoundaryInput::AddTo(WriteJson(lines, map, separatrices, singularities.GetOutput()), domain),
      options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    singularities.PrintChoice();
    std::cout << FieldValue(lines, names::Lines) << " lines, " << FieldValue(lines, names::Faces)
              << " faces, " << FieldValue(lines, names::Arcs) << " arcs, longest line "
              << FieldValue(lines, names::Longest) << "\n";
  }
  outputs.Commit();
  return Done;
}
}

void AddSeparatricesCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<SeparatricesOptions>();
  CLI::App* command = app.add_subcommand("separatrices",
    "follow the lines that leave the singularities, and the rectangles between them");
  command->footer(
    "Example: crossfield separatrices builtin:disk -s four.csv -o lines.vtp --json -");
  options->AddTo(*command);
  command->get_option("--singularities")
    ->description("singularities inside and on the boundary: .csv with the header "
                  "x,y,quarter_index, or .vtp, or - for standard input; left out: chosen for the "
                  "domain");
  command->get_option("--output")->description("the .vtp file to write, with the lines");
  command->add_option("--faces", options->faces, "write the rectangles to this .vtp file");
  command->add_option(
    "--map", options->map, "write the mesh with its coordinates to this .vtu file");
  command->add_option("--seeds", options->seeds,
    "points from which streamlines of the cross field are drawn as well: .csv, .vtp");
  command->add_flag("--cap-corners", options->capCorners,
    "give sharp corners of quarter index 2 index 1; the rest must be among the singularities");
  command->add_flag("--repair-holonomy", options->repairHolonomy,
    "move the singularities the least way to where no inner loop has a holonomy defect");
  AddCornersTo(*command, options->corners);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddJsonTo(*command, options->json);
  command->callback([options, &status] { status = Trace(*options); });
}
