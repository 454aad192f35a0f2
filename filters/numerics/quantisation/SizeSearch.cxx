#include "SizeSearch.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace crossfield
{
namespace
{
constexpr int MaximumSizes = 20;
/// Relative error that ends the search at once; after a few sizes CountTolerance does.
constexpr double FineTolerance = 0.01;
constexpr int FewSizes = 6;
}

long long CountQuads(const TMesh& mesh, const std::vector<int>& counts)
{
  long long quads = 0;
  for (const TPatch& patch : mesh.patches)
  {
    long long sides[2] = { 0, 0 };
    for (const std::size_t side : { std::size_t(0), std::size_t(1) })
    {
      for (const int half : patch.sides[side])
      {
        sides[side] += counts[half / 2];
      }
    }
    quads += sides[0] * sides[1];
  }
  return quads;
}

EdgeCounts SearchSize(const TMesh& mesh, int requested, double first,
  const std::function<EdgeCounts(double)>& countsOf, const Progress& progress)
{
  EdgeCounts best;
  double smallestError = -1.0;
  double tooMany = 0.0; // sizes; 0 if there is none yet
  double tooFew = 0.0;
  double size = first;
  double seconds = 0.0;
  for (int tried = 0; tried < MaximumSizes; ++tried)
  {
    progress.Report(static_cast<double>(tried) / MaximumSizes);
    EdgeCounts counts = countsOf(size);
    seconds += counts.seconds;
    const long long quads = CountQuads(mesh, counts.counts);
    const double ratio = static_cast<double>(quads) / requested;
    const double error = std::abs(ratio - 1.0);
    (ratio > 1.0 ? tooMany : tooFew) = size;
    if (smallestError < 0.0 || error < smallestError)
    {
      smallestError = error;
      best = std::move(counts);
      best.size = size;
    }
    if (smallestError <= FineTolerance ||
      (smallestError <= CountTolerance && tried + 1 >= FewSizes))
    {
      break;
    }
    if (tooMany > 0.0 && tooFew > 0.0 && tried > 1)
    {
      // Between sizes as near as these the counts hardly change.
      if (std::abs(tooFew - tooMany) < 1e-3 * tooMany)
      {
        break;
      }
      size = std::sqrt(tooMany * tooFew);
    }
    else
    {
      // A step of at least 2 % leaves a range of sizes with the same number.
      const double factor = std::sqrt(std::max(ratio, 0.01));
      size *= ratio > 1.0 ? std::max(factor, 1.02) : std::min(factor, 0.98);
      // Prescribed sums may determine all counts, whatever the size.
      constexpr double Widest = 16.0;
      if (size > Widest * first || size * Widest < first)
      {
        break;
      }
    }
  }
  best.seconds = seconds;
  return best;
}

EdgeCounts SearchCounts(const TMesh& mesh, double size, int requested, double area,
  const std::function<EdgeCounts(double size, SearchEffort effort)>& countsOf,
  const Progress& progress)
{
  if (size > 0.0)
  {
    progress.Report(0.0);
    EdgeCounts counts = countsOf(size, SearchEffort::Thorough);
    counts.size = size;
    return counts;
  }
  EdgeCounts found = SearchSize(
    mesh, requested, std::sqrt(area / requested),
    [&](double tried) { return countsOf(tried, SearchEffort::Quick); }, progress);
  if (found.optimal)
  {
    return found;
  }
  EdgeCounts thorough = countsOf(found.size, SearchEffort::Thorough);
  thorough.size = found.size;
  thorough.seconds = found.seconds += thorough.seconds; // of both, whichever is returned
  const double error = CountError(mesh, thorough, requested);
  return error <= CountTolerance || error <= CountError(mesh, found, requested) ? thorough : found;
}

double CountError(const TMesh& mesh, const EdgeCounts& counts, int requested)
{
  return std::abs(static_cast<double>(CountQuads(mesh, counts.counts)) / requested - 1.0);
}
}
