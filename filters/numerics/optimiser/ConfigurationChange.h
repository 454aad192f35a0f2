#pragma once

#include "OptimizerStage.h"

#include <optional>
#include <set>
#include <string>

namespace crossfield
{
/// Configuration with other singularities, and the sentences that describe the change.
struct ConfigurationChange
{
  TrackedConfiguration tracked;
  std::vector<std::string> events;
  bool several = false; ///< Whether it absorbs more than one singularity.
  std::string key;      ///< Identifies the change, so that a rejected one is not proposed again.
  /// Whether two singularities of opposite sign meet: W tends to −∞ there, so that energies need
  /// not be compared.
  bool annihilates = false;
  std::array<int, 2> pair = { -1, -1 }; ///< Rows of the start that met.
};

/// Finds two interior singularities of opposite sign at the clearance, and replaces them by one
/// with the sum of their quarter indices in the middle, or removes them if the sum is zero. Nothing
/// is proposed if fewer coordinates than inner loops would be left to satisfy the holonomy
/// conditions, unless the others satisfy them without the pair.
std::optional<ConfigurationChange> FindAnnihilation(
  const OptimizerStage& stage, const OptimizerState& current);

/// Finds a singularity on the boundary whose corner has a lower energy without one quarter
/// (docs/method.md §6.1), and moves this quarter inside.
std::optional<ConfigurationChange> FindRelease(
  const OptimizerStage& stage, const OptimizerState& current, std::set<std::string>& rejected);

/// Finds singularities that have become part of the boundary at vertices where the boundary does not
/// turn by a quarter, and moves each to the vertex with the lowest energy on the way down along the
/// boundary.
std::optional<ConfigurationChange> FindBoundaryMoves(
  const OptimizerStage& stage, const OptimizerState& current, std::set<std::string>& rejected);

/// Returns how many interior singularities the barrier holds against W, away from the boundary or
/// from each other.
std::size_t HeldSingularities(const OptimizerState& state);

/// Returns the numbers of the interior singularities that the barrier keeps from the boundary.
std::vector<std::size_t> StoppedSingularities(
  const OptimizerStage& stage, const OptimizerState& current);
}
