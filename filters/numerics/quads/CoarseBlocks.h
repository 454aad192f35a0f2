#pragma once

#include "Progress.h"
#include "QuadResult.h"
#include "Quantisation.h"
#include "QuantisationProblem.h"

#include <functional>
#include <optional>

namespace crossfield
{
/// Steps of meshing that the search for the fewest blocks repeats.
struct BlockSteps
{
  using CountsOf = std::function<EdgeCounts(double size, SearchEffort effort)>;

  /// Returns the problem for a size, with prescribed sums.
  std::function<QuantisationProblem(double size)> problemFor;
  /// Returns the counts for the requested size or number of quads.
  std::function<EdgeCounts(const CountsOf& countsOf)> search;
  /// Returns quads with the counts of a result; nothing if they are not valid.
  std::function<std::optional<QuadMesh>(const QuadResult& result)> draft;
  /// Builds, smooths and measures the quads of a result with counts.
  std::function<void(QuadResult& result, const Progress& progress)> make;
};

/// Replaces quads by those with the fewest blocks that are acceptable (CoarseTolerance), if there are any: blocks of
/// solutions for sizes from that of the result up to that of the domain, whose chords are refined (docs/method.md §14.9).
void UseFewestBlocks(
  const BlockSteps& steps, double area, QuadResult& result, const Progress& progress = {});
}
