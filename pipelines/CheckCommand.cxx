/**
 * crossfield check DOMAIN [-s S.csv] [--propose F.csv [--alternatives N]]: which configurations can exist on a domain,
 * by the generalised Poincaré-Hopf theorem, and why. Exit status 1 when the given one cannot.
 *
 *   crossfield check builtin:disk -s four.csv --json -
 */
#include "BoundaryInput.h"
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
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

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
  double coreRadius = 0.0;
  bool cancelFlat = false;
};

/** F_1.csv beside F.csv, for the first alternative. */
std::string AlternativeFile(const std::string& proposal, int number)
{
  return proposal.substr(0, proposal.rfind('.')) + "_" + std::to_string(number) + ".csv";
}

/** The points of one alternative. */
vtkSmartPointer<vtkPolyData> AlternativePoints(vtkConfigurationProposal* proposal, int number)
{
  auto* all = vtkPolyData::SafeDownCast(proposal->GetOutputDataObject(3));
  vtkDataArray* numbers = all->GetPointData()->GetArray(names::Alternative);
  auto result = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIntArray> quarters;
  quarters->SetName(names::QuarterIndex);
  for (vtkIdType i = 0; i < all->GetNumberOfPoints(); ++i)
  {
    if (static_cast<int>(numbers->GetTuple1(i)) == number)
    {
      points->InsertNextPoint(all->GetPoint(i));
      quarters->InsertNextValue(
        static_cast<int>(all->GetPointData()->GetArray(names::QuarterIndex)->GetTuple1(i)));
    }
  }
  result->SetPoints(points);
  result->GetPointData()->AddArray(quarters);
  return result;
}

void PrintAlternatives(vtkTable* table)
{
  std::cout << "alternative singularities logarithm_coefficient renormalized_energy "
               "energy_at_core_radius holonomy_defect size_spread origin\n";
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    for (const char* name : { names::Alternative, names::Singularities, names::LogarithmCoefficient,
           names::RenormalizedEnergy, names::EnergyAtCoreRadius, names::HolonomyDefect,
           names::SizeSpread })
    {
      std::cout << table->GetValueByName(row, name).ToDouble() << " ";
    }
    std::cout << table->GetValueByName(row, names::Origin).ToString() << "\n";
  }
}

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
  const auto domain = BoundaryInput::Open(options.domain, 0.0, options.boundary);
  vtkNew<vtkPoincareHopfCheck> check;
  vtkNew<vtkConfigurationProposal> proposal;
  check->SetInputConnection(domain->GetOutputPort());
  proposal->SetInputConnection(domain->GetOutputPort());
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

  // 3. Propose; without a given configuration the proposal is what is checked.
  if (!options.proposal.empty())
  {
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

  // 4. Write.
  OutputTransaction outputs;
  if (!options.proposal.empty())
  {
    OutputFile::WriteConfiguration(proposal->GetOutput(),
      DomainReader::HasHeight(check->GetOutput()), options.proposal, outputs);
    auto* table = vtkTable::SafeDownCast(proposal->GetOutputDataObject(2));
    for (int i = 1; i < static_cast<int>(table->GetNumberOfRows()); ++i)
    {
      OutputFile::WriteConfiguration(AlternativePoints(proposal, i),
        DomainReader::HasHeight(check->GetOutput()), AlternativeFile(options.proposal, i), outputs);
    }
  }
  const std::string reason = vtkStringArray::SafeDownCast(
    check->GetOutput()->GetFieldData()->GetAbstractArray(names::Reason))
                               ->GetValue(0);
  const bool consistent = FieldValue(check->GetOutput(), names::Consistent) != 0.0;
  if (options.json.empty() && !outputs.PrintsData())
  {
    std::cout << reason << "\n";
    BoundaryInput::Print(domain);
    PrintSummary(check);
    if (options.alternatives > 0)
    {
      PrintAlternatives(vtkTable::SafeDownCast(proposal->GetOutputDataObject(2)));
    }
    const bool isField =
      check->GetOutput()->GetFieldData()->GetArray(names::UnwantedSingularities) != nullptr;
    if (options.corners.empty() && !isField)
    {
      PrintHint(domain, FieldValue(check->GetOutput(), names::RequiredInteriorQuarters));
    }
  }
  if (!options.json.empty())
  {
    outputs.Write(BoundaryInput::AddTo(TopologyJson::Write(check), domain), options.json);
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
  options->boundary.AddTo(*command);
  command->add_option("-s,--singularities", options->singularities,
    "configuration: .csv with the header x,y,quarter_index[,radius], or .vtp; default: none");
  AddCornersTo(*command, options->corners);
  CLI::Option* proposing = command->add_option("--propose", options->proposal,
    "write a consistent configuration to this .csv file: that of -s with what it lacks");
  command
    ->add_option("--alternatives", options->alternatives,
      "with --propose F.csv: write up to so many others, the best first, to F_1.csv, F_2.csv, …")
    ->check(CLI::Range(0, 100))
    ->needs(proposing);
  command
    ->add_option("--core-radius", options->coreRadius,
      "radius of cores at which their energies are compared; default: 1/100 of the diagonal")
    ->check(CLI::NonNegativeNumber);
  command->add_flag("--cancel-flat", options->cancelFlat,
    "propose pairs that cancel corners of 135 to 180 degrees");
  AddJsonTo(*command, options->json);
  command->callback([options, &status] { status = Check(*options); });
}
