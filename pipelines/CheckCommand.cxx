/**
 * crossfield check DOMAIN [-s S.csv] [--propose F.csv]: which configurations can exist on a domain,
 * by the generalised Poincaré-Hopf theorem, and why. Exit status 1 when the given one cannot.
 *
 *   crossfield check builtin:disk -s four.csv --json -
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "TopologyJson.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkPoincareHopfCheck.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <sstream>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct CheckOptions
{
  std::string domain;
  std::string singularities;
  std::string corners;
  std::string proposal;
  std::string json;
  bool cancelFlat = false;
};

double Value(vtkDataSet* domain, const char* name)
{
  return domain->GetFieldData()->GetArray(name)->GetTuple1(0);
}

/** The configuration as the .csv text that the program reads; with z if the domain needs it. */
std::string ConfigurationText(vtkDataSet* points, bool hasHeight)
{
  std::ostringstream text;
  text.precision(17);
  text << (hasHeight ? "x,y,z,quarter_index,radius\n" : "x,y,quarter_index,radius\n");
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    text << points->GetPoint(i)[0] << "," << points->GetPoint(i)[1] << ",";
    if (hasHeight)
    {
      text << points->GetPoint(i)[2] << ",";
    }
    text << points->GetPointData()->GetArray(names::QuarterIndex)->GetTuple1(i) << ","
         << points->GetPointData()->GetArray(names::Radius)->GetTuple1(i) << "\n";
  }
  return text.str();
}

void PrintSummary(vtkPoincareHopfCheck* check)
{
  vtkDataSet* domain = check->GetOutput();
  std::cout << "Euler characteristic " << Value(domain, names::EulerCharacteristic) << ", valence "
            << Value(domain, names::Valence) << ", tangent turning "
            << Value(domain, names::TangentTurning) << "\ninterior quarter indices: required "
            << Value(domain, names::RequiredInteriorQuarters) << ", given "
            << Value(domain, names::GivenInteriorQuarters) << "\n";
  auto* corners = vtkDataSet::SafeDownCast(check->GetOutputDataObject(2));
  for (vtkIdType i = 0; i < corners->GetNumberOfPoints(); ++i)
  {
    if (corners->GetPointData()->GetArray(names::Cancellable)->GetTuple1(i) != 0.0)
    {
      std::cout << "the corner at (" << corners->GetPoint(i)[0] << ", " << corners->GetPoint(i)[1];
      if (DomainReader::HasHeight(domain))
      {
        std::cout << ", " << corners->GetPoint(i)[2];
      }
      std::cout << ") can be cancelled by singularities in the domain\n";
    }
  }
  if (vtkDataArray* defects = domain->GetFieldData()->GetArray(names::HolonomyDefect))
  {
    for (vtkIdType i = 0; i < defects->GetNumberOfTuples(); ++i)
    {
      std::cout << "holonomy defect at inner loop " << i + 1 << ": " << defects->GetTuple1(i)
                << "\n";
    }
  }
}

int Check(const CheckOptions& options)
{
  // 1. Check the outputs before any work.
  if (!options.proposal.empty())
  {
    OutputFile::RequireWritable(options.proposal, ".csv");
  }
  if (!options.json.empty() && options.json != "-")
  {
    OutputFile::RequireWritable(options.json, "");
  }

  // 2. Read the domain, the configuration and the corners.
  const auto domain = DomainReader::Open(options.domain, 0.0);
  vtkNew<vtkPoincareHopfCheck> check;
  vtkNew<vtkConfigurationProposal> proposal;
  check->SetInputConnection(domain->GetOutputPort());
  proposal->SetInputConnection(domain->GetOutputPort());
  if (!options.corners.empty())
  {
    const auto corners = DomainReader::OpenPoints(options.corners);
    check->SetCornersConnection(corners->GetOutputPort());
    proposal->SetCornersConnection(corners->GetOutputPort());
  }
  if (!options.singularities.empty())
  {
    const auto singularities = DomainReader::OpenPoints(options.singularities);
    check->SetSingularitiesConnection(singularities->GetOutputPort());
    proposal->SetSingularitiesConnection(singularities->GetOutputPort());
  }

  // 3. Propose; without a given configuration the proposal is what is checked.
  if (!options.proposal.empty())
  {
    proposal->SetCancelFlatCorners(options.cancelFlat);
    PipelineRun::Update(proposal, "proposing");
    if (options.singularities.empty())
    {
      check->SetSingularitiesConnection(proposal->GetOutputPort());
    }
  }
  PipelineRun::Update(check, "checking");

  // 4. Write.
  OutputTransaction outputs;
  if (!options.proposal.empty())
  {
    outputs.Write(
      ConfigurationText(proposal->GetOutput(), DomainReader::HasHeight(check->GetOutput())),
      options.proposal);
  }
  const std::string reason = vtkStringArray::SafeDownCast(
    check->GetOutput()->GetFieldData()->GetAbstractArray(names::Reason))
                               ->GetValue(0);
  const bool consistent = Value(check->GetOutput(), names::Consistent) != 0.0;
  if (options.json.empty())
  {
    PrintSummary(check);
    std::cout << (consistent ? reason + "\n" : "");
  }
  else
  {
    outputs.Write(TopologyJson::Write(check), options.json);
  }
  outputs.Commit();

  // 5. The answer.
  if (!consistent)
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
    app.add_subcommand("check", "say whether singularities can exist on a domain, and why");
  command->footer("Example: crossfield check builtin:disk -s four.csv --json -");
  command
    ->add_option("DOMAIN", options->domain,
      std::string(DomainReader::Help) + "; a solved field is checked itself")
    ->required();
  command->add_option("-s,--singularities", options->singularities,
    "configuration: .csv with the header x,y,quarter_index[,radius], or .vtp; default: none");
  command->add_option("--corners", options->corners,
    "quarter indices of corners: .vtp written by `crossfield corners`, or .csv");
  command->add_option("--propose", options->proposal,
    "write a consistent configuration to this .csv file: that of -s with what it lacks");
  command->add_flag("--cancel-flat", options->cancelFlat,
    "propose pairs that cancel corners of 135 to 180 degrees");
  command->add_option("--json", options->json, "write the numbers to this file, or - for output");
  command->callback([options, &status] { status = Check(*options); });
}
