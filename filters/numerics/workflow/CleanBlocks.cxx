#include "CleanBlocks.h"

#include "Error.h"
#include "Index.h"
#include "SizeSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the maximum distance between corresponding singularities.
double LargestMove(const Configuration& from, const Configuration& to)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    largest = std::max(largest, (to[i].position - from[i].position).norm());
  }
  return largest;
}

/// Returns whether a mesh has the requested number of quads, if one was requested and the start has
/// it.
bool KeepsCount(const QuadResult& candidate, const QuadResult& start, const QuadOptions& options)
{
  const auto error = [&](const QuadResult& result)
  { return std::abs(static_cast<double>(result.mesh.quads.size()) / options.quadCount - 1.0); };
  return options.quadSize > 0.0 || error(candidate) <= std::max(CountTolerance, error(start));
}

/// Returns whether the quads of a smoothed mesh are as good as those of the start, within the limits
/// of IsCleaner.
bool IsAsGood(const QuadQuality& quality, const QuadQuality& start)
{
  return quality.inverted == 0 && quality.jacobian.min >= start.jacobian.min - 0.02 &&
    quality.jacobian.mean >= start.jacobian.mean - 0.002 &&
    quality.variation <= std::max(1.35 * start.variation, start.variation + 0.05);
}

/// Returns whether a mesh has fewer blocks than another one, or as many and a larger minimum scaled
/// Jacobian.
bool IsBetter(const QuadResult& a, const QuadResult& b)
{
  const std::size_t blocks = a.blocks.blocks.size();
  const std::size_t others = b.blocks.blocks.size();
  return blocks != others ? blocks < others : a.quality.jacobian.min > b.quality.jacobian.min;
}

/// Returns the number of maps that the options allow for a number of singularities.
int MapsWithin(const CleanOptions& options, std::size_t singularities)
{
  const auto solvesPerMap = static_cast<int>(2 * std::max<std::size_t>(1, singularities));
  return std::min(options.maximumMaps, options.maximumSolves / solvesPerMap);
}

/// A layout to close, and the arcs that were tried last.
struct ClosingStart
{
  ClosingLayout layout;
  std::vector<int> tried;
};

/// The search for a mesh with fewer blocks.
class CleanSearch
{
public:
  CleanSearch(const PlanarDomain& domain, const MeshedLayout& start, const CleanOptions& options)
    : Domain(domain)
    , Options(options)
    , MaximumMaps(MapsWithin(options, start.layout.singularities.size()))
    , Start(start.quads)
    , First{ start.layout, {} }
    , Best{ start.layout, {} }
  {
    this->Result.mesh = start;
    this->Closing.map = options.map;
    this->Closing.meshSize = options.meshSize;
    this->Closing.sizes = options.quads.sizes;
    this->Closing.size = start.quads.size;
  }

  /// Closes for a ratio of coarse quads, from the best layout and, if that fails, from the start.
  /// Returns false if what was tried failed.
  bool Try(double coarseness, const Progress& progress)
  {
    this->Closing.coarseness = coarseness;
    const bool hasTwo = this->Result.accepted;
    const Outcome outcome = this->TryFrom(this->Best, progress.Part(0.0, 0.5));
    if (outcome == Outcome::Accepted)
    {
      this->Best.layout = this->Result.mesh.layout;
      this->Best.tried = FindArcsToClose(this->Best.layout.tMesh, this->Closing);
      return true;
    }
    if (outcome == Outcome::Nothing || !hasTwo)
    {
      return outcome == Outcome::Nothing;
    }
    if (this->TryFrom(this->First, progress.Part(0.5, 1.0)) == Outcome::Accepted)
    {
      this->Best = { this->Result.mesh.layout, {} };
      return true;
    }
    return false;
  }

  CleanBlocksResult TakeResult()
  {
    this->Result.largestMove =
      LargestMove(this->First.layout.singularities, this->Result.mesh.layout.singularities);
    return std::move(this->Result);
  }

private:
  enum class Outcome
  {
    Nothing, ///< There are no other arcs than those that were tried.
    Failed,
    Accepted
  };

  Outcome TryFrom(ClosingStart& start, const Progress& progress)
  {
    std::vector<int> arcs = FindArcsToClose(start.layout.tMesh, this->Closing);
    this->Closing.maximumMaps =
      std::min(ClosingOptions().maximumMaps, this->MaximumMaps - this->Result.maps);
    if (arcs == start.tried || this->Closing.maximumMaps <= 0)
    {
      return Outcome::Nothing;
    }
    start.tried = std::move(arcs);
    ClosingResult closed = CloseLayout(this->Domain, start.layout, this->Closing, progress);
    this->Result.maps += closed.maps;
    try
    {
      QuadResult quads = MakeQuads(closed.layout.map, closed.layout.tMesh, this->Options.quads);
      if (closed.maps > 0 && IsAsGood(quads.quality, this->Start.quality) &&
        KeepsCount(quads, this->Start, this->Options.quads) &&
        IsBetter(quads, this->Result.mesh.quads))
      {
        this->Result.accepted = true;
        this->Result.coarseness = this->Closing.coarseness;
        this->Result.mesh = { std::move(closed.layout), std::move(quads) };
        return Outcome::Accepted;
      }
    }
    catch (const Error&)
    {
      return Outcome::Failed; // the layout has no quad mesh
    }
    return Outcome::Failed;
  }

  const PlanarDomain& Domain;
  const CleanOptions& Options;
  const int MaximumMaps;
  const QuadResult& Start;
  ClosingStart First;
  ClosingStart Best;
  ClosingOptions Closing;
  CleanBlocksResult Result;
};
}

bool IsCleaner(const QuadResult& candidate, const QuadResult& start)
{
  return candidate.blocks.blocks.size() < start.blocks.blocks.size() &&
    IsAsGood(candidate.quality, start.quality);
}

CleanBlocksResult CleanBlocks(const PlanarDomain& domain, MeshedLayout start,
  const CleanOptions& options, const Progress& progress)
{
  // Each one merges more arcs than the last. The first one merges only arcs that have no blocks
  // between them already, which makes the quads there better.
  constexpr std::array<double, 8> Coarseness = { 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0 };
  // After a failure with few arcs, more arcs that vanish together often succeed; after later ones
  // rarely.
  constexpr double Early = 2.0;
  constexpr int MaximumFailures = 2;
  CleanSearch search(domain, start, options);
  int failures = 0; // in a row
  const auto count = static_cast<double>(Coarseness.size());
  for (std::size_t i = 0; i < Coarseness.size() && failures < MaximumFailures; ++i)
  {
    const auto done = static_cast<double>(i);
    const bool fails =
      !search.Try(Coarseness[i], progress.Part(done / count, (done + 1.0) / count));
    failures = fails && Coarseness[i] > Early ? failures + 1 : fails ? failures : 0;
  }
  progress.Report(1.0);
  CleanBlocksResult result = search.TakeResult();
  // A layout with as many blocks is a better start, but no reason to move singularities.
  if (result.mesh.quads.blocks.blocks.size() >= start.quads.blocks.blocks.size())
  {
    result.mesh = std::move(start);
    result.accepted = false;
    result.largestMove = 0.0;
  }
  return result;
}
}
