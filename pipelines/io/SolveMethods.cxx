#include "SolveMethods.h"

#include "vtkCrossFieldArrayNames.h"
#include "vtkGinzburgLandauCrossField.h"
#include "vtkPerforatedCrossField.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iostream>

namespace
{
namespace names = vtkCrossFieldArrayNames;

/** Values of --start, in the order of the codes of vtkPerforatedCrossField. */
const std::vector<std::string> Starts = { "best", "harmonic", "unit-norm" };
/** Values of --start, in the order of the codes of vtkGinzburgLandauCrossField. */
const std::vector<std::string> ReferenceStarts = { "harmonic", "constant", "zero" };

bool Contains(const std::vector<std::string>& starts, const std::string& start)
{
  return std::find(starts.begin(), starts.end(), start) != starts.end();
}

int CodeOf(const std::string& start, const std::vector<std::string>& starts)
{
  return static_cast<int>(std::find(starts.begin(), starts.end(), start) - starts.begin());
}

/** Prints what all methods report about their iteration. */
void PrintConvergence(vtkUnstructuredGrid* field)
{
  std::cout << (FieldValue(field, names::Converged) != 0.0 ? "converged" : "NOT converged")
            << " after " << FieldValue(field, names::Iterations) << " iterations (residual "
            << FieldValue(field, names::Residual) << "), unwanted singularities "
            << FieldValue(field, names::UnwantedSingularities);
}
}

namespace SolveMethods
{
std::vector<std::string> AllStarts()
{
  std::vector<std::string> all = Starts;
  for (const std::string& start : ReferenceStarts)
  {
    if (!Contains(all, start))
    {
      all.push_back(start);
    }
  }
  return all;
}

std::string DefaultMethod(const SolveOptions& options)
{
  const SolveOptions defaults;
  const bool isVariant = options.mode != defaults.mode || options.start != defaults.start ||
    options.unitHoles || !options.unitHoleRows.empty() || options.globalConstraint ||
    options.epsilon != defaults.epsilon;
  return isVariant ? "constrained" : "unit-norm";
}

void CheckUsage(const SolveOptions& options)
{
  const SolveOptions defaults;
  const bool isReference = options.method == Reference;
  if (isReference &&
    (options.mode != defaults.mode || options.globalConstraint || options.unitHoles ||
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
  const bool hasStart = options.method != "unit-norm";
  if (options.start != defaults.start &&
    !(hasStart && Contains(isReference ? ReferenceStarts : Starts, options.start)))
  {
    throw CLI::ValidationError(
      "--start " + options.start + " does not belong to --method " + options.method);
  }
}

void Configure(const SolveOptions& options, vtkPerforatedCrossField* solver)
{
  solver->SetMethod(options.method == "unit-norm" ? vtkPerforatedCrossField::MethodUnitNorm
                                                  : vtkPerforatedCrossField::MethodConstrained);
  solver->SetStart(CodeOf(options.start, Starts));
  solver->SetUnitHoles(options.unitHoles);
  for (const int row : options.unitHoleRows)
  {
    solver->AddUnitHole(row);
  }
  solver->SetGlobalConstraint(options.globalConstraint);
  solver->SetEpsilon(options.epsilon);
}

void Configure(const SolveOptions& options, vtkGinzburgLandauCrossField* solver)
{
  solver->SetEpsilon(options.epsilon);
  if (options.start != SolveOptions().start)
  {
    solver->SetStart(CodeOf(options.start, ReferenceStarts));
  }
}

void PrintSummary(vtkUnstructuredGrid* field)
{
  std::cout << "energy " << FieldValue(field, names::Energy) << ", ";
  PrintConvergence(field);
  std::cout << (FieldValue(field, names::UnitHoles) != 0.0 ? ", unit crosses on the holes" : "")
            << ", degrees of the holes";
  vtkDataArray* degrees = field->GetFieldData()->GetArray(names::HoleDegree);
  for (vtkIdType i = 0; i < degrees->GetNumberOfTuples(); ++i)
  {
    std::cout << " " << degrees->GetComponent(i, 0);
  }
  std::cout << (FieldValue(field, names::DegreesReached) != 0.0 ? "" : ", NOT the requested ones")
            << "\n";
}

void PrintReferenceSummary(vtkUnstructuredGrid* field)
{
  std::cout << "energy " << FieldValue(field, names::Energy) << " (gradient "
            << FieldValue(field, names::GradientEnergy) << ", penalty "
            << FieldValue(field, names::PenaltyEnergy) << ", epsilon "
            << FieldValue(field, names::Epsilon) << "), ";
  PrintConvergence(field);
  std::cout << "\n";
}
}
