/**
 * crossfield optimize DOMAIN [-s S.csv] -o BETTER.csv: moves the interior singularities to a
 * minimum of the renormalised energy, or with --even to where the sizes of quads are most uniform.
 *
 *   crossfield optimize builtin:disk -s four.csv -o better.csv --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "NumberCheck.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"
#include "vtkSingularityOptimizer.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <limits>
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

/** Returns an error message for the words after --sizing, empty if they are valid. */
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
    : "--sizing chooses the target sizes; give it with --even or --pairs";
}

/** Prints the spread of sizes, and for each step towards uniform sizes what it costs in energy. */
void PrintSizes(vtkPolyData* moved, bool isSizeField)
{
  vtkFieldData* data = moved->GetFieldData();
  std::cout << "spread of sizes (standard deviation of "
            << (isSizeField ? "log size over target size" : "their logarithm") << ") from "
            << FieldValue(moved, names::SizeSpreadBefore) << " to "
            << FieldValue(moved, names::SizeSpreadAfter) << "\n";
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

  // 2. Read the domain and the configuration to start from.
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

  // 3. Optimise.
  PipelineRun::Update(optimizer, "optimizing");
  vtkPolyData* moved = optimizer->GetOutput();

  // 4. Write.
  OutputTransaction outputs;
  if (!options.output.empty())
  {
    const bool hasHeight = vtkCrossFieldReport::HasHeight(optimizer->GetInputDataObject(0, 0));
    OutputFile::WriteConfiguration(moved, hasHeight, options.output, outputs);
  }
  if (!options.json.empty())
  {
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", moved);
    report->SetSource("singularities", moved);
    report->SetSource("domain", domain->GetOutputDataObject(0));
    outputs.Write(report->Write("optimize"), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    std::cout << "renormalized energy from " << FieldValue(moved, names::RenormalizedEnergyBefore)
              << " to " << FieldValue(moved, names::RenormalizedEnergyAfter) << " in "
              << FieldValue(moved, names::Iterations) << " iterations. "
              << FieldText(moved, names::Reason) << "\n";
    if (options.even || options.pairs > 0)
    {
      PrintSizes(moved, options.sizing[0] == "field");
    }
    PrintEvents(moved);
  }
  outputs.Commit();
  return FieldValue(moved, names::Converged) != 0.0 ? Done : AnswerIsNo;
}
}

void AddOptimizeCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<OptimizeOptions>();
  CLI::App* command =
    app.add_subcommand("optimize", "move the interior singularities to a minimum of the energy");
  command->footer("Example: crossfield optimize builtin:disk -s four.csv -o better.csv --json -");
  options->AddTo(*command);
  command->get_option("--output")
    ->description("write the singularities to this .csv file, or to standard output for -");
  command->get_option("--singularities")
    ->description(
      "singularities to start from: a .csv file with the header "
      "x,y,quarter_index[,radius], a .vtp file, or - for standard input; default: a proposal");
  AddCornersTo(*command, options->corners);
  command
    ->add_option("--iterations", options->iterations, "maximum number of iterations, not negative")
    ->capture_default_str()
    ->transform(NumberCheck::Whole(0, std::numeric_limits<int>::max()));
  AddClearanceTo(*command, options->clearance, "1/400 of the domain's diagonal");
  command->add_flag("--keep-all", options->keepAll,
    "keep every singularity in the interior or on the boundary where it started; remove none that "
    "meet");
  command->add_flag("--even", options->even,
    "after the minimum of the energy, move the singularities to where the sizes of quads are "
    "most uniform");
  CLI::Option* sizing =
    command
      ->add_option("--sizing", options->sizing,
        "with --even or --pairs: uniform aims at equal sizes everywhere; field NAME at sizes in "
        "proportion to a point array of the domain; default: uniform")
      ->expected(1, 2)
      ->type_name("WORD");
  AddPairsTo(*command, options->pairs);
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
