/**
 * crossfield compare DOMAIN [-s S.csv] -o F.vtm: several methods on one domain and configuration, in
 * one table and one multiblock file to look at side by side.
 *
 *   crossfield compare builtin:disk -s four.csv -o compared.vtm --epsilon 0.05
 */
#include "CommandLine.h"
#include "CompareTable.h"
#include "DomainReader.h"
#include "MethodRun.h"
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

/** A copy of a field that is moved along x. */
vtkSmartPointer<vtkUnstructuredGrid> Moved(vtkUnstructuredGrid* field, double offset)
{
  auto moved = vtkSmartPointer<vtkUnstructuredGrid>::New();
  moved->ShallowCopy(field);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble(); // as everywhere: crosses are aligned with edges to rounding
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

  // 2. Read the domain and the configuration; epsilon is the mesh size unless it is given.
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

  // 3. Solve by every method. What one of them refuses is a row of the table.
  std::vector<CompareRow> rows;
  OutputFile::Blocks blocks;
  std::optional<PipelineRun::Error> refused;
  bool allConverged = true;
  bool configurationServed = false; // by a method that makes use of it
  for (const std::string& method : options.methods)
  {
    MethodRun run;
    try
    {
      rows.push_back(run.Solve(method, options.size, epsilon, domain, singularities));
      const double offset =
        options.inPlace ? 0.0 : 1.2 * width * static_cast<double>(blocks.size());
      blocks.emplace_back(method, Moved(run.GetField(), offset));
      allConverged = allConverged && rows.back().converged;
      configurationServed = configurationServed || !MethodRun::IsReference(method);
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
    refused.has_value() && refused->GetStatus() == BadInput && !configurationServed;
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
    outputs.Write(BoundaryInput::AddTo(CompareTable::Json(rows), domain), options.json);
  }
  if (options.json.empty() && !outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    singularities.PrintChoice();
    std::cout << CompareTable::Text(rows);
  }
  outputs.Commit();

  // 5. The answer.
  return refused.has_value() || !allConverged ? AnswerIsNo : Done;
}
}

void AddCompareCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<CompareOptions>();
  CLI::App* command =
    app.add_subcommand("compare", "compute the cross field by several methods and compare them");
  command->footer("Example: crossfield compare builtin:disk -s four.csv -o compared.vtm\n"
                  "Exit status 1 when a method refused the configuration or did not converge.");
  options->AddTo(*command);
  command->get_option("--output")
    ->description("the .vtm file to write; the fields go to a folder of the same name beside it");
  command
    ->add_option("--methods", options->methods,
      "separated by commas: constrained, unit-norm, unit-holes, global-constraint, imprint, "
      "imprint-unit, triangle, triangle-penalty, penalty (holes with the Ginzburg-Landau penalty), "
      "ginzburg-landau, ginzburg-landau-constant (its constant start)")
    ->delimiter(',')
    ->capture_default_str()
    ->check(CLI::IsMember(MethodRun::AllMethods()));
  command
    ->add_option("--epsilon", options->epsilon,
      "length of the penalty, of all methods that have one; default: the mesh size")
    ->check(CLI::PositiveNumber);
  command->add_flag(
    "--in-place", options->inPlace, "leave the fields where they are instead of side by side");
  command->add_option("--csv", options->csv, "write the table to this file, or - for output");
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  command->add_option("--json", options->json, "write the table to this file, or - for output");
  command->callback([options, &status] { status = Compare(*options); });
}
