#include "PerforatedSolve.h"

#include "ConstrainedField.h"
#include "DualSolve.h"
#include "LocalSolve.h"
#include "UnitSolve.h"
#include "Stopwatch.h"
#include "UnitNormField.h"
#include "VariantSolve.h"

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
  ReadReport(problem.mesh, problem.loops, field);
}

/// Puts one solution of the constrained problem into the field and reads the report.
void UseSolution(const PerforatedProblem& problem, const ConstrainedSolver& solver,
  const ReducedSolution& solution, CrossField& field)
{
  ConstrainedField result = solver.Recover(solution);
  field.u = std::move(result.u);
  field.energy = result.energy;
  field.iterations = solution.iterations;
  field.residual = solution.residual;
  field.converged = solution.converged && result.alignmentResidual <= AlignmentTolerance;
  field.multipliers.assign(solution.multipliers.begin(), solution.multipliers.end());
  ReadReport(problem.mesh, problem.loops, field);
}

void UseConstrained(const PerforatedProblem& problem, const PerforatedOptions& options,
  const Progress& progress, CrossField& field)
{
  const ConstrainedSolver solver(problem);
  progress.Report(0.2);
  if (options.start != PerforatedStart::UnitNorm)
  {
    Stopwatch stopwatch;
    const ReducedSolution solution =
      SolveReduced(solver.GetReducedProblem(), options.reduced, progress.Part(0.2, 0.5));
    field.seconds.newton = stopwatch.Lap();
    UseSolution(problem, solver, solution, field);
    const bool asWished =
      field.converged && field.wrongDegrees == 0 && field.unwantedSingularities == 0;
    if (options.start == PerforatedStart::Harmonic || asWished)
    {
      return;
    }
  }
  // A second opinion that takes longer than the paper's longest run would not settle either.
  ReducedOptions patience = options.reduced;
  patience.maximumIterations = std::min(patience.maximumIterations, 60);
  const ComplexVector unitNorm = SolveUnitNorm(problem).u;
  CrossField other = field;
  other.startedFromUnitNorm = true;
  UseSolution(problem, solver,
    SolveReducedFrom(
      solver.GetReducedProblem(), solver.HoleValues(unitNorm), patience, progress.Part(0.5, 0.8)),
    other);
  if (options.start == PerforatedStart::UnitNorm || IsBetter(other, field))
  {
    field = std::move(other);
  }
}

/// |u| = 1 on the holes, from the unit-norm field.
void UseUnitHoles(const PerforatedProblem& islandsOnly, const ReducedOptions& options,
  const Progress& progress, CrossField& field)
{
  const PerforatedProblem problem(
    islandsOnly.mesh, PotentialSolver::Periods::IslandsAndHoles, islandsOnly.corners);
  const ConstrainedSolver solver(problem);
  field.startedFromUnitNorm = true;
  field.unitHoles = true;
  UseSolution(problem, solver,
    SolveReducedUnit(solver.GetReducedProblem(), solver.HoleValues(SolveUnitNorm(islandsOnly).u),
      options, progress),
    field);
}
}

CrossField SolvePerforated(
  const TriangleMesh& mesh, const PerforatedOptions& options, const Progress& progress)
{
  if (IsVariant(mesh, options))
  {
    return SolveVariant(mesh, options, progress);
  }
  CrossField field;
  const PerforatedProblem problem(
    mesh, PotentialSolver::Periods::Islands, options.corners, 0, progress.Part(0.0, 0.6));
  field.count = problem.count;
  field.seconds.assemble = problem.assembleSeconds;
  field.seconds.factor = problem.factorSeconds;
  progress.Report(0.6);

  Stopwatch stopwatch;
  // The report needs the edges of the mesh, which the problem refers to until it is solved.
  field.edges = problem.edges;
  if (options.method == PerforatedMethod::UnitNorm)
  {
    UseUnitNorm(problem, field);
  }
  else
  {
    if (!options.unitHoles)
    {
      UseConstrained(problem, options, progress.Part(0.6, 0.9), field);
    }
    const bool mend =
      options.start == PerforatedStart::Best && (field.wrongDegrees > 0 || !field.converged);
    if (options.unitHoles || mend)
    {
      UseUnitHoles(problem, options.reduced, progress.Part(0.9, 1.0), field);
    }
  }
  field.seconds.solve = stopwatch.Lap();
  progress.Report(1.0);
  return field;
}
}
