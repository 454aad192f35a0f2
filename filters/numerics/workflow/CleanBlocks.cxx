#include "CleanBlocks.h"

#include "Candidates.h"
#include "MeshForPoints.h"
#include "MeshGrade.h"
#include "Outcome.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// Ratios of coarse quads. Each one merges more arcs than the last. The first one merges only arcs that
/// have no blocks between them already, which makes the quads there better.
constexpr std::array<double, 8> Coarseness = { 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0 };

/// Returns the number of maps that the options allow for a number of singularities.
int MapsWithin(const CleanOptions& options, std::size_t singularities)
{
  const auto solvesPerMap = static_cast<int>(2 * std::max<std::size_t>(1, singularities));
  return std::min(options.maximumMaps, options.maximumSolves / solvesPerMap);
}

/// A layout to close, and the arcs that were tried last.
struct ClosingStart
{
  Layout layout;
  std::vector<int> tried;
};

/// An attempt to close a layout.
struct Attempt
{
  std::size_t ratio = 0;    ///< Entry of Coarseness.
  bool isFromFirst = false; ///< From the layout of the start, not from the best one.
  std::vector<int> arcs;    ///< The arcs that should vanish.
};

/// Result of an attempt.
struct AttemptResult
{
  int maps = 0; ///< Number of maps that were solved.
  LayoutSet layouts;
  std::optional<QuadResult> quads; ///< Absent if the layout has no quads or is that of the start.
};

/// The search for a mesh with fewer blocks.
class CleanSearch
{
public:
  CleanSearch(const PlanarDomain& domain, const MeshedLayout& start, const CleanOptions& options)
    : Domain(domain)
    , Options(options)
    , MaximumMaps(MapsWithin(options, start.layouts.Single().singularities.size()))
    , Start(start.quads)
    , First{ start.layouts.Single(), {} }
    , Best{ start.layouts.Single(), {} }
  {
    this->Result.mesh = start;
    this->Closing.map = options.map;
    this->Closing.mesh = [&](const Configuration& singularities, const Progress& progress)
    {
      return MeshThroughPoints(
        domain, singularities, options.meshSize, progress, 1.0, options.quads.sides.FixedPlaces());
    };
    this->Closing.sizes = options.quads.sizes;
    this->Closing.size = start.quads.size;
  }

  CleanBlocksResult Run(const Progress& progress)
  {
    // Later attempts close more arcs and take longer, so with more of them at the same time the search
    // would take longer than with one thread.
    constexpr std::size_t MostAtOnce = 2;
    const std::size_t batch = std::min(MostAtOnce,
      CandidateBatch(std::max(
        this->Start.mesh.quads.size(), this->First.layout.map.topology->mesh.triangles.size())));
    ProgressOfParts shared(progress);
    std::size_t next = 0;
    for (bool isAccepted = true; isAccepted;)
    {
      const std::vector<Attempt> attempts = this->AttemptsFrom(next);
      isAccepted = AcceptFirst(
        attempts.size(), batch,
        [&](std::size_t a)
        {
          const auto ratio = static_cast<double>(attempts[a].ratio);
          const double count = Coarseness.size();
          return this->Evaluate(
            attempts[a], shared.Get().Part(ratio / count, (ratio + 1.0) / count));
        },
        [&](std::size_t a, AttemptResult outcome)
        {
          next = attempts[a].ratio + 1;
          return this->Accepts(attempts[a], std::move(outcome), shared.Get().Part(1.0, 1.0));
        });
    }
    this->Result.largestMove = LargestMove(
      this->First.layout.singularities, this->Result.mesh.layouts.Single().singularities);
    return std::move(this->Result);
  }

private:
  ClosingStart& StartOf(const Attempt& attempt)
  {
    return attempt.isFromFirst ? this->First : this->Best;
  }

