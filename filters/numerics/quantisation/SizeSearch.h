#pragma once

#include "Quantisation.h"

#include <functional>

namespace crossfield
{
/// Returns the number of quads of a T-mesh with edge counts.
long long CountQuads(const TMesh& mesh, const std::vector<int>& counts);

/// Relative tolerance of a requested number of quads.
constexpr double CountTolerance = 0.05;

/// Searches for the size whose number of quads is nearest to the requested one, starting at
/// `first`: by the square root law, then by bisection between a size that gives too many and one
/// that gives too few. The number jumps where a row of quads comes in, so no size may give a number
/// within the jump. `countsOf` returns the edge counts for a size, at most 20 times.
EdgeCounts SearchSize(const TMesh& mesh, int requested, double first,
  const std::function<EdgeCounts(double)>& countsOf, const Progress& progress = {});

/// Returns the counts for a size if it is positive, otherwise those of SearchSize for a number, started at the size of
/// as many squares of an area. The search uses quick solutions; a thorough one of its size replaces the last of them
/// unless its number is farther from the requested one.
EdgeCounts SearchCounts(const TMesh& mesh, double size, int requested, double area,
  const std::function<EdgeCounts(double size, SearchEffort effort)>& countsOf,
  const Progress& progress = {});

/// Returns |number of quads / requested number − 1|.
double CountError(const TMesh& mesh, const EdgeCounts& counts, int requested);
}
