#pragma once

#include "Error.h"
#include "QuadRequest.h"

#include <optional>
#include <string>
#include <vector>

namespace crossfield
{
/// A way to make the quads of a request.
struct QuadAttempt
{
  bool hasSingularities = true; ///< Otherwise none are placed, where a domain needs none.
  bool mergesBlocks = true;     ///< As the request says; otherwise blocks are not merged.
  double layerDistance =
    1.0; ///< Factor of the distance that chosen singularities keep from layers.
  bool repairsHolonomy = false; ///< Although the request does not.
  double refinement = 1.0;      ///< Of the triangle mesh (MeshThroughPoints).
};

/// What an attempt led to.
struct QuadAttemptRecord
{
  QuadAttempt attempt;
  std::optional<Error> error; ///< Absent if there are quads.
  bool isGood = false;        ///< The quads need no other attempt.
  std::string result;         ///< Sentence for the report.
};

/// Returns what to try first, or after the attempts that were made; nothing if there is nothing more to
/// try (docs/method.md §14.13).
std::optional<QuadAttempt> NextAttempt(const PlanarDomain& domain, const QuadRequest& request,
  const std::vector<QuadAttemptRecord>& made);

/// Makes the quads of a request of WithSideSizes: makes attempts until one is good or there is nothing
/// more to try, and returns the best of them. Throws Error if none has quads.
QuadWorkflowResult MakeAttempts(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress);
}
