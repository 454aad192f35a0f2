#pragma once

#include "OptimizerStage.h"

#include <optional>
#include <set>
#include <string>

namespace crossfield
{
/// Configuration with other singularities, and the sentence that describes the change.
struct ConfigurationChange
{
  TrackedConfiguration tracked;
  std::string event;
  std::string key; ///< Identifies the change, so that a rejected one is not proposed again.
  /// Whether two singularities of opposite sign meet: W tends to −∞ there, so that energies need
  /// not be compared.
  bool annihilates = false;
  std::array<int, 2> pair = { -1, -1 }; ///< Rows of the start that met.
};

/// Finds two interior singularities of opposite sign at the clearance, and replaces them by one
/// with the sum of their quarter indices in the middle, or removes them if the sum is zero. Nothing
/// is proposed if fewer coordinates than inner loops would be left to satisfy the holonomy
/// conditions.
std::optional<ConfigurationChange> FindAnnihilation(
  const OptimizerStage& stage, const OptimizerState& current);

/// Finds an interior singularity at the clearance from the boundary with W decreasing further
/// towards it, and adds it to the quarter index of a boundary vertex nearby: of the corner whose
/// energy this lowers most, otherwise of the nearby vertex with the lowest energy.
std::optional<ConfigurationChange> FindAbsorption(const OptimizerStage& stage,
  const OptimizerState& current, const std::set<std::string>& rejected);

/// Finds a singularity on the boundary whose corner has a lower energy without one quarter
/// (docs/method.md §6.1), and moves this quarter inside.
std::optional<ConfigurationChange> FindRelease(const OptimizerStage& stage,
  const OptimizerState& current, const std::set<std::string>& rejected);

/// Finds a singularity that has become part of the boundary at a vertex where the boundary does not
/// turn by a quarter, and moves it to the nearby vertex with the lowest energy.
std::optional<ConfigurationChange> FindBoundaryMove(const OptimizerStage& stage,
  const OptimizerState& current, const std::set<std::string>& rejected);

/// Returns the numbers of the interior singularities that the barrier keeps from the boundary.
std::vector<std::size_t> StoppedSingularities(
  const OptimizerStage& stage, const OptimizerState& current);
}
