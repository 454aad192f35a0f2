/**
 * crossfield separatrices DOMAIN [-s S.csv] -o LINES.vtp: traces the separatrices of a cross field,
 * the lines that leave its singularities, and the rectangles into which they divide the domain.
 *
 *   crossfield separatrices builtin:disk -s four.csv -o lines.vtp --faces faces.vtp --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "SingularityInput.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldMap.h"
#include "vtkCrossFieldReport.h"
#include "vtkSeparatrices.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

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
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", lines);
    report->SetSource("map", map->GetOutput());
    report->SetSource("singularities", singularities.GetOutput());
    report->SetSource("domain", domain->GetOutputDataObject(0));
    report->SetSeconds(
      { map->GetStageSeconds()[0], map->GetStageSeconds()[1], separatrices->GetStageSeconds() });
    outputs.Write(report->Write("separatrices"), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    singularities.PrintChoice(options.verbose);
    PrintStretch(map->GetOutput()->GetFieldData());
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
    "trace the lines that leave the singularities, and the rectangles between them");
  command->footer(
    "Example: crossfield separatrices builtin:disk -s four.csv -o lines.vtp --json -");
  options->AddTo(*command);
  command->get_option("--singularities")
    ->description(
      "singularities in the interior and on the boundary: a .csv file with the header "
      "x,y,quarter_index, a .vtp file, or - for standard input; default: chosen for the "
      "domain");
  command->get_option("--output")
    ->description("write the separatrices to this .vtp file, or to standard output for -");
  command->add_option("--faces", options->faces, "write the rectangles to this .vtp file");
  command->add_option("--map", options->map,
    "write the triangle mesh with the coordinates of the seamless map to this .vtu file");
  command->add_option("--seeds", options->seeds,
    "also trace streamlines of the cross field from these points: a .csv or .vtp file");
  AddCapCornersTo(*command, options->capCorners, "--cap-corners");
  AddRepairHolonomyTo(*command, options->repairHolonomy);
  AddCornersTo(*command, options->corners);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddVerboseTo(*command, options->verbose);
  AddJsonTo(*command, options->json);
  command->callback([options, &status] { status = Trace(*options); });
}
