#include "VariantSolve.h"

#include "DirectReduction.h"
#include "DualSolve.h"
#include "Error.h"
#include "LocalSolve.h"
#include "PenaltySolve.h"
#include "Stopwatch.h"
#include "UnitNormField.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns all loops with a constraint: holes, then imprinted circles.
std::vector<BoundaryLoop> ConstrainedLoops(const PlanarTopology& topology)
{
  std::vector<BoundaryLoop> loops;
  std::copy_if(topology.loops.begin(), topology.loops.end(), std::back_inserter(loops),
    [](const BoundaryLoop& loop) { return loop.kind == BoundaryKind::Hole; });
  loops.insert(loops.end(), topology.imprinted.begin(), topology.imprinted.end());
  return loops;
}

/// Returns whether each loop has unit norm. Throws Error for a row that is not in the list.
std::vector<bool> FindUnitLoops(
  const std::vector<BoundaryLoop>& loops, const PerforatedOptions& options)
{
  std::vector<bool> unit(loops.size(), options.unitHoles);
  for (const int row : options.unitHoleRows)
  {
    const auto found = std::find_if(
      loops.begin(), loops.end(), [row](const BoundaryLoop& loop) { return loop.id == row; });
    if (found == loops.end())
    {
      throw Error("Unit norm was requested on hole " + std::to_string(row) +
        ", which the mesh does not have; give rows of the configuration, counted from 0.");
    }
    unit[found - loops.begin()] = true;
  }
  return unit;
}

void CheckCombination(const TriangleMesh& mesh, const PerforatedOptions& options)
{
  if (options.method == PerforatedMethod::UnitNorm)
  {
    throw Error(mesh.imprinted.empty()
        ? "The global constraint, unit norms and the penalty belong to the constrained method; "
          "choose it, or leave them out."
        : "The unit-norm method needs holes, but the mesh has imprinted circles, inside which a "
          "field of norm one cannot exist; perforate it, or choose the constrained method.");
  }
  if (options.epsilon < 0.0 || !std::isfinite(options.epsilon))
  {
    throw Error("The length epsilon of the penalty must be positive, or 0 for no penalty.");
  }
  if (options.epsilon > 0.0 && (options.unitHoles || !options.unitHoleRows.empty()))
  {
    throw Error("Unit norms on holes and the penalty cannot be combined, and the penalty alone "
                "keeps the norm near one; leave one of them out.");
  }
}

/// Reduced problem in which some loops are replaced by one unknown each, the factor e^{iφ}.
class VariantProblem
{
public:
  VariantProblem(const ReducedProblem& reduced, const std::vector<bool>& unit, bool global)
    : Reduced(reduced)
    , Unit(unit)
  {
    std::vector<Eigen::Triplet<Complex>> entries;
    std::vector<DegreeConstraint> degrees;
    int unknowns = 0;
    for (std::size_t i = 0; i < reduced.constraints.size(); ++i)
    {
      const DegreeConstraint& constraint = reduced.constraints[i];
      DegreeConstraint moved = constraint;
      for (std::size_t j = 0; j < constraint.unknowns.size(); ++j)
      {
        entries.emplace_back(
          constraint.unknowns[j], unknowns, unit[i] ? constraint.turning[j] : 1.0);
        moved.unknowns[j] = unknowns;
        unknowns += unit[i] ? 0 : 1;
      }
      if (unit[i])
      {
        this->Problem.constraints.push_back(UnitNorm(unknowns++));
      }
      else if (global)
      {
        degrees.push_back(moved);
      }
      else
      {
        this->Problem.constraints.push_back(SumOfDegrees({ moved }));
      }
    }
    if (!degrees.empty())
    {
      this->Problem.constraints.push_back(SumOfDegrees(degrees));
    }
    this->Expansion.resize(reduced.matrix.Rows(), unknowns);
    this->Expansion.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixXcd product = reduced.matrix.Dense().cast<Complex>() * this->Expansion;
    this->Problem.matrix = this->Expansion.adjoint() * product;
    this->Problem.load = this->Expansion.adjoint() * reduced.load;
  }

