/**
 * crossfield solve DOMAIN [-s S.csv] -o F.vtu: the cross field with chosen singularities.
 *
 *   crossfield solve builtin:disk -s four.csv -o field.vtu --json -
 *   crossfield solve builtin:ring --method ginzburg-landau --epsilon 0.01 --start constant \
 *     --size 0.04 -o field.vtu
 */
#include "CommandLine.h"
#include "DomainReader.h"
#include "OutputFile.h"
#include "OutputTransaction.h"
#include "PipelineRun.h"
#include "ReportJson.h"
#include "SingularityInput.h"
#include "vtkCrossFieldArrayNames.h"
#include "vtkCrossFieldSingularities.h"
#include "vtkDrillHoles.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkPerforatedCrossField.h"
#include "vtkSingularitySource.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>
#include <memory>

namespace
{
namespace names = vtkCrossFieldArrayNames;

struct SolveOptions : MeshOptions
{
  std::string method; ///< Empty: unit-norm, or the one that other options belong to.
  std::string start = "best";
  std::string mode = "perforate";
  bool unitHoles = false;
  std::vector<int> unitHoleRows;
  bool globalConstraint = false;
  double epsilon = 0.0;
  std::string corners;
  std::string json;
  std::string savedSingularities;
  bool strict = false;
  int arrays = vtkCrossFieldArraySets::All;
};

/** Names of the starts, in the order of the codes of vtkPerforatedCrossField. */
const std::vector<std::string> Starts = { "best", "harmonic", "unit-norm" };
/** And of vtkGinzburgLandauCrossField, "the reference", which places singularities by itself. */
const std::vector<std::string> ReferenceStarts = { "harmonic", "constant", "zero" };

int CodeOf(const std::string& start, const std::vector<std::string>& starts)
{
  return static_cast<int>(std::find(starts.begin(), starts.end(), start) - starts.begin());
}

void PrintSummary(vtkUnstructuredGrid* field)
{
  std::cout << "energy " << FieldValue(field, names::Energy) << ", "
            << (FieldValue(field, names::Converged) != 0.0 ? "converged" : "NOT converged")
            << " after " << FieldValue(field, names::Iterations) << " iterations (residual "
            << FieldValue(field, names::Residual) << "), unwanted singularities "
            << FieldValue(field, names::UnwantedSingularities)
            << (FieldValue(field, names::UnitHoles) != 0.0 ? ", unit crosses on the holes" : "")
            << ", degrees of the holes";
  vtkDataArray* degrees = field->GetFieldData()->GetArray(names::HoleDegree);
  for (vtkIdType i = 0; i < degrees->GetNumberOfTuples(); ++i)
  {
    std::cout << " " << degrees->GetComponent(i, 0);
  }
  std::cout << (FieldValue(field, names::DegreesReached) != 0.0 ? "" : ", NOT those asked for")
            << "\n";
}

/** Of a field whose singularities were not chosen. */
void PrintReferenceSummary(vtkUnstructuredGrid* field)
{
  std::cout << "energy " << FieldValue(field, names::Energy) << " (gradient "
            << FieldValue(field, names::GradientEnergy) << ", penalty "
            << FieldValue(field, names::PenaltyEnergy) << ", epsilon "
            << FieldValue(field, names::Epsilon) << "), "
            << (FieldValue(field, names::Converged) != 0.0 ? "converged" : "NOT converged")
            << " after " << FieldValue(field, names::Iterations) << " iterations (residual "
            << FieldValue(field, names::Residual) << "), unwanted singularities "
            << FieldValue(field, names::UnwantedSingularities) << "\n";
}

/** The names of all starts, of the constrained and the Ginzburg-Landau method. */
std::vector<std::string> AllStarts()
{
  std::vector<std::string> all = Starts;
  for (const std::string& start : ReferenceStarts)
  {
    if (std::find(all.begin(), all.end(), start) == all.end())
    {
      all.push_back(start);
    }
  }
  return all;
}

/** The method where none was named: that of the paper with options that only it has. */
std::string DefaultMethod(const SolveOptions& options)
{
  const SolveOptions defaults;
  const bool variant = options.mode != defaults.mode || options.start != defaults.start ||
    options.unitHoles || !options.unitHoleRows.empty() || options.globalConstraint ||
    options.epsilon != defaults.epsilon;
  return variant ? "constrained" : "unit-norm";
}

/** Throws what makes bad usage when an option does not belong to the method. */
void CheckUsage(const SolveOptions& options)
{
  const bool reference = options.method == "ginzburg-landau";
  if (reference &&
    (options.mode != SolveOptions().mode || options.globalConstraint || options.unitHoles ||
      !options.unitHoleRows.empty()))
  {
    throw CLI::ValidationError(
      "--mode, --unit-holes, --unit-hole and --global-constraint do not belong to --method "
      "ginzburg-landau, which has no holes");
  }
  if (options.method == "unit-norm" && options.epsilon != 0.0)
  {
    throw CLI::ValidationError("--epsilon belongs to the methods constrained and ginzburg-landau");
  }
  static const std::vector<std::string> none;
  const std::vector<std::string>& starts = reference ? ReferenceStarts
    : options.method == "unit-norm"                  ? none
                                                     : Starts;
  const bool isDefault = options.start == SolveOptions().start;
  if (!isDefault && std::find(starts.begin(), starts.end(), options.start) == starts.end())
  {
    throw CLI::ValidationError(
      "--start " + options.start + " does not belong to --method " + options.method);
  }
}

int Solve(const SolveOptions& options)
{
  CheckUsage(options);
  // 1. Check the outputs before any work.
  OutputFile::RequireWritable(
    { { options.output, ".vtu" }, { options.json, "" }, { options.savedSingularities, ".csv" } });

  // 2. Read the domain and the configuration. The reference makes nothing of one, but a wrong name
  //    shall not go unnoticed.
  const bool isReference = options.method == "ginzburg-landau";
  const auto domain = BoundaryInput::Open(options.domain, options.size, options.boundary);
  SingularityInput singularities(options.singularities, domain, options.size, options.corners);
  if (!isReference || !singularities.AreChosen())
  {
    singularities.Update();
  }
  vtkNew<vtkSingularitySource> none;
  none->RemoveAllSingularities();

  // 3. Drill a hole at every singularity.
  vtkNew<vtkTimerLog> timer;
  timer->StartTimer();
  vtkNew<vtkDrillHoles> drill;
  drill->SetInputConnection(domain->GetOutputPort());
  drill->SetSingularitiesConnection(
    isReference ? none->GetOutputPort() : singularities.GetOutputPort());
  drill->SetMeshSize(options.size);
  drill->SetMode(DrillModeCode(options.mode));
  PipelineRun::Update(drill, "drilling");
  timer->StopTimer();
  std::map<std::string, double> seconds;
  seconds["mesh"] = timer->GetElapsedTime();

  // 4. Solve.
  vtkNew<vtkGinzburgLandauCrossField> reference;
  vtkNew<vtkPerforatedCrossField> constrained;
  vtkCrossFieldSolver* solver = constrained;
  if (isReference)
  {
    solver = reference;
    reference->SetEpsilon(options.epsilon);
    if (options.start != SolveOptions().start)
    {
      reference->SetStart(CodeOf(options.start, ReferenceStarts));
    }
  }
  else
  {
    constrained->SetMethod(options.method == "unit-norm"
        ? vtkPerforatedCrossField::MethodUnitNorm
        : vtkPerforatedCrossField::MethodConstrained);
    constrained->SetStart(CodeOf(options.start, Starts));
    constrained->SetUnitHoles(options.unitHoles);
    for (const int row : options.unitHoleRows)
    {
      constrained->AddUnitHole(row);
    }
    constrained->SetGlobalConstraint(options.globalConstraint);
    constrained->SetEpsilon(options.epsilon);
    singularities.ConnectCorners(constrained.Get());
  }
  solver->SetInputConnection(drill->GetOutputPort());
  solver->SetArrays(options.arrays);
  PipelineRun::Update(solver, "solving");
  vtkUnstructuredGrid* field = solver->GetOutput();
  seconds["assemble"] = solver->GetStageSeconds()[0];
  seconds["factor"] = solver->GetStageSeconds()[1];
  seconds["solve"] = solver->GetStageSeconds()[2];

  // 5. Where singularities may appear by themselves, find them.
  const bool mayAppear =
    isReference || options.mode != SolveOptions().mode || options.epsilon != 0.0;
  vtkNew<vtkCrossFieldSingularities> found;
  found->SetInputConnection(solver->GetOutputPort());
  vtkDataSet* shown = singularities.GetOutput();
  if (mayAppear)
  {
    PipelineRun::Update(found, "reading singularities");
    shown = found->GetOutput();
  }

  // 6. Write the field and the report.
  OutputTransaction outputs;
  seconds["write"] = OutputFile::WriteIfNamed(field, options.output, outputs);
  if (!options.savedSingularities.empty())
  {
    OutputFile::WriteConfiguration(isReference ? shown : singularities.GetOutput(),
      DomainReader::HasHeight(field), options.savedSingularities, outputs);
  }
  if (!options.json.empty())
  {
    outputs.Write(
      BoundaryInput::AddTo(ReportJson::Write(field, seconds, shown), domain), options.json);
  }
  else if (!outputs.PrintsData())
  {
    BoundaryInput::Print(domain);
    if (!isReference)
    {
      singularities.PrintChoice();
    }
    isReference ? PrintReferenceSummary(field) : PrintSummary(field);
    if (mayAppear)
    {
      PrintSingularities(shown, DomainReader::HasHeight(field));
    }
  }
  outputs.Commit();

  // 7. The answer.
  const bool unwanted = FieldValue(field, names::UnwantedSingularities) != 0.0 ||
    (!isReference && FieldValue(field, names::DegreesReached) == 0.0);
  return FieldValue(field, names::Converged) == 0.0 || (options.strict && unwanted) ? AnswerIsNo
                                                                                    : Done;
}
}

