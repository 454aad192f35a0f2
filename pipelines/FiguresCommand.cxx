/**
 * crossfield figures -o DIR: every figure of the paper that shows a computation, as .vtu, and a table
 * of what the paper says and what came out.
 *
 *   crossfield figures -o figures
 */
#include "CommandLine.h"
#include "MethodRun.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PaperFigures.h"
#include "PipelineRun.h"
#include "SingularityInput.h"
#include "vtkConfigurationProposal.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkHField.h"
#include "vtkPlanarDomainSource.h"
#include "vtkSingularitySource.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <iomanip>
#include <iostream>
#include <map>
#include <memory>
#include <sstream>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct FiguresOptions
{
  std::string folder;
  std::vector<std::string> only;
};

/** The singularities of a field, those on holes included, as "4 x +1, 1 x -1". */
std::string Found(vtkUnstructuredGrid* field)
{
  vtkNew<vtkCrossFieldSingularities> reader;
  reader->SetInputData(field);
  reader->IncludeHolesOn();
  PipelineRun::Update(reader, "reading singularities");
  vtkDataArray* quarters = reader->GetOutput()->GetPointData()->GetArray(names::QuarterIndex);
  std::map<int, int, std::greater<>> counts;
  for (vtkIdType i = 0; i < quarters->GetNumberOfTuples(); ++i)
  {
    ++counts[static_cast<int>(quarters->GetTuple1(i))];
  }
  std::ostringstream text;
  for (const auto& [quarter, count] : counts)
  {
    text << (text.tellp() > 0 ? ", " : "") << count << " x " << std::showpos << quarter
         << std::noshowpos;
  }
  return counts.empty() ? "none" : text.str();
}

struct FigureResult
{
  double energy;
  int iterations;
  bool converged;
  int unwanted;
  std::string found;
};

/** Computes a figure and writes its field. */
FigureResult Compute(
  const PaperFigure& figure, const std::string& folder, OutputTransaction& outputs)
{
  vtkNew<vtkPlanarDomainSource> domain;
  domain->SetDomainName(figure.domain);
  domain->SetEdgeLength(figure.size);
  if (figure.domain == "ring")
  {
    domain->SetInnerRadius(figure.innerRadius);
  }
  if (figure.domain == "ellipse") // semi-axes 3 and 0.6
  {
    domain->SetWidth(6.0);
    domain->SetHeight(1.2);
  }
  if (figure.domain == "l-shape")
  {
    domain->SetWidth(1.0);
  }
  vtkNew<vtkSingularitySource> rows;
  rows->RemoveAllSingularities();
  for (const auto& [x, y, quarter, radius] : figure.singularities)
  {
    rows->AddSingularity(x, y, quarter, radius > 0.0 ? radius : figure.size);
  }
  vtkNew<vtkConfigurationProposal> proposal;
  proposal->SetInputConnection(domain->GetOutputPort());
  vtkAlgorithm* singularities = rows;
  if (figure.propose)
  {
    singularities = proposal;
  }
  PipelineRun::Update(domain, figure.name.c_str());
  PipelineRun::Update(singularities, figure.name.c_str());

  MethodRun run;
  vtkNew<vtkHField> h;
  vtkUnstructuredGrid* field = nullptr;
  if (figure.method == "h")
  {
    h->SetInputConnection(domain->GetOutputPort());
    h->SetSingularitiesConnection(singularities->GetOutputPort());
    h->SetMeshSize(figure.size);
    PipelineRun::Update(h, figure.name.c_str());
    field = h->GetOutput();
  }
  else
  {
    run.Solve(figure.method, figure.size, figure.epsilon, domain, SingularityInput(singularities));
    field = run.GetField();
  }
  OutputFile::Write(field, folder + "/" + figure.name + ".vtu", outputs);

  const auto value = [field](const char* name)
  {
    vtkDataArray* array = field->GetFieldData()->GetArray(name);
    return array != nullptr ? array->GetComponent(0, 0) : 0.0;
  };
  return { value(names::Energy), static_cast<int>(value(names::Iterations)),
    value(names::Converged) != 0.0, static_cast<int>(value(names::UnwantedSingularities)),
    Found(field) };
}

int ComputeFigures(const FiguresOptions& options)
{
  // 1. The folder.
  OutputTransaction outputs;
  outputs.MakeFolder(options.folder);
  OutputFile::RequireWritable({ { options.folder + "/summary.csv", ".csv" } });

  // 2. The figures, and a row for each.
  bool allConverged = true;
  std::ostringstream csv;
  csv << "figure,paper,paper_says,method,energy,iterations,converged,singularities,"
         "unwanted_singularities\n"
      << std::setprecision(10);
  std::cout << std::left << std::setw(18) << "figure" << std::setw(10) << "energy" << std::setw(11)
            << "iterations" << std::setw(24) << "singularities"
            << "the paper says\n";
  for (const PaperFigure& figure : PaperFigures())
  {
    if (!options.only.empty() &&
      std::find(options.only.begin(), options.only.end(), figure.name) == options.only.end())
    {
      continue;
    }
    const FigureResult result = Compute(figure, options.folder, outputs);
    allConverged = allConverged && result.converged;
    csv << figure.name << ",\"" << figure.label << "\",\"" << figure.says << "\"," << figure.method
        << "," << result.energy << "," << result.iterations << "," << result.converged << ",\""
        << result.found << "\"," << result.unwanted << "\n";
    std::cout << std::setw(18) << figure.name << std::setw(10) << result.energy << std::setw(11)
              << result.iterations << std::setw(24) << result.found << figure.says
              << (result.converged ? "" : " (NOT converged)") << std::endl;
  }

  // 3. The table.
  outputs.Write(csv.str(), options.folder + "/summary.csv");
  outputs.Commit();
  return allConverged ? Done : AnswerIsNo;
}

std::vector<std::string> Names()
{
  std::vector<std::string> all;
  for (const PaperFigure& figure : PaperFigures())
  {
    all.push_back(figure.name);
  }
  return all;
}
}

void AddFiguresCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<FiguresOptions>();
  CLI::App* command = app.add_subcommand(
    "figures", "compute every figure of the paper, with a table of what the paper says of it");
  command->footer("Example: crossfield figures -o figures");
  command->add_option("-o,--output", options->folder, "the folder to write to; made if missing")
    ->required();
  command->add_option("--only", options->only, "names of figures, separated by commas")
    ->delimiter(',')
    ->check(CLI::IsMember(Names()));
  command->callback([options, &status] { status = ComputeFigures(*options); });
}
