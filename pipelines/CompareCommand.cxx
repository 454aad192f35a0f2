/**
 * crossfield compare DOMAIN [-s S.csv] -o F.vtm: solves with several methods on one domain and
 * configuration, and writes a table and one multiblock file that shows the fields side by side.
 *
 *   crossfield compare builtin:disk -s four.csv -o compared.vtm --epsilon 0.05
 */
#include "CommandLine.h"
#include "CompareTable.h"
#include "DomainReader.h"
#include "MethodRun.h"
#include "NumberCheck.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "SingularityInput.h"

#include "vtkAlgorithm.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <utility>

namespace
{
struct CompareOptions : MeshOptions
{
  std::vector<std::string> methods = { "constrained", "unit-norm", "unit-holes",
    "global-constraint", "imprint", "penalty", "ginzburg-landau" };
  double epsilon = 0.0;
  bool inPlace = false;
  std::string csv;
  std::string json;
  std::string savedSingularities;
};

/** Returns a copy of a field, translated along x. */
vtkSmartPointer<vtkUnstructuredGrid> Translated(vtkUnstructuredGrid* field, double offset)
{
  auto moved = vtkSmartPointer<vtkUnstructuredGrid>::New();
  moved->ShallowCopy(field);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->DeepCopy(field->GetPoints());
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    double place[3];
    points->GetPoint(i, place);
    points->SetPoint(i, place[0] + offset, place[1], place[2]);
  }
  moved->SetPoints(points);
  return moved;
}

int Compare(const CompareOptions& options)
{
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable({ { options.output, ".vtm" }, { options.csv, "" },
    { options.json, "" }, { options.savedSingularities, ".csv" } });

  // 2. Read the domain and the configuration; the default of epsilon is the mesh size.
  const auto domain = BoundaryInput::Open(options.domain, options.size, options.boundary);
  PipelineRun::Update(domain, "reading");
  SingularityInput singularities(options.singularities, domain, options.size, "");
  singularities.Update();
  const std::array<double, 6> bounds =
    DomainReader::Bounds(vtkDataSet::SafeDownCast(domain->GetOutputDataObject(0)));
  const double width = bounds[1] - bounds[0];
  const double diagonal = std::hypot(width, bounds[3] - bounds[2]);
  const double epsilon = options.epsilon != 0.0 ? options.epsilon
    : options.size != 0.0                       ? options.size
                                                : diagonal / 40.0;

  // 3. Solve with every method. A method that refuses the configuration becomes a row with its
  // sentence.
  std::vector<CompareRow> rows;
  OutputFile::Blocks blocks;
  std::optional<PipelineRun::Error> refused;
  bool allConverged = true;
  bool configurationAccepted = false; // by at least one method that uses it
  for (const std::string& method : options.methods)
  {
    MethodRun run;
    try
    {
      rows.push_back(run.Solve(method, options.size, epsilon, domain, singularities));
      const double offset =
        options.inPlace ? 0.0 : 1.2 * width * static_cast<double>(blocks.size());
      blocks.emplace_back(method, Translated(run.GetField(), offset));
      allConverged = allConverged && rows.back().converged;
      configurationAccepted = configurationAccepted || !MethodRun::IsReference(method);
    }
    catch (const PipelineRun::Error& error)
    {
      refused = refused.has_value() ? refused : error;
      rows.emplace_back();
      rows.back().method = method;
      rows.back().note = error.what();
    }
  }
  const bool badConfiguration =
    refused.has_value() && refused->GetStatus() == BadInput && !configurationAccepted;
  if (blocks.empty() || badConfiguration)
  {
    throw PipelineRun::Error(*refused);
  }

  // 4. Write the fields and the table.
  OutputTransaction outputs;
  singularities.Save(options.savedSingularities, outputs);
  if (!options.output.empty())
  {
    OutputFile::WriteBlocks(blocks, options.output, outputs);
  }
  if (!options.csv.empty())
  {
    outputs.Write(CompareTable::Csv(rows), options.csv);
  }
  if (!options.json.empty())
  {
    outputs.Write(CompareTable::Json(rows, domain->GetOutputDataObject(0)), options.json);
  }
  if (options.json.empty() && !outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    singularities.PrintChoice(options.verbose);
    std::cout << CompareTable::Text(rows);
  }
  outputs.Commit();

  // 5. Return the answer.
  return refused.has_value() || !allConverged ? AnswerIsNo : Done;
}
}

void AddCompareCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
    app.add_subcommand("compare", "compute the cross field with several methods and compare them");
  command->footer("Example: crossfield compare builtin:disk -s four.csv -o compared.vtm\n"
                  "Exit status 1 if a method refused the configuration or did not converge.");
  options->AddTo(*command);
  command->get_option("--output")
    ->description("write the fields to this .vtm file, and to a folder of the same name beside it");
  command
    ->add_option("--methods", options->methods,
      "methods to compare, separated by commas, out of constrained, unit-norm, unit-holes, "
      "global-constraint, imprint, imprint-unit, triangle, triangle-penalty, penalty (holes and "
      "the "
      "Ginzburg-Landau penalty), ginzburg-landau, ginzburg-landau-constant (from a constant start)")
    ->delimiter(',')
    ->capture_default_str()
    ->check(CLI::IsMember(MethodRun::AllMethods()));
  command
    ->add_option("--epsilon", options->epsilon,
      "length of the penalty for all methods that have one, positive; default: the mesh size")
    ->check(NumberCheck::Positive());
  command->add_flag("--in-place", options->inPlace,
    "keep the fields in place instead of placing them side by side");
  command->add_option(
    "--csv", options->csv, "write the table as CSV to this file, or to standard output for -");
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddVerboseTo(*command, options->verbose);
  AddJsonTo(*command, options->json);
  command->callback([options, &status] { status = Compare(*options); });
}
