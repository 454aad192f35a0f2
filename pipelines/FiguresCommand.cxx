/**
 * crossfield figures -o DIR: computes every figure of the paper that shows a computation, writes
 * each as .vtu, and a table that compares the results with the statements of the paper.
 *
 *   crossfield figures -o figures
 */
#include "CommandLine.h"
#include "FigureRun.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PaperFigures.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <memory>
#include <sstream>

namespace
{
struct FiguresOptions
{
  std::string folder;
  std::vector<std::string> only;
};

int ComputeFigures(const FiguresOptions& options)
{
  // 1. Make the folder.
  OutputTransaction outputs;
  outputs.MakeFolder(options.folder);
  OutputFile::RequireWritable({ { options.folder + "/summary.csv", ".csv" } });

  // 2. Compute the figures, with a row of the table for each.
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
    const FigureResult result = ComputeFigure(figure, options.folder, outputs);
    allConverged = allConverged && result.converged;
    csv << figure.name << ",\"" << figure.label << "\",\"" << figure.says << "\"," << figure.method
        << "," << result.energy << "," << result.iterations << "," << result.converged << ",\""
        << result.found << "\"," << result.unwanted << "\n";
    std::cout << std::setw(18) << figure.name << std::setw(10) << result.energy << std::setw(11)
              << result.iterations << std::setw(24) << result.found << figure.says
              << (result.converged ? "" : " (NOT converged)") << std::endl;
  }

  // 3. Write the table.
  outputs.Write(csv.str(), options.folder + "/summary.csv");
  outputs.Commit();
  return allConverged ? Done : AnswerIsNo;
}

std::vector<std::string> FigureNames()
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
  CLI::App* command = app.add_subcommand("figures",
    "compute every figure of the paper, with a table that compares them with its statements");
  command->footer("Example: crossfield figures -o figures");
  command
    ->add_option("-o,--output", options->folder,
      "write the figures to this folder, which is made if it is missing")
    ->required();
  command
    ->add_option(
      "--only", options->only, "names of the figures to compute, separated by commas; default: all")
    ->delimiter(',')
    ->check(CLI::IsMember(FigureNames()));
  command->callback([options, &status] { status = ComputeFigures(*options); });
}
