#pragma once

#include "Quantisation.h"

#include <functional>

namespace crossfield
{
/// Returns the number of quads of a T-mesh with edge counts.
long long CountQuads(const TMesh& mesh, const std::vector<int>& counts);
/// Returns that of relaxed counts, Σ a · b over the patches, a and b the sums of two adjacent sides.
double CountQuads(const TMesh& mesh, const std::vector<double>& relaxed);

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

/// Searches as SearchCounts does without a size, for edge counts that take long. A quick solution of the first size finds
/// separation rows, which `countsOf` stores. Further sizes are tried by `estimate` alone: the number of quads of a
/// relaxation with these rows. A thorough solution follows for the size found. While it misses the requested number by
/// more than CountTolerance, at most twice more, estimates are multiplied by the ratio of its number and its estimate.
/// If the first solution is optimal, edge counts take little time, and SearchCounts is used.
EdgeCounts SearchCountsByEstimates(const TMesh& mesh, int requested, double area,
  const std::function<EdgeCounts(double size, SearchEffort effort)>& countsOf,
  const std::function<double(double size)>& estimate, const Progress& progress = {});

/// Returns |number of quads / requested number − 1|.
double CountError(const TMesh& mesh, const EdgeCounts& counts, int requested);
}
