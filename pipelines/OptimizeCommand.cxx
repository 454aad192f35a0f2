/**
 * crossfield optimize DOMAIN [-s S.csv] -o BETTER.csv: moves the interior singularities to where the
 * renormalised energy is least, or with --even to where sizes are most even.
 *
 *   crossfield optimize builtin:disk -s four.csv -o better.csv --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "EnergyJson.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkSingularityOptimizer.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct OptimizeOptions : MeshOptions
{
  std::string corners;
  std::string json;
  int iterations = 200;
  double clearance = 0.0;
  bool keepAll = false;
  bool even = false;
  std::vector<std::string> sizing = { "uniform" };
  int pairs = 0;
};

/** Why the words after --sizing make no sense; empty if they do. */
std::string CheckSizing(const OptimizeOptions& options)
{
  const std::string& sizing = options.sizing[0];
  if (sizing != "uniform" && sizing != "field")
  {
    return "--sizing: there is no '" + sizing + "'; give uniform or field NAME";
  }
  if (options.sizing.size() != (sizing == "field" ? 2U : 1U))
  {
    return "--sizing: give uniform, or field and the name of a point array of the domain";
  }
  return options.even || options.pairs > 0
    ? ""
    : "--sizing says which sizes are even; give it with --even or --pairs";
}

/** What evenness costs: a line for each point of the front. */
void PrintFront(vtkPolyData* moved)
{
  vtkFieldData* data = moved->GetFieldData();
  std::cout << "singularities, spread of sizes, renormalized energy, holonomy defect\n";
  for (vtkIdType i = 0; i < data->GetArray(names::FrontSingularities)->GetNumberOfTuples(); ++i)
  {
    const char* separator = "";
    for (const char* name : { names::FrontSingularities, names::FrontSizeSpread,
           names::FrontRenormalizedEnergy, names::FrontHolonomyDefect })
    {
      std::cout << separator << data->GetArray(name)->GetTuple1(i);
      separator = ", ";
    }
    std::cout << "\n";
  }
}

int Optimize(const OptimizeOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable({ { options.output, ".csv" }, { options.json, "" } });

  // 2. Read the domain and the start.
  const auto domain = BoundaryInput::Open(options.domain, options.size, options.boundary);
  vtkNew<vtkSingularityOptimizer> optimizer;
  optimizer->SetInputConnection(domain->GetOutputPort());
  vtkNew<vtkConfigurationProposal> proposal;
  if (options.singularities.empty())
  {
    proposal->SetInputConnection(domain->GetOutputPort());
    DomainReader::ConnectCorners(proposal.Get(), options.corners);
    optimizer->SetSingularitiesConnection(proposal->GetOutputPort());
  }
  else
  {
    const auto start = DomainReader::OpenPoints(options.singularities);
    optimizer->SetSingularitiesConnection(start->GetOutputPort());
    BoundaryInput::Keep(domain, start);
  }
  optimizer->SetMeshSize(options.size);
  optimizer->SetMaximumIterations(options.iterations);
  optimizer->SetClearance(options.clearance);
  optimizer->SetKeepAll(options.keepAll);
  optimizer->SetUniformSizes(options.even);
  optimizer->SetPairs(options.pairs);
  if (options.sizing[0] == "field")
  {
    optimizer->SetSizingToField();
    optimizer->SetSizeArray(options.sizing[1]);
  }
  DomainReader::ConnectCorners(optimizer.Get(), options.corners);
  BoundaryInput::Keep(domain, options.corners);

  // 3. Optimise and write.
  PipelineRun::Update(optimizer, "optimizing");
  vtkPolyData* moved = optimizer->GetOutput();
  OutputTransaction outputs;
  if (!options.output.empty())
  {
    const bool hasHeight =
      DomainReader::HasHeight(vtkDataSet::SafeDownCast(optimizer->GetInputDataObject(0, 0)));
    OutputFile::WriteConfiguration(moved, hasHeight, options.output, outputs);
  }
  if (options.json.empty() && !outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    std::cout << "renormalized energy from " << FieldValue(moved, names::RenormalizedEnergyBefore)
              << " to " << FieldValue(moved, names::RenormalizedEnergyAfter) << " in "
              << FieldValue(moved, names::Iterations) << " iterations. "
              << vtkStringArray::SafeDownCast(
                   moved->GetFieldData()->GetAbstractArray(names::Reason))
                   ->GetValue(0)
              << "\n";
    if (options.even || options.pairs > 0)
    {
      std::cout << "spread of sizes (standard deviation of "
                << (options.sizing[0] == "field" ? "log size over wanted size" : "their logarithm")
                << ") from " << FieldValue(moved, names::SizeSpreadBefore) << " to "
                << FieldValue(moved, names::SizeSpreadAfter) << "\n";
      PrintFront(moved);
    }
    auto* events =
      vtkStringArray::SafeDownCast(moved->GetFieldData()->GetAbstractArray(names::Events));
    for (vtkIdType i = 0; i < events->GetNumberOfValues(); ++i)
    {
      std::cout << events->GetValue(i) << "\n";
    }
  }
  if (!options.json.empty())
  {
    outputs.Write(BoundaryInput::AddTo(EnergyJson::Write(optimizer), domain), options.json);
  }
  outputs.Commit();
  return FieldValue(moved, names::Converged) != 0.0 ? Done : AnswerIsNo;
}
}

void AddOptimizeCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<OptimizeOptions>();
  CLI::App* command =
    app.add_subcommand("optimize", "move the interior singularities to where the energy is least");
  command->footer("Example: crossfield optimize builtin:disk -s four.csv -o better.csv --json -");
  options->AddTo(*command);
  command->get_option("--output")->description("the .csv file to write, or - for output");
  command->get_option("--singularities")
    ->description("configuration to start from, as in `crossfield solve`; left out: a proposal");
  AddCornersTo(*command, options->corners);
  command->add_option("--iterations", options->iterations, "most iterations")
    ->capture_default_str()
    ->check(CLI::NonNegativeNumber);
  command
    ->add_option("--clearance", options->clearance,
      "least distance to the boundary and to each other; default: 1/400 of the domain's diagonal")
    ->check(CLI::NonNegativeNumber);
  command->add_flag("--keep-all", options->keepAll,
    "no singularity moves into the boundary or out of it, none that meet are taken out");
  command->add_flag("--even", options->even,
    "then move on to where the sizes of quads that follow the field are most even");
  CLI::Option* sizing =
    command
      ->add_option("--sizing", options->sizing,
        "with --even or --pairs, uniform: the same sizes everywhere; field NAME: in proportion to those of a point array of "
        "the domain")
      ->expected(1, 2)
      ->type_name("WORD");
  command
    ->add_option("--pairs", options->pairs,
      "with --even, and then with up to so many pairs of quarter indices 1 and -1 more, while they bring something")
    ->check(CLI::Range(0, 100));
  AddJsonTo(*command, options->json);
  command->callback(
    [options, sizing, &status]
    {
      const std::string problem = sizing->count() > 0 ? CheckSizing(*options) : "";
      if (!problem.empty())
      {
        throw CLI::ValidationError(problem);
      }
      status = Optimize(*options);
    });
}
