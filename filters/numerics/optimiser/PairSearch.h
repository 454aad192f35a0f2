#pragma once

#include "SizeUniformity.h"

namespace crossfield
{
/// A singularity of quarter index 1 and one of −1, and what sizes would be with them where they are.
struct SingularityPair
{
  Point positive = Point::Zero();
  Point negative = Point::Zero();
  double energy = 0.0;        ///< J with the pair, exact on the mesh.
  double largestDefect = 0.0; ///< Holonomy defect with it, radians.
  /// J + ¼ Σ δ² of the defects: 4 of the square of the angle by which crosses miss.
  double score = 0.0;
};

struct PairSearchOptions
{
  /// Least distance of places to the boundary and to singularities, a length.
  double clearance = 0.0;
  /// Among so many places, about equally far from each other.
  std::size_t places = 120;
  /// How many pairs to return, at most.
  std::size_t count = 10;
};

/// The pairs that make sizes most even, the best first (docs/method.md §5.8): H is linear in the sources, so J of
/// all pairs of places follows from the H of each place, one back-substitution, and their products. Pairs of which
/// both ends are about where a better one has them are left out. Nothing where there are no two places.
std::vector<SingularityPair> FindPairs(const PointPotential& potential,
  const SizeUniformity& evenness, const Configuration& interior, const PairSearchOptions& options);
}
