#pragma once

#include "BoundaryCorners.h"
#include "OptimizerIteration.h"
#include "TargetSize.h"

#include <array>
#include <limits>
#include <optional>
#include <string>

namespace crossfield
{
struct OptimizerOptions
{
  double meshSize = 0.0; ///< As in DrillOptions.
  std::vector<CornerChoice> corners;
  int maximumIterations = 200;
  /// Maximum number of solves (SolveBudget.h), 0 for any number. When they are used up, the run
  /// ends with the best configuration so far.
  std::size_t maximumSolves = 0;
  /// No step is made if the objective of the start (OptimizerResult::objective) is higher.
  double maximumStart = std::numeric_limits<double>::infinity();
  /// Bound on the derivatives of the Lagrangian, multiplied by the diagonal of the domain, and on
  /// the holonomy defects. The iteration has converged when all are below it.
  double tolerance = 1e-6;
  /// Minimum distance of interior singularities from the boundary and from each other, a length. 0
  /// stands for 1/400 of the diagonal, a tenth of the default mesh size: no mesh for a field would
  /// resolve singularities closer to the boundary.
  double clearance = 0.0;
  ClearanceFactors clearanceFactors; ///< Of the clearance at edges of the boundary.
  /// Side length of the quads that will be made, 0 if it is not known. The boundary takes a
  /// singularity only where quads of this size have sufficient angles (docs/method.md §5.5). 0
  /// stands for 1/40 of the diagonal, the default mesh size.
  double quadSize = 0.0;
  /// Keeps the number and kind of singularities: none moves into the boundary or out of it, and
  /// none is removed.
  bool keepAll = false;
  /// Target sizes of quads (docs/method.md §5.7). With Conformal, the run ends at the minimum of W.
  /// With Uniform and Field it continues, with the same singularities and up to as many further
  /// iterations, to the minimum of W + 10,000 J (SizeUniformity.h), where the sizes of the field
  /// are closest to the target sizes.
  TargetSizes sizes;
  /// Maximum number of pairs of quarter indices 1 and −1 that are added afterwards where they
  /// reduce the spread of sizes most (docs/method.md §5.8). Pairs are added as long as each reduces
  /// the spread by 15 % or halves a holonomy defect. With pairs, Conformal is treated as Uniform.
  int pairs = 0;
};

/// Point of the Pareto front of the number of singularities and the spread of sizes.
struct FrontPoint
{
  int singularities = 0; ///< Including those on the boundary.
  /// Standard deviation of log size, or of the logarithm of size over target size, over the area.
  double sizeSpread = 0.0;
  double energy = 0.0;         ///< W.
  double holonomyDefect = 0.0; ///< Largest, radians.
};

/// Standard deviations of log size, or of the logarithm of size over target size, over the area.
struct SizeSpreads
{
  double before = 0.0; ///< At the minimum of W.
  double after = 0.0;  ///< At the result.
};

struct OptimizerResult
{
  /// Singularities in the order given, without those that were removed, followed by those that left
  /// the boundary and by added pairs.
  Configuration configuration;
  double energyBefore = 0.0; ///< W at the start.
  double energyAfter = 0.0;  ///< W at the result.
  double coreEnergy = 0.0;   ///< OptimizerStage::CoreEnergy of the result.
  /// What configurations are compared by (docs/method.md §5.6): the core energy less
  /// WorthOfSymmetries of the symmetries of the domain that map the singularities to places within
  /// a quarter of a quad.
  double objective = 0.0;
  std::optional<SizeSpreads> sizeSpreads; ///< Empty if the sizing is Conformal.
  /// Points of the Pareto front if sizes are Uniform or Field: at the minimum of W, with uniform
  /// sizes, and after each added pair.
  std::vector<FrontPoint> front;
  int iterations = 0;
  std::size_t solves = 0; ///< Number of solves (SolveBudget.h).
  bool converged = false;
  bool aborted = false;
  /// Why the run ended, one sentence.
  std::string reason;
  /// Events other than moves, one sentence each; singularities are counted from 1 in the order
  /// given.
  std::vector<std::string> events;
  /// Pairs of rows of the start that met with opposite signs and were removed or merged.
  std::vector<std::array<int, 2>> annihilations;
  std::vector<double> holonomyDefect;
  /// Standard deviation of log size over the area, at the result.
  double sizeSpread = 0.0;
  std::vector<OptimizerStep> history; ///< Steps from the start on.
};
}
