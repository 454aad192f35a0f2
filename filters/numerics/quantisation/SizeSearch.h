#pragma once

#include "ArcCounts.h"

#include <functional>

namespace crossfield
{
/// Quads that faces of so many edges have.
long long CountQuads(const TMesh& mesh, const std::vector<int>& counts);

/// A size, its counts and how many quads they give.
struct SizedCounts
{
  double size = 0.0;
  ArcCounts counts;
  long long quads = 0;
};

/// The part by which a number of quads may miss the wanted one.
constexpr double CountTolerance = 0.05;

/// The size whose number of quads is nearest to the wanted one, of at most `MostSizes`: first along the square root law,
/// then by halving between one that gives too many and one that gives too few. A count jumps with the size where a
/// whole row of quads comes in at once, so within a jump there is none.
SizedCounts SearchSize(const TMesh& mesh, int wanted, double first,
  const std::function<ArcCounts(double)>& countsOf, const Progress& progress = {});
}
