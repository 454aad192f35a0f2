#pragma once

#include "CornerClassification.h"
#include "Progress.h"

#include <string>

namespace crossfield
{
struct OptimizerOptions
{
  double meshSize = 0.0; ///< As in DrillOptions.
  std::vector<CornerChoice> corners;
  int maximumIterations = 200;
  /// The iteration stops when the derivatives of the Lagrangian, times the diagonal of the domain,
  /// and the holonomy defects are below this.
  double tolerance = 1e-6;
};

/// One configuration on the way.
struct OptimizerStep
{
  double energy = 0.0; ///< W.
  double gradientNorm =
    0.0; ///< Of the Lagrangian, times the diagonal of the domain; largest entry.
  double holonomyDefect = 0.0; ///< Largest.
  double stepLength = 0.0;     ///< Longest way that a singularity went to here.
};

struct OptimizerResult
{
  Configuration configuration; ///< In the order given; those on the boundary did not move.
  double energyBefore = 0.0;   ///< W of the start,
  double energyAfter = 0.0;    ///< and of the result.
  int iterations = 0;
  bool converged = false;
  bool aborted = false;
  /// One sentence: converged, or why not.
  std::string reason;
  /// Two singularities of opposite sign that met: remove them, or merge them to one of the sum.
  std::vector<std::array<int, 2>> annihilations;
  std::vector<double> holonomyDefect;
  std::vector<OptimizerStep> history; ///< From the start on.
};

/// Moves the interior singularities downhill on the renormalised energy W (RenormalizedEnergy.h), on
/// one mesh that is factored once (docs/method.md §5.5; paper, "The unifying renormalized Ginzburg-Landau
/// energy"). With inner loops the holonomy defects are equality constraints, the nearest
/// multiple of 2π apart: the result has an aligned field of norm one with single-valued H.
///
/// Sequential quadratic programming with exact gradients of W and of the defects, damped BFGS updates
/// of the Hessian of the Lagrangian, and a line search on W + μ Σ |defect|. No singularity goes
/// farther in one step than half of the way to the boundary or to the next one: there W tends to
/// infinity for like signs. Opposite signs attract; when they are nearer than half the mesh size the
/// iteration stops and proposes to annihilate them. It also stops when a singularity is pressed
/// against the boundary, as it may be at a corner, up to the same distance.
///
/// An abort after the first evaluation keeps the best. Throws Error when the quarter indices violate
/// Poincaré-Hopf or a singularity lies outside.
OptimizerResult OptimizeSingularities(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options = {}, const Progress& progress = {});
}
