#pragma once

#include "BoundaryCorners.h"
#include "OptimizerIteration.h"

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
}
