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
#include "vtkBoundaryCornerClassifier.h"
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

void PrintSummary(vtkPoincareHopfCheck* check)
{
  vtkDataSet* domain = check->GetOutput();
  std::cout << "Euler characteristic " << FieldValue(domain, names::EulerCharacteristic)
            << ", valence " << FieldValue(domain, names::Valence) << ", tangent turning "
            << FieldValue(domain, names::TangentTurning) << "\ninterior quarter indices: required "
            << FieldValue(domain, names::RequiredInteriorQuarters) << ", given "
            << FieldValue(domain, names::GivenInteriorQuarters) << "\n";
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

/** Says so where `crossfield corners` asks for another sum, and which of the two is followed. */
void PrintHint(vtkAlgorithm* domain, double required)
{
  vtkNew<vtkBoundaryCornerClassifier> classifier;
  classifier->SetInputConnection(domain->GetOutputPort());
  PipelineRun::Update(classifier, "corners");
  const double cheapest = FieldValue(classifier->GetOutput(), names::InteriorQuarters);
  if (cheapest != required)
  {
    std::cout
      << "the cheapest quarter indices of corners ask for " << cheapest
      << " inside instead; to follow them give --corners what `crossfield corners` writes\n";
  }
}

int Check(const CheckOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable({ { options.proposal, ".csv" }, { options.json, "" } });

  // 2. Read the domain, the configuration and the corners.
  const auto domain = DomainReader::Open(options.domain, 0.0);
  vtkNew<vtkPoincareHopfCheck> check;
  vtkNew<vtkConfigurationProposal> proposal;
  check->SetInputConnection(domain->GetOutputPort());
  proposal->SetInputConnection(domain->GetOutputPort());
  DomainReader::ConnectCorners(check.Get(), options.corners);
  DomainReader::ConnectCorners(proposal.Get(), options.corners);
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
    OutputFile::WriteConfiguration(proposal->GetOutput(),
      DomainReader::HasHeight(check->GetOutput()), options.proposal, outputs);
  }
  const std::string reason = vtkStringArray::SafeDownCast(
    check->GetOutput()->GetFieldData()->GetAbstractArray(names::Reason))
                               ->GetValue(0);
  const bool consistent = FieldValue(check->GetOutput(), names::Consistent) != 0.0;
  if (options.json.empty() && !outputs.PrintsData())
  {
    std::cout << reason << "\n";
    PrintSummary(check);
    const bool isField =
      check->GetOutput()->GetFieldData()->GetArray(names::UnwantedSingularities) != nullptr;
    if (options.corners.empty() && !isField)
    {
      PrintHint(domain, FieldValue(check->GetOutput(), names::RequiredInteriorQuarters));
    }
  }
  if (!options.json.empty())
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
  AddCornersTo(*command, options->corners);
  command->add_option("--propose", options->proposal,
    "write a consistent configuration to this .csv file: that of -s with what it lacks");
  command->add_flag("--cancel-flat", options->cancelFlat,
    "propose pairs that cancel corners of 135 to 180 degrees");
  AddJsonTo(*command, options->json);
  command->callback([options, &status] { status = Check(*options); });
}
