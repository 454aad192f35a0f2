#pragma once

#include "BoundaryCorners.h"
#include "CornerEnergy.h"
#include "Singularity.h"

#include <array>

namespace crossfield
{
/// Comparison of the sum of the corners' quarter indices with 4χ, which determines the sign of the
/// interior singularities that are still needed.
enum class Scenario
{
  Scarce,   ///< Σk < 4χ: interior singularities of positive index.
  Balanced, ///< Σk = 4χ: none.
  Excess    ///< Σk > 4χ: of negative index.
};

/// "scarce", "balanced" or "excess".
const char* ScenarioName(Scenario scenario);

/// Quarter indices of the corners by the rule of one scenario, and their energy.
struct ScenarioCost
{
  int sum = 0;
  double energy = 0.0; ///< Σ e(α_i, k_i) + c |4χ − Σ k_i|, c from InteriorQuarterEnergy.
  /// Whether the sum agrees with the assumption of the rule; the assignment is then optimal.
  bool feasible = false;
};

struct ClassifiedCorner : Corner
{
  int quarterIndex = 0; ///< Index in the cheapest assignment.
  int scarce = 0; ///< Index with 3/8 − 7a/8 ≤ k/4 ≤ 5/8 − 7a/8, a = angle / 2π; the smaller of two.
  int balanced = 0; ///< Index in the cheapest assignment of sum 4χ.
  int excess = 0;   ///< Index with 3/8 − 9a/8 ≤ k/4 ≤ 5/8 − 9a/8; the larger of two.
  /// Index of the smallest rotation: the nearest of 2, 1, 0, −1, −2 for 0, π/2, π, 3π/2, 2π.
  int conventional = 0;
  double energy = 0.0; ///< e(angle, quarterIndex).
  bool overridden = false;
  /// Whether another assignment of the same total energy has a different index here.
  bool tied = false;
};

struct ClassificationOptions
{
  double cornerAngle = DefaultCornerAngle;
  InteriorCoefficient coefficient = InteriorCoefficient::Logarithm;
  /// Given indices, each for the corner nearest to its position.
  std::vector<CornerChoice> overrides;
  /// Replaces k = 2 by k = 1 and an interior singularity k = +1 close by, because quad meshes have
  /// no corners of index 1/2. Overridden corners stay unchanged.
  bool splitHalves = false;
};

struct CornerClassification
{
  std::vector<ClassifiedCorner> corners; ///< Corners in the order of the loops.
  std::array<ScenarioCost, 3> scenarios; ///< Indexed by Scenario.
  /// Scenario of the cheapest assignment, before any splitting.
  Scenario scenario = Scenario::Balanced;
  double energy = 0.0; ///< Σ e(α_i, k_i) + c × number of interior quarters, after any splitting.
  int interiorQuarters = 0; ///< 4χ − Σ k_i, after any splitting.
  /// Singularities added by splitting, on the bisector at a quarter of the distance across the
  /// domain, without radii. They are included in interiorQuarters.
  Configuration split;
};

/// Chooses the quarter indices of corners that minimise Σ e(α_i, k_i) + c |4χ − Σ k_i|.
///
/// The sum is convex and separable except for one variable, so a greedy method finds the exact
/// minimum. It starts from the indices that are optimal when every quarter at the boundary saves
/// nothing and costs c (the excess rule), and raises them one by one at the cheapest corner, until
/// the sum is 4χ or a quarter costs more than the interior singularity that it saves. Of equally
/// cheap assignments the result has the fewest interior quarters, the fewest corners on smooth boundaries, and raises
/// earlier corners first.
/// The others are found by moving one quarter, or by exchanging one between two corners, and are
/// marked as ties.
///
/// Throws Error when there are overrides but no corners.
CornerClassification ClassifyCorners(
  const PlanarDomain& domain, const ClassificationOptions& options = {});
}