  /// Solves from values on the edges; a loop with unit norm starts at the phase nearest to its
  /// values.
  MinimiserResult Solve(
    const ComplexVector& start, const MinimiserOptions& options, const Progress& progress) const
  {
    ComplexVector x = start;
    for (std::size_t i = 0; i < this->Unit.size(); ++i)
    {
      if (this->Unit[i])
      {
        TurnEvenly(this->Reduced.constraints[i], x);
      }
    }
    // The columns of loops with unit norm have m entries of size one.
    ComplexVector y = this->Expansion.adjoint() * x;
    for (Eigen::Index k = 0; k < y.size(); ++k)
    {
      y[k] /= static_cast<double>(this->Expansion.col(k).nonZeros());
    }
    MinimiserResult result = SolveQuadratic(this->Problem, y, options, progress);
    result.x = this->Expansion * result.x;
    return result;
  }

  /// Replaces the values on a loop by the nearest evenly turning unit values.
  static void TurnEvenly(const DegreeConstraint& constraint, ComplexVector& x)
  {
    Complex sum = 0.0;
    for (std::size_t j = 0; j < constraint.unknowns.size(); ++j)
    {
      sum += std::conj(constraint.turning[j]) * x[constraint.unknowns[j]];
    }
    for (std::size_t j = 0; j < constraint.unknowns.size(); ++j)
    {
      x[constraint.unknowns[j]] = std::polar(1.0, std::arg(sum)) * constraint.turning[j];
    }
  }

private:
  const ReducedProblem& Reduced;
  std::vector<bool> Unit;
  Eigen::SparseMatrix<Complex> Expansion; ///< Maps unknowns to values on edges.
  QuadraticProblem Problem;
};

/// Solver of one variant on one mesh; `blank` holds the common initial contents of all solutions.
class VariantSolver
{
public:
  VariantSolver(const PerforatedOptions& options, const SolvedField& blank)
    : Options(options)
    , Blank(blank)
    , Topology(*blank.topology)
    , Loops(ConstrainedLoops(this->Topology))
    , Unit(FindUnitLoops(this->Loops, options))
    , Dual(!options.globalConstraint &&
        std::none_of(this->Unit.begin(), this->Unit.end(), [](bool unit) { return unit; }))
    , Reduction(this->Topology, this->Loops)
    , Problem(this->Reduction.GetReducedProblem(), this->Unit, options.globalConstraint)
  {
    if (this->Topology.imprinted.empty() && blank.count.Consistent() &&
      options.start != PerforatedStart::Harmonic)
    {
      this->UnitNormCrosses =
        SolveUnitNorm({ std::make_shared<const PotentialSolver>(blank.topology),
                        AlignWithBoundary(this->Topology, options.corners) })
          .u;
    }
  }

  SolvedField Run(const Progress& progress) const
  {
    switch (this->Options.start)
    {
    case PerforatedStart::Harmonic:
      return this->FromHarmonic(progress);
    case PerforatedStart::UnitNorm:
      return this->FromUnitCrosses(progress);
    case PerforatedStart::Best:
      break;
    }
    // The penalty prefers unit crosses, so with a penalty the unit-norm field is the start if there
    // is one. The dual method requires the harmonic field.
    const bool harmonicFirst =
      this->Dual && !(this->Options.epsilon > 0.0 && this->UnitNormCrosses.size() > 0);
    const auto from = [&](bool harmonic, const Progress& part)
    { return harmonic ? this->FromHarmonic(part) : this->FromUnitCrosses(part); };
    return BestOfTwo([&] { return from(harmonicFirst, progress.Part(0.0, 0.5)); },
      [&] { return from(!harmonicFirst, progress.Part(0.5, 1.0)); });
  }

private:
  SolvedField FromHarmonic(const Progress& progress) const
  {
    const Progress part = progress.Part(0.0, 0.3);
    const MinimiserOptions& options = this->Options.reduced;
    return this->Finish(this->Dual
        ? SolveReduced(HoleBases(this->Reduction.GetReducedProblem()), options, part)
        : this->Problem.Solve(this->Reduction.HarmonicValues(), options, part),
      progress.Part(0.3, 1.0));
  }

