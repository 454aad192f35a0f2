/**
 * crossfield optimize DOMAIN -s S.csv -o BETTER.csv: moves the interior singularities to where the
 * renormalised energy is least.
 *
 *   crossfield optimize builtin:disk -s four.csv -o better.csv --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "EnergyJson.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkSingularityOptimizer.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct OptimizeOptions : MeshOptions
{
  std::string corners;
  std::string json;
  int iterations = 200;
};

int Optimize(const OptimizeOptions& options)
{
  // 1. Check the outputs before any work.
  if (!options.output.empty())
  {
    OutputFile::RequireWritable(options.output, ".csv");
  }
  if (!options.json.empty() && options.json != "-")
  {
    OutputFile::RequireWritable(options.json, "");
    if (options.json == options.output)
    {
      throw PipelineRun::Error("The singularities and the report cannot both go to '" +
        options.json + "'; give two names.");
    }
  }

  // 2. Read the domain and the start.
  const auto domain = DomainReader::Open(options.domain, options.size);
  vtkNew<vtkSingularityOptimizer> optimizer;
  optimizer->SetInputConnection(domain->GetOutputPort());
  optimizer->SetSingularitiesConnection(
    DomainReader::OpenPoints(options.singularities)->GetOutputPort());
  optimizer->SetMeshSize(options.size);
  optimizer->SetMaximumIterations(options.iterations);
  if (!options.corners.empty())
  {
    optimizer->SetCornersConnection(DomainReader::OpenPoints(options.corners)->GetOutputPort());
  }

  // 3. Optimise and write.
  PipelineRun::Update(optimizer, "optimizing");
  vtkFieldData* data = optimizer->GetOutput()->GetFieldData();
  const auto value = [data](const char* name) { return data->GetArray(name)->GetTuple1(0); };
  OutputTransaction outputs;
  if (!options.output.empty())
  {
    outputs.Write(EnergyJson::WriteConfiguration(optimizer), options.output);
  }
  if (options.json.empty())
  {
    std::cout << "renormalized energy from " << value(names::RenormalizedEnergyBefore) << " to "
              << value(names::RenormalizedEnergyAfter) << " in " << value(names::Iterations)
              << " iterations. "
              << vtkStringArray::SafeDownCast(data->GetAbstractArray(names::Reason))->GetValue(0)
              << "\n";
  }
  else
  {
    outputs.Write(EnergyJson::Write(optimizer), options.json);
  }
  outputs.Commit();
  return value(names::Converged) != 0.0 ? Done : AnswerIsNo;
}
}

void AddOptimizeCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<OptimizeOptions>();
  CLI::App* command =
    app.add_subcommand("optimize", "move the interior singularities to where the energy is least");
  command->footer("Example: crossfield optimize builtin:disk -s four.csv -o better.csv --json -");
  options->AddTo(*command);
  command->get_option("--output")->description("the .csv file to write");
  command->add_option("--corners", options->corners,
    "quarter indices of corners: .vtp written by `crossfield corners`, or .csv");
  command->add_option("--iterations", options->iterations, "most iterations")
    ->capture_default_str()
    ->check(CLI::NonNegativeNumber);
  command->add_option("--json", options->json, "write the numbers to this file, or - for output");
  command->callback([options, &status] { status = Optimize(*options); });
}
