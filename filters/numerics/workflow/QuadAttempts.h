#pragma once

#include "Error.h"
#include "ResolvedRequest.h"

#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
/// How singularities move without request.
enum class SingularityMotion
{
  None,
  RepairedHolonomy, ///< So that grid lines close up around inner loops (HolonomyRepair.h).
  MinimumEnergy     ///< Given ones only: towards a minimum of the renormalised energy.
};

/// A way to make the quads of a request.
struct QuadAttempt
{
  /// Whether singularities are given or chosen; otherwise there are none, where a domain needs
  /// none.
  bool hasSingularities = true;
  bool mergesBlocks = true; ///< Whether blocks are merged if that is requested.
  /// Factor of the distance that chosen singularities keep from layers.
  double layerDistance = 1.0;
  /// Whether layers replace fewer rows than their growth needs, if irregular nodes leave no more.
  bool takesFewRows = false;
  SingularityMotion motion = SingularityMotion::None;
  double refinement = 1.0; ///< Refinement of the triangle mesh (MeshThroughPoints).
};

/// An attempt that was made.
struct QuadAttemptRecord
{
  QuadAttempt attempt;
  std::optional<Error> error; ///< Absent if there are quads.
  bool isInverted = false;    ///< Whether there are quads, and some are inverted.
  /// Whether no other attempt is needed: no quad is inverted, and shapes reach AcceptableShape.
  bool isAcceptable = false;
  std::string quads; ///< A sentence about the quads, for the report.
};

/// Returns what to try first, or after the attempts that were made; nothing if there is nothing
/// more to try (docs/method.md §14.13).
std::optional<QuadAttempt> NextAttempt(const PlanarDomain& domain, const ResolvedRequest& request,
  const std::vector<QuadAttemptRecord>& made);

/// Makes the quads of a request of WithSizeTargets: makes attempts until there is nothing more to
/// try, and returns the best of them (MeshGrade.h). Throws Error if none has quads.
QuadWorkflowResult MakeAttempts(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress);

/// Makes the quads of a request of WithSizeTargets by the first attempt alone. Throws Error if it has
/// none.
QuadWorkflowResult MakeFirstAttempt(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress);
}