  /// Solves from the unit-norm field or, where there is none, from unit crosses on the holes.
  SolvedField FromUnitCrosses(const Progress& progress) const
  {
    SolvedField field = this->Blank;
    if (this->UnitNormCrosses.size() > 0 && this->Options.epsilon > 0.0)
    {
      field.u = this->UnitNormCrosses;
      this->AddPenalty(progress, field);
      field.Read();
    }
    else
    {
      ComplexVector start = this->Reduction.HarmonicValues();
      if (this->UnitNormCrosses.size() > 0)
      {
        start = this->Reduction.ValuesOf(this->UnitNormCrosses);
      }
      for (const DegreeConstraint& constraint : this->Reduction.GetReducedProblem().constraints)
      {
        VariantProblem::TurnEvenly(constraint, start);
      }
      field =
        this->Finish(this->Problem.Solve(start, this->Options.reduced, progress.Part(0.0, 0.3)),
          progress.Part(0.3, 1.0));
    }
    field.startedFromUnitNorm = true;
    return field;
  }

  /// Builds the field and its report from a solution on the holes, and applies the penalty if there
  /// is one.
  SolvedField Finish(const MinimiserResult& onHoles, const Progress& progress) const
  {
    SolvedField field = this->Blank;
    RecoveredField recovered = this->Reduction.Recover(onHoles.x);
    field.u = std::move(recovered.u);
    field.energy = recovered.energy;
    field.iterations = onHoles.iterations;
    field.residual = onHoles.residual;
    field.converged = onHoles.converged;
    if (this->Options.epsilon > 0.0)
    {
      this->AddPenalty(progress, field);
    }
    field.Read();
    return field;
  }

  void AddPenalty(const Progress& progress, SolvedField& field) const
  {
    const GinzburgLandauEnergy energy(this->Topology, this->Options.epsilon);
    std::vector<DegreeConstraint> degrees = this->Reduction.GetReducedProblem().constraints;
    std::vector<QuadraticConstraint> constraints;
    for (DegreeConstraint& constraint : degrees)
    {
      for (int& unknown : constraint.unknowns)
      {
        unknown = this->Reduction.FreePositions()[unknown];
      }
      if (!this->Options.globalConstraint)
      {
        constraints.push_back(SumOfDegrees({ constraint }));
      }
    }
    if (this->Options.globalConstraint && !degrees.empty())
    {
      constraints.push_back(SumOfDegrees(degrees));
    }
    MinimiserResult result =
      SolveWithPenalty(energy, constraints, field.u, this->Options.reduced, progress);
    field.u = std::move(result.x);
    field.iterations += result.iterations;
    field.residual = result.residual;
    field.converged = result.converged;
    field.epsilon = this->Options.epsilon;
    field.gradientEnergy = energy.GradientPart(field.u);
    field.penaltyEnergy = energy.PenaltyPart(field.u);
    field.energy = field.gradientEnergy + field.penaltyEnergy;
  }

  const PerforatedOptions& Options;
  const SolvedField& Blank;
  const PlanarTopology& Topology;
  std::vector<BoundaryLoop> Loops;
  std::vector<bool> Unit;
  bool Dual; ///< Whether there is one degree constraint per hole and nothing else.
  DirectReduction Reduction;
  VariantProblem Problem;
  ComplexVector UnitNormCrosses; ///< Empty if there is no unit-norm field, or it is not needed.
};
}

bool IsVariant(const PlanarTopology& topology, const PerforatedOptions& options)
{
  return !topology.imprinted.empty() || options.globalConstraint || !options.unitHoleRows.empty() ||
    options.epsilon != 0.0;
}

SolvedField SolveVariant(
  const SharedPlanarTopology& topology, const PerforatedOptions& options, const Progress& progress)
{
  Stopwatch stopwatch;
  CheckCombination(topology->mesh, options);
  SolvedField blank;
  blank.topology = topology;
  blank.count = CountMeshQuarters(*topology, options.corners);
  if (topology->imprinted.empty() && options.epsilon == 0.0)
  {
    RequireConsistent(blank.count);
  }
  blank.unitHoles = options.unitHoles || !options.unitHoleRows.empty();
  blank.globalConstraint = options.globalConstraint;
  const double assemble = stopwatch.Lap();
  progress.Report(0.1);

  const VariantSolver solver(options, blank);
  const double factor = stopwatch.Lap();
  progress.Report(0.3);
  SolvedField field = solver.Run(progress.Part(0.3, 1.0));
  field.seconds.assemble = assemble;
  field.seconds.factor = factor;
  field.seconds.solve = stopwatch.Lap();
  progress.Report(1.0);
  return field;
}
}
