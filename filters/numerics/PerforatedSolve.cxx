#include "PerforatedSolve.h"

#include "ConstrainedField.h"
#include "Stopwatch.h"
#include "UnitNormField.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
/// Alignment that is off by more than this is not rounding: the potential did not fit its boundary.
constexpr double AlignmentTolerance = 1e-6;

void UseUnitNorm(const PerforatedProblem& problem, CrossField& field)
{
  UnitNormField result = SolveUnitNorm(problem);
  field.u = std::move(result.u);
  field.energy = result.energy;
  field.residual = result.residual;
  field.converged = result.residual <= AlignmentTolerance;
  field.holonomyDefect = std::move(result.holonomyDefect);
}

void UseConstrained(const PerforatedProblem& problem, const ReducedOptions& options,
  const Progress& progress, CrossField& field)
{
  const ConstrainedSolver solver(problem);
  progress.Report(0.3);
  ConstrainedField result = solver.Recover(
    SolveReduced(solver.GetReducedProblem(), options, progress.Part(0.3, 0.7)));
  field.u = std::move(result.u);
  field.energy = result.energy;
  field.iterations = result.reduced.iterations;
  field.residual = result.reduced.residual;
  field.converged =
    result.reduced.converged && result.alignmentResidual <= AlignmentTolerance;
  field.multipliers.assign(
    result.reduced.multipliers.begin(), result.reduced.multipliers.end());
}
}

CrossField SolvePerforated(
  const TriangleMesh& mesh, const PerforatedOptions& options, const Progress& progress)
{
  CrossField field;
  PerforatedProblem problem(mesh);
  field.count = problem.count;
  field.seconds.assemble = problem.assembleSeconds;
  field.seconds.factor = problem.factorSeconds;
  progress.Report(0.6);

  Stopwatch stopwatch;
  if (options.method == PerforatedMethod::UnitNorm)
  {
    UseUnitNorm(problem, field);
  }
  else
  {
    UseConstrained(problem, options.reduced, progress.Part(0.6, 0.9), field);
  }
  field.seconds.solve = stopwatch.Lap();
  field.edges = std::move(problem.edges);
  ReadReport(mesh, problem.loops, field);
  progress.Report(1.0);
  return field;
}
}
