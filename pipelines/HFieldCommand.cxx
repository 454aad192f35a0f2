/**
 * crossfield hfield DOMAIN [-s S.csv] -o F.vtu: computes the size field H, its size map and its
 * cross field.
 *
 *   crossfield hfield builtin:disk -s four.csv -o h.vtu --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "SingularityInput.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"
#include "vtkHField.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct HFieldOptions : MeshOptions
{
  std::string corners;
  std::string json;
  std::string savedSingularities;
  bool strict = false;
  int arrays = vtkCrossFieldArraySets::All;
};

void PrintSummary(vtkUnstructuredGrid* field)
{
  const double* range = field->GetPointData()->GetArray(names::H)->GetRange();
  const bool hasEnergy = field->GetFieldData()->HasArray(names::Energy) != 0; // not on a surface
  if (hasEnergy)
  {
    std::cout << "energy " << FieldValue(field, names::Energy);
  }
  if (field->GetFieldData()->HasArray(names::RenormalizedEnergy) != 0)
  {
    std::cout << ", renormalized energy " << FieldValue(field, names::RenormalizedEnergy);
  }
  std::cout << (hasEnergy ? ", " : "") << "H from " << range[0] << " to " << range[1]
            << ", unwanted singularities " << FieldValue(field, names::UnwantedSingularities);
  vtkDataArray* defects = field->GetFieldData()->GetArray(names::HolonomyDefect);
  if (defects->GetNumberOfTuples() > 0)
  {
    std::cout << ", holonomy defects";
    for (vtkIdType i = 0; i < defects->GetNumberOfTuples(); ++i)
    {
      std::cout << " " << defects->GetComponent(i, 0);
    }
  }
  std::cout << "\n";
}

int SolveH(const HFieldOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable(
    { { options.output, ".vtu" }, { options.json, "" }, { options.savedSingularities, ".csv" } });

  // 2. Read the domain and the configuration.
  const auto domain = BoundaryInput::Open(options.domain, options.size, options.boundary);
  vtkNew<vtkHField> solver;
  solver->SetInputConnection(domain->GetOutputPort());
  solver->SetMeshSize(options.size);
  solver->SetArrays(options.arrays);
  SingularityInput singularities(options.singularities, domain, options.size, options.corners);
  PipelineRun::Update(domain, "reading");
  const bool usesHoles =
    options.singularities.empty() && DomainReader::IsDrilled(domain->GetOutputDataObject(0));
  if (usesHoles)
  {
    DomainReader::ConnectCorners(solver.Get(), options.corners);
  }
  else
  {
    singularities.Update();
    solver->SetSingularitiesConnection(singularities.GetOutputPort());
    singularities.ConnectCorners(solver.Get());
  }

  // 3. Solve.
  PipelineRun::Update(solver, "solving");
  vtkUnstructuredGrid* field = solver->GetOutput();

  // 4. Write the field and the report.
  OutputTransaction outputs;
  const double writeSeconds = OutputFile::WriteIfNamed(field, options.output, outputs);
  if (!usesHoles)
  {
    singularities.Save(options.savedSingularities, outputs);
  }
  if (!options.json.empty())
  {
    const double* seconds = solver->GetStageSeconds(); // mesh, assemble, factor, solve
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", field);
    report->SetSource("domain", domain->GetOutputDataObject(0));
    report->SetSource("singularities", usesHoles ? nullptr : singularities.GetOutput());
    report->SetSeconds({ seconds[1], seconds[2], seconds[0], seconds[3], writeSeconds });
    outputs.Write(report->Write("field"), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    if (!usesHoles)
    {
      singularities.PrintChoice(options.verbose);
    }
    PrintSummary(field);
  }
  outputs.Commit();

  // 5. Return the answer.
  const bool unwanted = FieldValue(field, names::UnwantedSingularities) != 0.0;
  return FieldValue(field, names::Converged) == 0.0 || (options.strict && unwanted) ? AnswerIsNo
                                                                                    : Done;
}
}

void AddHFieldCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<HFieldOptions>();
  CLI::App* command = app.add_subcommand(
    "hfield", "compute the size field H, the size map and the cross field without iteration");
  command->footer("Example: crossfield hfield builtin:disk -s four.csv -o h.vtu --json -");
  options->AddTo(*command);
  command->get_option("--singularities")
    ->description(
      "singularities in the interior and on the boundary: a .csv file with the header "
      "x,y,quarter_index[,radius], a .vtp file, or - for standard input; default: chosen "
      "for the domain; on a drilled mesh its holes");
  AddCornersTo(*command, options->corners);
  AddArraysTo(*command, options->arrays);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddVerboseTo(*command, options->verbose);
  AddJsonTo(*command, options->json);
  command->add_flag(
    "--strict", options->strict, "exit with status 1 if there are unwanted singularities");
  command->callback([options, &status] { status = SolveH(*options); });
}
