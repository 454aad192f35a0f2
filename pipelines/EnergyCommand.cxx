/**
 * crossfield energy DOMAIN [-s A.csv] [-s B.csv …]: computes the energies of configurations and
 * lists the best first.
 *
 *   crossfield energy builtin:disk -s four.csv --json -
 */
#include "BoundaryInput.h"
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "SingularityInput.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"
#include "vtkSingularityEnergy.h"

#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <optional>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct EnergyOptions
{
  bool verbose = false;
  BoundaryOptions boundary;
  std::string domain;
  std::vector<std::string> configurations;
  std::string corners;
  std::string json;
  double size = 0.0;
  double coreRadius = 0.0;
};

void PrintSummary(vtkTable* table, const std::vector<std::string>& files)
{
  std::cout << "configuration energy lower_bound upper_bound degree_only logarithm_coefficient "
               "renormalized_energy energy_at_core_radius\n";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto value = [&](const char* name)
    { return table->GetValueByName(row, name).ToDouble(); };
    std::cout << files[static_cast<std::size_t>(value(names::Configuration))];
    if (value(names::Consistent) == 0.0)
    {
      std::cout << " is not consistent; see `crossfield check`\n";
      continue;
    }
    for (const char* name :
      { names::Energy, names::EnergyLowerBound, names::EnergyUpperBound, names::EnergyDegreeOnly,
        names::LogarithmCoefficient, names::RenormalizedEnergy, names::EnergyAtCoreRadius })
    {
      std::cout << " " << value(name);
    }
    std::cout << "\n";
  }
}

int Energy(const EnergyOptions& options)
{
  // 1. Check the output before any work.
  OutputFile::RequireWritable({ { options.json, "" } });

  // 2. Read the domain and the configurations.
  const auto domain = BoundaryInput::Open(options.domain, options.size, options.boundary);
  vtkNew<vtkSingularityEnergy> energy;
  energy->SetInputConnection(domain->GetOutputPort());
  energy->SetMeshSize(options.size);
  energy->SetCoreRadius(options.coreRadius);
  std::vector<std::string> files = options.configurations;
  std::optional<SingularityInput> chosen;
  if (files.empty())
  {
    files = { "chosen" };
    chosen.emplace("", domain, options.size, options.corners);
    chosen->Update();
    energy->AddConfigurationConnection(chosen->GetOutputPort());
    chosen->ConnectCorners(energy.Get());
  }
  else
  {
    for (const std::string& file : files)
    {
      const auto points = DomainReader::OpenPoints(file);
      energy->AddConfigurationConnection(points->GetOutputPort());
      BoundaryInput::Keep(domain, points);
    }
    DomainReader::ConnectCorners(energy.Get(), options.corners);
    BoundaryInput::Keep(domain, options.corners);
  }

  // 3. Compute the energies.
  PipelineRun::Update(energy, "energies");
  vtkTable* table = energy->GetOutput();

  // 4. Write.
  OutputTransaction outputs;
  if (!options.json.empty())
  {
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", table);
    report->SetSource("gradients", energy->GetOutputDataObject(1));
    report->SetSource("singularities", chosen.has_value() ? chosen->GetOutput() : nullptr);
    report->SetSource("domain", domain->GetOutputDataObject(0));
    report->SetFiles(files);
    outputs.Write(report->Write("energy"), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    if (chosen.has_value())
    {
      chosen->PrintChoice(options.verbose);
    }
    PrintSummary(table, files);
  }
  outputs.Commit();

  // 5. Return the answer.
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    if (table->GetValueByName(row, names::Consistent).ToInt() == 0)
    {
      return AnswerIsNo;
    }
  }
  return Done;
}
}

void AddEnergyCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<EnergyOptions>();
  CLI::App* command = app.add_subcommand("energy", "compare configurations by their energies");
  command->footer("Example: crossfield energy builtin:disk -s four.csv --json -");
  command->add_option("DOMAIN", options->domain, DomainReader::Help)->required();
  options->boundary.AddTo(*command);
  command
    ->add_option("-s,--singularities", options->configurations,
      "configuration to compare: a .csv file with the header x,y,quarter_index[,radius], a .vtp "
      "file, "
      "or - for standard input; may be repeated; default: one that is chosen for the domain")
    ->expected(1)
    ->take_all();
  AddCornersTo(*command, options->corners);
  AddSizeTo(*command, options->size);
  AddCoreRadiusTo(*command, options->coreRadius);
  AddVerboseTo(*command, options->verbose);
  AddJsonTo(*command, options->json);
  command->callback([options, &status] { status = Energy(*options); });
}
