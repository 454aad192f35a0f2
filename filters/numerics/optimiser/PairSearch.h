#pragma once

#include "SizeUniformity.h"

namespace crossfield
{
/// Singularity of quarter index 1 and one of −1, with the predicted uniformity of sizes with the
/// pair at these positions.
struct SingularityPair
{
  Point positive = Point::Zero();
  Point negative = Point::Zero();
  double energy = 0.0;        ///< J with the pair, exact on the mesh.
  double largestDefect = 0.0; ///< Maximum holonomy defect with the pair, radians.
  /// J + ¼ Σ δ² with the defects δ; ¼ δ² is four times the square of the angle by which crosses do
  /// not match.
  double score = 0.0;
};

struct PairSearchOptions
{
  /// Minimum distance of positions from the boundary and from singularities, a length.
  double clearance = 0.0;
  /// Number of candidate positions, about equally spaced.
  std::size_t positions = 120;
  /// Maximum number of pairs to return.
  std::size_t count = 10;
};

/// Returns the pairs that make sizes most uniform, the best first (docs/method.md §5.8). H is
/// linear in the sources: J for all pairs of positions follows from the H of each position, one
/// back-substitution each, and their products. A pair is left out if both of its ends are close to
/// those of a better one. Returns nothing if there are fewer than two positions.
std::vector<SingularityPair> FindPairs(const PointPotential& potential,
  const SizeUniformity& uniformity, const Configuration& interior,
  const PairSearchOptions& options);
}