  ClosingOptions OptionsFor(std::size_t ratio) const
  {
    ClosingOptions options = this->Closing;
    options.coarseness = Coarseness[ratio];
    options.maximumMaps =
      std::min(ClosingOptions().maximumMaps, this->MaximumMaps - this->Result.maps);
    return options;
  }

  /// Returns the attempts from a ratio on that follow each other if all fail: from the best layout and,
  /// if that is not the start, from the start. Ratios that merge the same arcs as the last one are
  /// skipped. The search ends after two failures in a row.
  std::vector<Attempt> AttemptsFrom(std::size_t ratio) const
  {
    // After a failure with few arcs, more arcs that vanish together often succeed; after later ones
    // rarely.
    constexpr double Early = 2.0;
    constexpr int MaximumFailures = 2;
    std::vector<Attempt> attempts;
    std::vector<int> triedFromBest = this->Best.tried;
    std::vector<int> triedFromFirst = this->First.tried;
    for (int failures = 0; ratio < Coarseness.size() && failures < MaximumFailures; ++ratio)
    {
      const auto add = [&](const ClosingStart& start, bool isFromFirst, std::vector<int>& tried)
      {
        std::vector<int> arcs = FindArcsToClose(start.layout.tMesh, this->OptionsFor(ratio));
        const bool isNew = arcs != tried;
        if (isNew)
        {
          tried = arcs;
          attempts.push_back({ ratio, isFromFirst, std::move(arcs) });
        }
        return isNew;
      };
      const bool isTried = add(this->Best, false, triedFromBest);
      if (isTried && this->Result.accepted)
      {
        add(this->First, true, triedFromFirst);
      }
      failures = !isTried ? 0 : Coarseness[ratio] > Early ? failures + 1 : failures;
    }
    return attempts;
  }

  AttemptResult Evaluate(const Attempt& attempt, const Progress& progress)
  {
    AttemptResult outcome;
    const ClosingOptions options = this->OptionsFor(attempt.ratio);
    if (options.maximumMaps <= 0)
    {
      return outcome;
    }
    ClosingResult closed =
      CloseLayout(this->Domain, this->StartOf(attempt).layout, options, progress);
    outcome.maps = closed.maps;
    outcome.layouts = LayoutSet(std::move(closed.layout), this->Result.mesh.layouts.pairs);
    if (outcome.maps > 0)
    {
      outcome.quads = Try([&] { return MakeQuads(outcome.layouts, this->Options.quads); }).value;
    }
    return outcome;
  }

  /// Takes the outcome of an attempt as the result if it is better.
  bool Accepts(const Attempt& attempt, AttemptResult outcome, const Progress& progress)
  {
    const ClosingOptions options = this->OptionsFor(attempt.ratio);
    if (outcome.maps > std::max(0, options.maximumMaps))
    {
      // It was evaluated together with an attempt that has left fewer maps.
      outcome = this->Evaluate(attempt, progress);
    }
    this->StartOf(attempt).tried = attempt.arcs;
    this->Result.maps += outcome.maps;
    const QuadOptions& requested = this->Options.quads;
    if (!outcome.quads ||
      !IsAsClean(*outcome.quads, this->Start, requested.quadSize, requested.quadCount) ||
      !IsCoarser(*outcome.quads, this->Result.mesh.quads))
    {
      return false;
    }
    this->Result.accepted = true;
    this->Result.coarseness = options.coarseness;
    this->Result.mesh = { std::move(outcome.layouts), std::move(*outcome.quads) };
    this->Best = { this->Result.mesh.layouts.Single(), {} };
    if (!attempt.isFromFirst)
    {
      this->Best.tried = FindArcsToClose(this->Best.layout.tMesh, options);
    }
    return true;
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

CleanBlocksResult CleanBlocks(const PlanarDomain& domain, MeshedLayout start,
  const CleanOptions& options, const Progress& progress)
{
  CleanBlocksResult result = CleanSearch(domain, start, options).Run(progress);
  progress.Report(1.0);
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
