/**
 * crossfield solve DOMAIN [-s S.csv] -o F.vtu: computes the cross field with chosen singularities.
 *
 *   crossfield solve builtin:disk -s four.csv -o field.vtu --json -
 *   crossfield solve builtin:ring --method ginzburg-landau --epsilon 0.01 --start constant \
 *     --size 0.04 -o field.vtu
 */
#include "CommandLine.h"
#include "NumberCheck.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "SingularityInput.h"
#include "SolveMethods.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkPerforatedCrossField.h"
#include "vtkSingularitySource.h"

#include "vtkAlgorithm.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace
{
namespace names = vtkCrossFieldArrayNames;

int Solve(const SolveOptions& options)
{
  // 1. Check the usage and the outputs before any work.
  SolveMethods::CheckUsage(options);
  OutputFile::RequireWritable(
    { { options.output, ".vtu" }, { options.json, "" }, { options.savedSingularities, ".csv" } });

  // 2. Read the domain and the configuration. The reference does not use one, but a file must
  // exist.
  const bool isReference = options.method == SolveMethods::Reference;
  const auto domain = BoundaryInput::Open(options.domain, options.size, options.boundary);
  SingularityInput singularities(options.singularities, domain, options.size, options.corners);
  if (!isReference || !singularities.AreChosen())
  {
    singularities.Update();
  }

  // 3. Mesh the domain, with a hole at every singularity.
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  vtkNew<vtkSingularitySource> none;
  none->RemoveAllSingularities();
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(domain->GetOutputPort());
  drill->SetSingularitiesConnection(
    isReference ? none->GetOutputPort() : singularities.GetOutputPort());
  drill->SetMeshSize(options.size);
  drill->SetMode(DrillModeCode(options.mode));
  PipelineRun::Update(drill, "drilling");
  timer->StopTimer();

  // 4. Solve.
  vtkNew<vtkGinzburgLandauCrossField> reference;
  SolveMethods::Configure(options, reference);
  vtkNew<vtkPerforatedCrossField> perforated;
  SolveMethods::Configure(options, perforated);
  singularities.ConnectCorners(perforated.Get());
  vtkCrossFieldSolver* solver = perforated;
  if (isReference)
  {
    solver = reference;
  }
  solver->SetInputConnection(drill->GetOutputPort());
  solver->SetArrays(options.arrays);
  PipelineRun::Update(solver, "solving");
  vtkUnstructuredGrid* field = solver->GetOutput();

  // 5. Find the singularities, if the method can place further ones.
  const bool mayAppear =
    isReference || options.mode != SolveOptions().mode || options.epsilon != 0.0;
  vtkNew<vtkCrossFieldSingularities> found;
  found->SetInputConnection(solver->GetOutputPort());
  vtkDataSet* shown = singularities.GetOutput();
  if (mayAppear)
  {
    PipelineRun::Update(found, "reading singularities");
    shown = found->GetOutput();
  }

  // 6. Write the field and the report.
  OutputTransaction outputs;
  const double writeSeconds = OutputFile::WriteIfNamed(field, options.output, outputs);
  if (!options.savedSingularities.empty())
  {
    OutputFile::WriteConfiguration(isReference ? shown : singularities.GetOutput(),
      vtkCrossFieldReport::HasHeight(field), options.savedSingularities, outputs);
  }
  if (!options.json.empty())
  {
    const double* seconds = solver->GetStageSeconds(); // assemble, factor, solve
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", field);
    report->SetSource("domain", domain->GetOutputDataObject(0));
    report->SetSource("singularities", shown);
    report->SetSeconds(
      { seconds[0], seconds[1], timer->GetElapsedTime(), seconds[2], writeSeconds });
    outputs.Write(report->Write("field"), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    if (isReference)
    {
      SolveMethods::PrintReferenceSummary(field);
    }
    else
    {
      singularities.PrintChoice(options.verbose);
      SolveMethods::PrintSummary(field);
    }
    if (mayAppear)
    {
      PrintSingularities(shown, vtkCrossFieldReport::HasHeight(field));
    }
  }
  outputs.Commit();

  // 7. Return the answer.
  const bool unwanted = FieldValue(field, names::UnwantedSingularities) != 0.0 ||
    (!isReference && FieldValue(field, names::DegreesReached) == 0.0);
  const bool converged = FieldValue(field, names::Converged) != 0.0;
  return converged && !(options.strict && unwanted) ? Done : AnswerIsNo;
}
}

void AddSolveCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<SolveOptions>();
  CLI::App* command = app.add_subcommand("solve", "compute the cross field");
  command->footer("Example: crossfield solve builtin:disk -s four.csv -o field.vtu --json -");
  options->AddTo(*command);
  command
    ->add_option("--method", options->method,
      "unit-norm: a field with exactly the given singularities; constrained: the method of the "
      "paper, "
      "whose norm is free and may vanish elsewhere; ginzburg-landau: places the singularities "
      "itself "
      "and does not use -s; default: unit-norm, or constrained with options that only it has")
    ->check(CLI::IsMember({ "constrained", "unit-norm", "ginzburg-landau" }));
  command
    ->add_option("--start", options->start,
      "field to start from; constrained: harmonic, unit-norm, or best, which tries both; "
      "ginzburg-landau: harmonic (its default), constant or zero")
    ->capture_default_str()
    ->check(CLI::IsMember(SolveMethods::AllStarts()));
  command
    ->add_option("--epsilon", options->epsilon,
      "length in the Ginzburg-Landau penalty on the norm, positive, about the size of a triangle; "
      "constrained: adds this penalty, so that the quarter indices may have any sum; "
      "ginzburg-landau: "
      "default: the mean edge length, weighted by area")
    ->check(NumberCheck::Positive());
  AddModeTo(*command, options->mode);
  command->add_flag("--unit-holes", options->unitHoles, "force unit crosses on all holes");
  command
    ->add_option("--unit-hole", options->unitHoleRows,
      "force unit crosses on the hole of this row of the configuration, counted from 0; may be "
      "repeated")
    ->expected(1)
    ->take_all();
  command->add_flag("--global-constraint", options->globalConstraint,
    "prescribe only the sum of the quarter indices, instead of the index of every hole");
  AddCornersTo(*command, options->corners);
  AddArraysTo(*command, options->arrays);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddVerboseTo(*command, options->verbose);
  AddJsonTo(*command, options->json);
  command->add_flag("--strict", options->strict,
    "exit with status 1 if there are unwanted singularities or a hole does not have its index");
  command->callback(
    [options, &status]
    {
      if (options->method.empty())
      {
        options->method = SolveMethods::DefaultMethod(*options);
      }
      status = Solve(*options);
    });
}
