#include "PerforatedSolve.h"

#include "DualSolve.h"
#include "LocalSolve.h"
#include "PotentialReduction.h"
#include "Stopwatch.h"
#include "UnitNormField.h"
#include "UnitSolve.h"
#include "VariantSolve.h"

#include <utility>

namespace crossfield
{
namespace
{
/// Misalignment above this is not rounding: the potential did not fit its boundary.
constexpr double AlignmentTolerance = 1e-6;

/// Methods on one drilled mesh; `blank` holds the common initial contents of all resulting fields.
class PerforatedSolver
{
public:
  PerforatedSolver(
    const PotentialProblem& problem, const PerforatedOptions& options, const Progress& progress)
    : Problem(problem)
    , Options(options)
    , Report(progress)
  {
    this->Blank.topology = problem.potential->ShareTopology();
    this->Blank.count = problem.alignment.count;
  }

  SolvedField UnitNorm() const
  {
    UnitNormField result = SolveUnitNorm(this->Problem);
    SolvedField field = this->Blank;
    field.u = std::move(result.u);
    field.energy = result.energy;
    field.residual = result.residual;
    field.converged = result.residual <= AlignmentTolerance;
    field.holonomyDefect = std::move(result.holonomyDefect);
    field.Read();
    return field;
  }

  SolvedField Constrained() const
  {
    if (this->Options.unitHoles)
    {
      return this->WithUnitHoles();
    }
    const PotentialReduction reduction(this->Problem);
    this->Report.Report(0.2);
    Stopwatch stopwatch;
    const HoleBases bases(reduction.GetReducedProblem());
    double newton = stopwatch.Lap();
    const auto harmonic = [&] { return this->FromHarmonic(reduction, bases, newton); };
    const auto unitNorm = [&] { return this->FromUnitNorm(reduction, bases); };
    SolvedField field;
    switch (this->Options.start)
    {
    case PerforatedStart::Harmonic:
      field = harmonic();
      break;
    case PerforatedStart::UnitNorm:
      field = unitNorm();
      break;
    case PerforatedStart::Best:
      field = BestOfTwo(harmonic, unitNorm);
      if (field.wrongDegrees > 0 || !field.converged)
      {
        field = this->WithUnitHoles();
      }
      break;
    }
    field.seconds.newton = newton;
    return field;
  }

private:
  SolvedField FromHarmonic(
    const PotentialReduction& reduction, const HoleBases& bases, double& newton) const
  {
    Stopwatch stopwatch;
    const MinimiserResult solution =
      SolveReduced(bases, this->Options.reduced, this->Report.Part(0.2, 0.5));
    newton += stopwatch.Lap();
    return this->Finish(reduction, solution);
  }

  SolvedField FromUnitNorm(const PotentialReduction& reduction, const HoleBases& bases) const
  {
    const ComplexVector start = reduction.ValuesOf(SolveUnitNorm(this->Problem).u);
    SolvedField field = this->Finish(reduction,
      SolveReducedFrom(bases, start, this->Options.reduced, this->Report.Part(0.5, 0.8)));
    field.startedFromUnitNorm = true;
    return field;
  }

  /// Solves with |u| = 1 on the holes, starting from the unit-norm field.
  SolvedField WithUnitHoles() const
  {
    const PotentialReduction reduction(this->Problem, PotentialSolver::Periods::IslandsAndHoles);
    const ComplexVector start = reduction.ValuesOf(SolveUnitNorm(this->Problem).u);
    SolvedField field = this->Finish(reduction,
      SolveReducedUnit(
        reduction.GetReducedProblem(), start, this->Options.reduced, this->Report.Part(0.8, 1.0)));
    field.startedFromUnitNorm = true;
    field.unitHoles = true;
    return field;
  }

  /// Builds the field and its report from a solution on the holes.
  SolvedField Finish(const PotentialReduction& reduction, const MinimiserResult& solution) const
  {
    RecoveredField result = reduction.Recover(solution.x);
    SolvedField field = this->Blank;
    field.u = std::move(result.u);
    field.energy = result.energy;
    field.iterations = solution.iterations;
    field.residual = solution.residual;
    field.converged = solution.converged && result.alignmentResidual <= AlignmentTolerance;
    field.multipliers.assign(solution.multipliers.begin(), solution.multipliers.end());
    field.Read();
    return field;
  }

  const PotentialProblem& Problem;
  const PerforatedOptions& Options;
  const Progress& Report;
  SolvedField Blank;
};
}

SolvedField SolvePerforated(const std::shared_ptr<const PotentialSolver>& potential,
  const PerforatedOptions& options, const Progress& progress)
{
  if (IsVariant(potential->GetTopology(), options))
  {
    return SolveVariant(potential->ShareTopology(), options, progress);
  }
  Stopwatch stopwatch;
  const PotentialProblem problem(
    potential, AlignWithBoundary(potential->GetTopology(), options.corners));
  const PerforatedSolver solver(problem, options, progress);
  SolvedField field =
    options.method == PerforatedMethod::UnitNorm ? solver.UnitNorm() : solver.Constrained();
  field.seconds.solve = stopwatch.Lap();
  progress.Report(1.0);
  return field;
}

SolvedField SolvePerforated(
  const SharedPlanarTopology& topology, const PerforatedOptions& options, const Progress& progress)
{
  if (IsVariant(*topology, options))
  {
    return SolveVariant(topology, options, progress);
  }
  Stopwatch stopwatch;
  RequireConsistent(AlignWithBoundary(*topology, options.corners).count);
  const double assemble = stopwatch.Lap();
  const auto potential = std::make_shared<const PotentialSolver>(topology, progress.Part(0.0, 0.6));
  const double factor = stopwatch.Lap();
  SolvedField field = SolvePerforated(potential, options, progress.Part(0.6, 1.0));
  field.seconds.assemble = assemble;
  field.seconds.factor = factor;
  return field;
}
}
