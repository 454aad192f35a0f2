/**
 * crossfield solve DOMAIN -s S.csv -o F.vtu: the cross field with chosen singularities.
 *
 *   crossfield solve builtin:disk -s four.csv -o field.vtu --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "PipelineRun.h"
#include "ReportJson.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkDrillHoles.h"
#include "vtkPerforatedCrossField.h"
#include "vtkSingularitySource.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace
{
struct SolveOptions : MeshOptions
{
  std::string method = "constrained";
  std::string json;
  bool strict = false;
};

double Value(vtkUnstructuredGrid* field, const char* name)
{
  return field->GetFieldData()->GetArray(name)->GetComponent(0, 0);
}

void PrintSummary(vtkUnstructuredGrid* field)
{
  namespace names = vtkCrossFieldArrayNames;
  std::cout << "energy " << Value(field, names::Energy) << ", "
            << (Value(field, names::Converged) != 0.0 ? "converged" : "NOT converged") << " after "
            << Value(field, names::Iterations) << " iterations (residual "
            << Value(field, names::Residual) << "), unwanted singularities "
            << Value(field, names::UnwantedSingularities) << ", degrees of the holes";
  vtkDataArray* degrees = field->GetFieldData()->GetArray(names::HoleDegree);
  for (vtkIdType i = 0; i < degrees->GetNumberOfTuples(); ++i)
  {
    std::cout << " " << degrees->GetComponent(i, 0);
  }
  std::cout << "\n";
}

int Solve(const SolveOptions& options)
{
  namespace names = vtkCrossFieldArrayNames;
  // 1. Check the outputs before any work.
  if (!options.output.empty())
  {
    OutputFile::RequireWritable(options.output, ".vtu");
  }
  if (!options.json.empty() && options.json != "-")
  {
    OutputFile::RequireWritable(options.json, "");
  }

  // 2. Read the domain and the configuration.
  const auto domain = DomainReader::Open(options.domain, options.size);
  vtkNew<vtkSingularitySource> singularities;
  singularities->SetFileName(options.singularities);

  // 3. Drill a hole at every singularity.
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(domain->GetOutputPort());
  drill->SetSingularitiesConnection(singularities->GetOutputPort());
  drill->SetMeshSize(options.size);
  PipelineRun::Update(drill, "drilling");
  timer->StopTimer();
  std::map<std::string, double> seconds;
  seconds["mesh"] = timer->GetElapsedTime();

  // 4. Solve.
  vtkNew<vtkPerforatedCrossField> solver;
  solver->SetInputConnection(drill->GetOutputPort());
  solver->SetMethod(options.method == "unit-norm" ? vtkPerforatedCrossField::MethodUnitNorm
                                                  : vtkPerforatedCrossField::MethodConstrained);
  PipelineRun::Update(solver, "solving");
  vtkUnstructuredGrid* field = solver->GetOutput();
  seconds["assemble"] = solver->GetStageSeconds()[0];
  seconds["factor"] = solver->GetStageSeconds()[1];
  seconds["solve"] = solver->GetStageSeconds()[2];

  // 5. Write the field and the report.
  timer->StartTimer();
  if (!options.output.empty())
  {
    OutputFile::Write(field, options.output);
  }
  timer->StopTimer();
  seconds["write"] = timer->GetElapsedTime();
  if (options.json.empty())
  {
    PrintSummary(field);
  }
  else
  {
    OutputFile::WriteText(
      ReportJson::Write(field->GetFieldData(), { { "triangles", CountTriangles(field) } }, seconds),
      options.json);
  }

  // 6. The answer.
  const bool unwanted = Value(field, names::UnwantedSingularities) != 0.0;
  return Value(field, names::Converged) == 0.0 || (options.strict && unwanted) ? AnswerIsNo : Done;
}
}

void AddSolveCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<SolveOptions>();
  CLI::App* command = app.add_subcommand("solve", "compute the cross field");
  command->footer("Example: crossfield solve builtin:disk -s four.csv -o field.vtu --json -");
  options->AddTo(*command);
  command->add_option("--method", options->method, "constrained or unit-norm")
    ->capture_default_str()
    ->check(CLI::IsMember({ "constrained", "unit-norm" }));
  command->add_option("--json", options->json, "write the numbers to this file, or - for output");
  command->add_flag(
    "--strict", options->strict, "exit with status 1 when there are unwanted singularities");
  command->callback([options, &status] { status = Solve(*options); });
}
