/**
 * crossfield check DOMAIN [-s S.csv] [--propose F.csv [--alternatives N]]: checks whether a
 * configuration can exist on a domain, by the generalised Poincaré-Hopf theorem, and proposes one.
 * Exit status 1 if it cannot exist.
 *
 *   crossfield check builtin:disk -s four.csv --json -
 */
#include "BoundaryInput.h"
#include "CheckOutput.h"
#include "CommandLine.h"
#include "DomainReader.h"
#include "ListText.h"
#include "NumberCheck.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct CheckOptions
{
  BoundaryOptions boundary;
  std::string domain;
  std::string singularities;
  std::string corners;
  std::string proposal;
  std::string json;
  int alternatives = 0;
  bool capCorners = true;
  double coreRadius = 0.0;
  bool cancelFlat = false;
  double featureAngle = 35.0;
};

/** Writes the proposal to F.csv and the alternatives to F_1.csv, F_2.csv, … */
void WriteProposals(vtkConfigurationProposal* proposal, bool hasHeight, const std::string& file,
  OutputTransaction& outputs)
{
  OutputFile::WriteConfiguration(proposal->GetOutput(), hasHeight, file, outputs);
  auto* table = vtkTable::SafeDownCast(proposal->GetOutputDataObject(2));
  const std::string stem = file.substr(0, file.rfind('.'));
  for (int i = 1; i < static_cast<int>(table->GetNumberOfRows()); ++i)
  {
    OutputFile::WriteConfiguration(CheckOutput::AlternativePoints(proposal, i), hasHeight,
      stem + "_" + std::to_string(i) + ".csv", outputs);
  }
}

int Check(const CheckOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable({ { options.proposal, ".csv" }, { options.json, "" } });

  // 2. Read the domain, the configuration and the corners.
  const auto domain = BoundaryInput::Open(options.domain, 0.0, options.boundary);
  vtkNew<vtkPoincareHopfCheck> check;
  vtkNew<vtkConfigurationProposal> proposal;
  check->SetInputConnection(domain->GetOutputPort());
  proposal->SetInputConnection(domain->GetOutputPort());
  check->SetCapCorners(options.capCorners);
  check->SetFeatureAngle(options.featureAngle);
  proposal->SetFeatureAngle(options.featureAngle);
  check->SetMaterialArray(options.boundary.materials);
  check->SetLines(ListText::Join(options.boundary.lines));
  proposal->SetCapCorners(options.capCorners);
  DomainReader::ConnectCorners(check.Get(), options.corners);
  DomainReader::ConnectCorners(proposal.Get(), options.corners);
  BoundaryInput::Keep(domain, options.corners);
  if (!options.singularities.empty())
  {
    const auto singularities = DomainReader::OpenPoints(options.singularities);
    check->SetSingularitiesConnection(singularities->GetOutputPort());
    proposal->SetSingularitiesConnection(singularities->GetOutputPort());
    BoundaryInput::Keep(domain, singularities);
  }

  // 3. Propose; if no configuration was given, check the proposal.
  if (!options.proposal.empty())
  {
    if (!options.boundary.lines.empty())
    {
      throw PipelineRun::Error(
        "A configuration for a domain with lines is proposed by quads alone, whose report has its "
        "singularities; leave out --propose or --line.",
        BadInput);
    }
    proposal->SetCancelFlatCorners(options.cancelFlat);
    proposal->SetAlternatives(options.alternatives);
    proposal->SetCoreRadius(options.coreRadius);
    PipelineRun::Update(proposal, "proposing");
    if (options.singularities.empty())
    {
      check->SetSingularitiesConnection(proposal->GetOutputPort());
    }
  }
  PipelineRun::Update(check, "checking");
  vtkDataSet* checked = check->GetOutput();
  const std::string reason = FieldText(checked, names::Reason);
  const bool hasRegions =
    checked->GetFieldData()->GetAbstractArray(names::RegionMaterial) != nullptr;
  if (hasRegions && !options.proposal.empty())
  {
    throw PipelineRun::Error(
      "A configuration for several materials is proposed by quads alone, whose report has its "
      "singularities; leave out --propose, or use --materials none.",
      BadInput);
  }

  // 4. Write.
  OutputTransaction outputs;
  if (!options.proposal.empty())
  {
    WriteProposals(proposal, vtkCrossFieldReport::HasHeight(checked), options.proposal, outputs);
  }
  if (!options.json.empty())
  {
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", checked);
    report->SetSource("corners", check->GetOutputDataObject(2));
    report->SetSource("loops", check->GetOutputDataObject(1));
    report->SetSource("domain", domain->GetOutputDataObject(0));
    outputs.Write(report->Write("check"), options.json);
  }
  else if (!outputs.PrintsData())
  {
    std::cout << reason << "\n";
    BoundaryInput::Print(domain);
    CheckOutput::Print(check);
    if (options.alternatives > 0)
    {
      CheckOutput::PrintAlternatives(vtkTable::SafeDownCast(proposal->GetOutputDataObject(2)));
    }
    const bool isField = checked->GetFieldData()->HasArray(names::UnwantedSingularities) != 0;
    const bool isSurface = checked->GetFieldData()->HasArray(names::TotalCurvature) != 0;
    if (options.corners.empty() && !isField && !hasRegions && !isSurface)
    {
      CheckOutput::PrintCornerHint(domain, FieldValue(checked, names::RequiredInteriorQuarters));
    }
  }
  outputs.Commit();

  // 5. Return the answer.
  if (FieldValue(checked, names::Consistent) == 0.0)
  {
    throw PipelineRun::Error(reason, AnswerIsNo);
  }
  return Done;
}
}

void AddCheckCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<CheckOptions>();
  CLI::App* command =
    app.add_subcommand("check", "check whether singularities can exist on a domain, and why");
  command->footer("Example: crossfield check builtin:disk -s four.csv --json -");
  command
    ->add_option("DOMAIN", options->domain,
      std::string(DomainReader::Help) + "; of a solved field the field itself is checked")
    ->required();
  options->boundary.AddTo(*command);
  options->boundary.AddMaterialsTo(*command);
  options->boundary.AddLinesTo(*command);
  AddSingularitiesTo(*command, options->singularities, "none");
  AddCornersTo(*command, options->corners);
  CLI::Option* proposing = command->add_option("--propose", options->proposal,
    "write a configuration that can exist to this .csv file: the singularities of -s and those "
    "that "
    "the domain still needs");
  command
    ->add_option("--alternatives", options->alternatives,
      "with --propose F.csv: number of further configurations, 0 to 100; they are written to "
      "F_1.csv, "
      "F_2.csv, …, the best first; default: 0")
    ->transform(NumberCheck::Whole(0, 100))
    ->needs(proposing);
  AddCapCornersTo(*command, options->capCorners, "--cap-corners,!--no-cap-corners");
  AddFeatureAngleTo(*command, options->featureAngle);
  AddCoreRadiusTo(*command, options->coreRadius);
  command->add_flag("--cancel-flat", options->cancelFlat,
    "propose pairs of singularities that cancel corners of 135 to 180 degrees");
  AddJsonTo(*command, options->json);
  command->callback([options, &status] { status = Check(*options); });
}
