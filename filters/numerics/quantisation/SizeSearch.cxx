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

template <class Number, class Count>
Number SumOfPatches(const TMesh& mesh, const std::vector<Count>& counts)
{
  Number quads = 0;
  for (const TPatch& patch : mesh.patches)
  {
    Number sides[2] = { 0, 0 };
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

/// Searches as SearchSize does, with numbers of quads instead of counts, and returns the best size.
double NearestSize(double requested, double first,
  const std::function<double(double size)>& quadsOf, const Progress& progress)
{
  double best = first;
  double smallestError = -1.0;
  double tooMany = 0.0; // sizes; 0 if there is none yet
  double tooFew = 0.0;
  double size = first;
  for (int tried = 0; tried < MaximumSizes; ++tried)
  {
    progress.Report(static_cast<double>(tried) / MaximumSizes);
    const double ratio = quadsOf(size) / requested;
    const double error = std::abs(ratio - 1.0);
    (ratio > 1.0 ? tooMany : tooFew) = size;
    if (smallestError < 0.0 || error < smallestError)
    {
      smallestError = error;
      best = size;
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
  return best;
}
}

long long CountQuads(const TMesh& mesh, const std::vector<int>& counts)
{
  return SumOfPatches<long long>(mesh, counts);
}

double CountQuads(const TMesh& mesh, const std::vector<double>& relaxed)
{
  return SumOfPatches<double>(mesh, relaxed);
}

EdgeCounts SearchSize(const TMesh& mesh, int requested, double first,
  const std::function<EdgeCounts(double)>& countsOf, const Progress& progress)
{
  EdgeCounts best;
  double seconds = 0.0;
  const auto quadsOf = [&](double size)
  {
    EdgeCounts counts = countsOf(size);
    counts.size = size;
    seconds += counts.seconds;
    const auto quads = static_cast<double>(CountQuads(mesh, counts.counts));
    if (best.counts.empty() ||
      CountError(mesh, counts, requested) < CountError(mesh, best, requested))
    {
      best = std::move(counts);
    }
    return quads;
  };
  NearestSize(requested, first, quadsOf, progress);
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

EdgeCounts SearchCountsByEstimates(const TMesh& mesh, int requested, double area,
  const std::function<EdgeCounts(double size, SearchEffort effort)>& countsOf,
  const std::function<double(double size)>& estimate, const Progress& progress)
{
  constexpr int MaximumSolutions = 4;
  const auto partOf = [&progress](int solution)
  {
    return progress.Part(static_cast<double>(solution) / MaximumSolutions,
      static_cast<double>(solution + 1) / MaximumSolutions);
  };
  const double first = std::sqrt(area / requested);
  EdgeCounts best = countsOf(first, SearchEffort::Quick);
  if (best.optimal)
  {
    return SearchCounts(mesh, 0.0, requested, area, countsOf, progress);
  }
  best.size = first;
  double seconds = best.seconds;
  double size = first;
  double estimated = requested; // the number of estimates that stands for the requested one
  for (int solution = 1; solution < MaximumSolutions; ++solution)
  {
    size = NearestSize(estimated, size, estimate, partOf(solution));
    EdgeCounts counts = countsOf(size, SearchEffort::Thorough);
    counts.size = size;
    seconds += counts.seconds;
    const auto quads = static_cast<double>(CountQuads(mesh, counts.counts));
    const double error = CountError(mesh, counts, requested);
    if (error <= std::max(CountTolerance, CountError(mesh, best, requested)))
    {
      best = std::move(counts);
    }
    if (error <= CountTolerance)
    {
      break;
    }
    estimated = requested * estimate(size) / quads;
  }
  best.seconds = seconds;
  return best;
}

double CountError(const TMesh& mesh, const EdgeCounts& counts, int requested)
{
  return std::abs(static_cast<double>(CountQuads(mesh, counts.counts)) / requested - 1.0);
}
}
