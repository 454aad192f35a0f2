#pragma once

#include "BoundaryCorners.h"
#include "CornerEnergy.h"
#include "Singularity.h"

#include <array>

namespace crossfield
{
/// On which side of 4χ the sum of the corners' quarter indices lies, and with it the sign of the
/// interior singularities that are still needed.
enum class Scenario
{
  Scarce,   ///< Σk < 4χ: interior singularities of positive index.
  Balanced, ///< Σk = 4χ: none.
  Excess    ///< Σk > 4χ: of negative index.
};

/// "scarce", "balanced" or "excess".
const char* ScenarioName(Scenario scenario);

/// The corners' quarter indices by the rule of one scenario, and what they cost.
struct ScenarioCost
{
  int sum = 0;
  double energy = 0.0;   ///< Σ e(α_i, k_i) + c |4χ − Σ k_i|, c from InteriorQuarterEnergy.
  bool feasible = false; ///< The sum is where the rule supposes it to be; then it is optimal.
};

struct ClassifiedCorner : Corner
{
  int quarterIndex = 0; ///< In the cheapest assignment.
  int scarce = 0; ///< 3/8 − 7a/8 ≤ k/4 ≤ 5/8 − 7a/8, a = angle / 2π; of two the smaller one.
  int balanced = 0; ///< In the cheapest assignment of sum 4χ.
  int excess = 0;   ///< 3/8 − 9a/8 ≤ k/4 ≤ 5/8 − 9a/8; of two the larger one.
  /// Nearest of 2, 1, 0, −1, −2 to 0, π/2, π, 3π/2, 2π; the smallest rotation.
  int conventional = 0;
  double energy = 0.0; ///< e(angle, quarterIndex).
  bool overridden = false;
  bool tied = false; ///< Another assignment of the same total energy has another index here.
};

struct ClassificationOptions
{
  double cornerAngle = DefaultCornerAngle;
  InteriorCoefficient coefficient = InteriorCoefficient::Logarithm;
  /// Indices that are given, each for the corner nearest to its position.
  std::vector<CornerChoice> overrides;
  /// Quad meshes have no corners of index 1/2: replace k = 2 by k = 1 and an interior singularity
  /// k = +1 close by. Overridden corners stay as they are.
  bool splitHalves = false;
};

struct CornerClassification
{
  std::vector<ClassifiedCorner> corners;  ///< In the order of the loops.
  std::array<ScenarioCost, 3> scenarios;  ///< By Scenario.
  Scenario scenario = Scenario::Balanced; ///< Of the cheapest assignment, before any splitting.
  double energy = 0.0; ///< Σ e(α_i, k_i) + c × number of interior quarters, after any splitting.
  int interiorQuarters = 0; ///< 4χ − Σ k_i, after any splitting.
  /// The singularities that splitting adds, on the bisector at a quarter of the way across the
  /// domain, without radii; they are part of interiorQuarters.
  Configuration split;
};

/// Chooses the quarter indices of corners so that Σ e(α_i, k_i) + c |4χ − Σ k_i| is least.
///
/// The sum is convex and separable but for one variable, so the indices that are optimal when every
/// quarter at the boundary saves nothing and costs c (the excess rule), raised one by one at the
/// corner where that is cheapest, until the sum is 4χ or a quarter costs more than the interior
/// singularity that it saves, are the exact minimum. Of equally cheap assignments it is one with
/// the fewest interior quarters that raises earlier corners first; the others are found by moving
/// one quarter, or exchanging one between two corners, and marked as ties.
///
/// Throws Error when there are overrides but no corners.
CornerClassification ClassifyCorners(
  const PlanarDomain& domain, const ClassificationOptions& options = {});
}