void AddSolveCommand(CLI::App& app, int& status)
{
  auto options = std::make_shared<SolveOptions>();
  CLI::App* command = app.add_subcommand("solve", "compute the cross field");
  command->footer("Example: crossfield solve builtin:disk -s four.csv -o field.vtu --json -");
  options->AddTo(*command);
  command
    ->add_option("--method", options->method,
      "unit-norm, which has exactly the singularities asked for; constrained, that of the paper, "
      "whose norm is free and may vanish elsewhere; or ginzburg-landau, which places singularities "
      "by itself and makes no use of -s; default: unit-norm, or constrained with options that only it "
      "has")
    ->check(CLI::IsMember({ "constrained", "unit-norm", "ginzburg-landau" }));
  command
    ->add_option("--start", options->start,
      "of the constrained method: harmonic, unit-norm, or best of both; of ginzburg-landau: "
      "harmonic (its default), constant or zero")
    ->capture_default_str()
    ->check(CLI::IsMember(AllStarts()));
  command
    ->add_option("--epsilon", options->epsilon,
      "length of the penalty on the norm, about the size of a triangle: of ginzburg-landau (default: "
      "the mean edge length by area), or added to the constrained method, which then takes any sum of quarter "
      "indices")
    ->check(CLI::PositiveNumber);
  AddModeTo(*command, options->mode);
  command->add_flag("--unit-holes", options->unitHoles, "force unit crosses on the holes");
  command
    ->add_option("--unit-hole", options->unitHoleRows,
      "force unit crosses on the hole of this row of the configuration, counted from 0; may be "
      "given several times")
    ->expected(1)
    ->take_all();
  command->add_flag("--global-constraint", options->globalConstraint,
    "prescribe the sum of the degrees only, not that of every hole");
  AddCornersTo(*command, options->corners);
  AddArraysTo(*command, options->arrays);
  AddSaveSingularitiesTo(*command, options->savedSingularities);
  AddJsonTo(*command, options->json);
  command->add_flag("--strict", options->strict,
    "exit with status 1 when there are unwanted singularities or a degree was not reached");
  command->callback(
    [options, &status]
    {
      options->method = options->method.empty() ? DefaultMethod(*options) : options->method;
      status = Solve(*options);
    });
}
