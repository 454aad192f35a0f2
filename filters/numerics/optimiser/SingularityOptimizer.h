#pragma once

#include "OptimizerResult.h"
#include "Progress.h"

#include <memory>

namespace crossfield
{
class OptimizerRun;

/// Moves the interior singularities downhill on the renormalised energy W (RenormalizedEnergy.h;
/// docs/method.md §5.5; paper, "The unifying renormalized Ginzburg-Landau energy"). With inner
/// loops, the holonomy defects, each reduced modulo 2π, are equality constraints: the result has an
/// aligned field of norm one with single-valued H, unless no singularity can change a defect.
///
/// One mesh is factored, and another one whenever a singularity comes closer to the boundary than
/// the length of the edges there. A barrier keeps singularities at the clearance; one that is
/// stopped there does not stop the others. Unless OptimizerOptions::keepAll is set:
/// - A singularity that is pushed against the boundary becomes a singularity of the boundary, at a
///   corner or vertex next to it, and one on the boundary moves inside, if that lowers the energy
///   E_ρ at ρ = 1/400 of the diagonal.
/// - Two singularities of opposite sign that meet are removed, or replaced by one with the sum of
///   their quarter indices.
/// Singularities that start closer to the boundary than the clearance are first moved away from it.
///
/// Given radii that no longer fit are reduced. An abort after the first evaluation returns the best
/// configuration found so far. Throws Error if the quarter indices violate Poincaré-Hopf, a
/// singularity lies outside, or the clearance is negative.
OptimizerResult OptimizeSingularities(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options = {}, const Progress& progress = {});

/// OptimizeSingularities in two steps, so that the energies of several starts can be compared before
/// any of them moves. Starts can be prepared and run in parts, each in one part at a time.
class PreparedOptimization
{
public:
  /// Meshes the domain for the start and evaluates it. Stores a reference to the domain.
  PreparedOptimization(const PlanarDomain& domain, const Configuration& start,
    const OptimizerOptions& options, const Progress& progress = {});
  PreparedOptimization(const PreparedOptimization&) = delete;
  PreparedOptimization& operator=(const PreparedOptimization&) = delete;
  ~PreparedOptimization();

  /// Returns the objective of the start (OptimizerResult::objective).
  double StartObjective() const;
  /// Optimises, once, with this bound instead of OptimizerOptions::maximumStart.
  OptimizerResult Run(double maximumStart, const Progress& progress = {});

private:
  OptimizerOptions Options;
  OptimizerResult Result;
  std::unique_ptr<OptimizerRun> Optimizer;
};
}
