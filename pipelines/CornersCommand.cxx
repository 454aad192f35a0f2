/**
 * crossfield corners DOMAIN [-o F.vtp]: computes the quarter indices of the corners of a domain in
 * each scenario of the paper, and chooses the cheapest ones.
 *
 *   crossfield corners builtin:l-shape -o corners.vtp --json -
 */
#include "BoundaryInput.h"
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "vtkBoundaryCornerClassifier.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldReport.h"

#include "vtkAbstractArray.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include <CLI/CLI.hpp>

#include <iostream>
#include <memory>
#include <vector>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct CornersOptions
{
  BoundaryOptions boundary;
  std::string domain;
  std::string output;
  std::string json;
  bool split = false;
  bool printed = false;
  std::vector<double> overrides; ///< x, y, quarter index; x, y, quarter index; …
};

void PrintSummary(vtkBoundaryCornerClassifier* classifier)
{
  vtkPolyData* corners = classifier->GetOutput();
  const auto value = [corners](const char* name, vtkIdType i)
  { return corners->GetPointData()->GetArray(name)->GetTuple1(i); };
  const bool hasHeight = vtkCrossFieldReport::HasHeight(classifier->GetInput());
  std::cout << (hasHeight ? "x y z" : "x y")
            << " angle quarter_index scarce balanced excess conventional energy\n";
  for (vtkIdType i = 0; i < corners->GetNumberOfPoints(); ++i)
  {
    std::cout << corners->GetPoint(i)[0] << " " << corners->GetPoint(i)[1];
    if (hasHeight)
    {
      std::cout << " " << corners->GetPoint(i)[2];
    }
    for (const char* name :
      { names::Angle, names::QuarterIndex, names::QuarterIndexScarce, names::QuarterIndexBalanced,
        names::QuarterIndexExcess, names::QuarterIndexConventional, names::CornerEnergy })
    {
      std::cout << " " << value(name, i);
    }
    std::cout << (value(names::Tied, i) != 0.0 ? " tied" : "")
              << (value(names::Cancellable, i) != 0.0 ? " cancellable" : "") << "\n";
  }
  auto* table = vtkTable::SafeDownCast(classifier->GetOutputDataObject(1));
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto entry = [&](const char* name) { return table->GetValueByName(row, name); };
    std::cout << entry(names::Scenario).ToString() << ": sum " << entry(names::Sum).ToInt()
              << ", energy " << entry(names::Energy).ToDouble()
              << (entry(names::Feasible).ToInt() != 0 ? "" : ", not feasible")
              << (entry(names::Chosen).ToInt() != 0 ? ", chosen" : "") << "\n";
  }
  std::cout << "energy " << FieldValue(corners, names::Energy) << ", interior quarter indices "
            << FieldValue(corners, names::InteriorQuarters) << "\n";
  PrintAmbiguous(corners->GetFieldData());
}

int Corners(const CornersOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable({ { options.output, ".vtp" }, { options.json, "" } });

  // 2. Read the domain and classify its corners.
  const auto domain = BoundaryInput::Open(options.domain, 0.0, options.boundary);
  vtkNew<vtkBoundaryCornerClassifier> classifier;
  classifier->SetInputConnection(domain->GetOutputPort());
  classifier->SetSplitHalves(options.split);
  classifier->SetPrintedCoefficient(options.printed);
  for (std::size_t i = 0; i + 2 < options.overrides.size(); i += 3)
  {
    classifier->AddOverride(
      options.overrides[i], options.overrides[i + 1], options.overrides[i + 2]);
  }
  PipelineRun::Update(classifier, "corners");

  // 3. Write the corners and the report.
  OutputTransaction outputs;
  OutputFile::WriteIfNamed(classifier->GetOutput(), options.output, outputs);
  if (!options.json.empty())
  {
    vtkNew<vtkCrossFieldReport> report;
    report->SetSource("data", classifier->GetOutput());
    report->SetSource("scenarios", classifier->GetOutputDataObject(1));
    report->SetSource("split", classifier->GetOutputDataObject(2));
    report->SetSource("domain", domain->GetOutputDataObject(0));
    outputs.Write(report->Write("corners"), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    PrintSummary(classifier);
  }
  outputs.Commit();
  return Done;
}
}

void AddCornersCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<CornersOptions>();
  CLI::App* command = app.add_subcommand("corners", "choose the quarter indices of the corners");
  command->footer("Example: crossfield corners builtin:l-shape -o corners.vtp --json -");
  command->add_option("DOMAIN", options->domain, DomainReader::Help)->required();
  options->boundary.AddTo(*command);
  command->add_option("-o,--output", options->output,
    "write the corners to this .vtp file, or to standard output for -");
  AddJsonTo(*command, options->json);
  command
    ->add_option("--override", options->overrides,
      "X Y K: give the corner nearest to (X, Y) the quarter index K; may be repeated")
    ->type_size(3)
    ->expected(1, 1000);
  command->add_flag("--split", options->split,
    "replace a corner of quarter index 2 by one of index 1 and a singularity close to it");
  command->add_flag("--printed-coefficient", options->printed,
    "count interior singularities twice in the energy, as the formula printed in the paper does");
  command->callback([options, &status] { status = Corners(*options); });
}
