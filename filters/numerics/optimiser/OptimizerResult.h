#pragma once

#include "BoundaryCorners.h"
#include "OptimizerIteration.h"
#include "TargetSize.h"

#include <array>
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
  /// Least distance of the singularities inside to the boundary and to each other, a length. 0:
  /// 1/400 of the diagonal, a tenth of the default mesh size; nearer to the boundary no mesh for a
  /// field would resolve them.
  double clearance = 0.0;
  /// Every singularity stays what it is: none moves into the boundary or out of it, none are taken
  /// out.
  bool keepAll = false;
  /// Target sizes of quads (docs/method.md §5.7). Conformal: the run ends at the minimum of W.
  /// Uniform and Field: it goes on, with the same singularities and as many iterations again, to
  /// the minimum of W + 10,000 J (SizeUniformity.h), where the sizes of the field are nearest to
  /// the target sizes.
  TargetSizes sizes;
  /// Maximum number of pairs of quarter indices 1 and −1 that are added after that where they
  /// reduce the spread of sizes most (docs/method.md §5.8), as long as each reduces it by 15 % or
  /// halves a holonomy defect. With pairs, Conformal is treated as Uniform.
  int pairs = 0;
};

/// What evenness costs: a point of the front of numbers of singularities against spreads of sizes.
struct FrontPoint
{
  int singularities = 0; ///< Those on the boundary included.
  double sizeSpread =
    0.0; ///< Standard deviation of log size, or of size over wanted size, over the area.
  double energy = 0.0;         ///< W.
  double holonomyDefect = 0.0; ///< Largest, radians.
};

/// Standard deviations of log size, or of the logarithm of size over wanted size, over the area.
struct SizeSpreads
{
  double before = 0.0; ///< Where W is least,
  double after = 0.0;  ///< and of the result.
};

struct OptimizerResult
{
  /// In the order given, without those that were taken out; then those that left the boundary, and
  /// added pairs.
  Configuration configuration;
  double energyBefore = 0.0;              ///< W of the start,
  double energyAfter = 0.0;               ///< and of the result.
  std::optional<SizeSpreads> sizeSpreads; ///< None where the sizing is Conformal.
  /// Where sizes are Uniform or Field: at the least W, with even sizes, and with each pair that was
  /// added.
  std::vector<FrontPoint> front;
  int iterations = 0;
  bool converged = false;
  bool aborted = false;
  /// One sentence: converged, or why not.
  std::string reason;
  /// What happened besides moving, a sentence each; singularities count from 1 in the order given.
  std::vector<std::string> events;
  /// Rows of the start that met with opposite signs and were taken out, or merged to one of the
  /// sum.
  std::vector<std::array<int, 2>> annihilations;
  std::vector<double> holonomyDefect;
  /// Standard deviation of log size over the area, of the result.
  double sizeSpread = 0.0;
  std::vector<OptimizerStep> history; ///< From the start on.
};
}
