#pragma once

#include "OptimizerStage.h"

#include <optional>
#include <set>
#include <string>

namespace crossfield
{
/// A configuration with other singularities, and the sentence that says what it would do.
struct ConfigurationChange
{
  TrackedConfiguration tracked;
  std::string event;
  std::string key; ///< Names the change, to ask for it once only.
  /// Two of opposite sign that meet: W falls to −∞, so nothing has to be compared.
  bool meets = false;
  std::array<int, 2> pair = { -1, -1 }; ///< Rows of the start that met.
};

/// Two interior singularities of opposite sign at the clearance, replaced by one of the sum in the
/// middle, or by none. Not when fewer coordinates than inner loops would be left to fit their holonomy.
std::optional<ConfigurationChange> FindMeeting(
  const OptimizerStage& stage, const OptimizerPlace& here);

/// An interior singularity at the clearance from the boundary, with W falling further on, made part of
/// the quarter index of a boundary vertex nearby: of the corner that it relieves most, else the nearest.
std::optional<ConfigurationChange> FindPressed(
  const OptimizerStage& stage, const OptimizerPlace& here, const std::set<std::string>& refused);

/// A singularity on the boundary whose corner has a lower energy without one quarter of it (docs/method.md
/// §6.1), which moves inside.
std::optional<ConfigurationChange> FindLoose(
  const OptimizerStage& stage, const OptimizerPlace& here, const std::set<std::string>& refused);

/// A singularity that was made part of the boundary at a vertex where it does not turn, moved to the
/// vertex nearby that lowers the energy most.
std::optional<ConfigurationChange> FindSlide(
  const OptimizerStage& stage, const OptimizerPlace& here, const std::set<std::string>& refused);

/// Numbers of the interior singularities that the barrier holds off the boundary.
std::vector<std::size_t> HeldSingularities(const OptimizerStage& stage, const OptimizerPlace& here);
}
