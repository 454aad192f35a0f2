#pragma once

#include "QuadResult.h"

#include <optional>
#include <vector>

namespace crossfield
{
/// What matters most in a mesh.
enum class MeshPreference
{
  Nodes,  ///< Few irregular nodes.
  Blocks, ///< Few structured blocks.
  Uniform ///< Quads of one size.
};

/// The mesh of one of several configurations that were chosen for a domain.
struct Alternative
{
  int rank = 0;  ///< AutomaticConfiguration::rank.
  int nodes = 0; ///< Number of singularities.
  int blocks = 0;
  double scaledJacobian = 0.0; ///< Minimum.
  double sizeVariation = 0.0;
  int symmetries = 1;    ///< Of the mesh.
  double attained = 0.0; ///< The minimum scaled Jacobian in parts of the attainable one.
  double excess = 0.0;   ///< CountExcess.
  /// How far target sizes are met: the shares of the area in parts of 0.95 and of the quads in parts of 0.9,
  /// the smaller of both and at most 1. Absent without target sizes.
  std::optional<double> met;
  bool isValid = true; ///< Without inverted quads, and with nearly the requested number of quads.
};

Alternative AlternativeOf(
  const QuadResult& quads, std::size_t nodes, double quadSize, int quadCount);

/// Returns the order of alternatives, the best first (docs/method.md §14.14). Those are last that are
/// not valid, that meet less of target sizes, whose minimum scaled Jacobian is lower than the largest by more than 0.03, also in parts
/// of the attainable one, or, unless uniform sizes are preferred, whose variation of sizes is larger
/// than the smallest by more than 0.1. Without a preference, the lowest rank comes first, and then the
/// most symmetric mesh; with target sizes the fewest nodes come first. Among equal ones follow the requested number of quads, the fewest blocks and
/// nodes, and the best shapes and most uniform sizes: 0.03 of the one are worth 0.1 of the other.
std::vector<std::size_t> OrderAlternatives(
  const std::vector<Alternative>& alternatives, std::optional<MeshPreference> preference);
}
