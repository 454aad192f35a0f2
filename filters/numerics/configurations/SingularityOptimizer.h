#pragma once

#include "CornerClassification.h"
#include "OptimizerIteration.h"
#include "Progress.h"

#include <optional>
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
  /// Least distance of the singularities inside to the boundary and to each other, a length.
  /// 0: 1/400 of the diagonal, a tenth of the default mesh size; nearer to the boundary no mesh for a
  /// field would resolve them.
  double clearance = 0.0;
  /// Every singularity stays what it is: none moves into the boundary or out of it, none are taken out.
  bool keepAll = false;
  /// After the least W, move on to where the sizes of quads are most even: the least W + 1000 J
  /// (SizeEvenness.h), with the singularities that there are and as many iterations again.
  bool evenSizes = false;
};

/// Standard deviations of log size over the area.
struct SizeSpreads
{
  double before = 0.0; ///< Where W is least,
  double after = 0.0;  ///< and of the result.
};

struct OptimizerResult
{
  /// In the order given, without those that were taken out; then those that left the boundary.
  Configuration configuration;
  double energyBefore = 0.0;              ///< W of the start,
  double energyAfter = 0.0;               ///< and of the result.
  std::optional<SizeSpreads> sizeSpreads; ///< Nothing if evenSizes is off.
  int iterations = 0;
  bool converged = false;
  bool aborted = false;
  /// One sentence: converged, or why not.
  std::string reason;
  /// What happened besides moving, a sentence each; singularities count from 1 in the order given.
  std::vector<std::string> events;
  /// Rows of the start that met with opposite signs and were taken out, or merged to one of the sum.
  std::vector<std::array<int, 2>> annihilations;
  std::vector<double> holonomyDefect;
  std::vector<OptimizerStep> history; ///< From the start on.
};

/// Moves the interior singularities downhill on the renormalised energy W (RenormalizedEnergy.h;
/// docs/method.md §5.5; paper, "The unifying renormalized Ginzburg-Landau energy"). With inner loops the
/// holonomy defects are equality constraints, the nearest multiple of 2π apart: the result has an
/// aligned field of norm one with single-valued H, unless no singularity can change a defect.
///
/// One mesh is factored, and another one when a singularity comes nearer to the boundary than its
/// edges are long. A barrier keeps singularities at the clearance; one that is held there does not stop
/// the others. Unless all are to be kept:
/// - one that is pressed against the boundary becomes one of the boundary, at a corner or vertex next to
///   it, and one on the boundary moves inside, where that lowers the energy E_ρ at ρ = 1/400 of the diagonal;
/// - two of opposite sign that meet are taken out, or become one of their sum.
/// A start nearer to the boundary than the clearance is moved off it.
///
/// Given radii that do not fit any more are shrunk. An abort after the first evaluation keeps the best.
/// Throws Error when the quarter indices violate Poincaré-Hopf, a singularity lies outside, or the
/// clearance is negative.
OptimizerResult OptimizeSingularities(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options = {}, const Progress& progress = {});
}
