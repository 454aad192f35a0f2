#include "CleanBlocks.h"

#include "Candidates.h"
#include "Error.h"
#include "Index.h"
#include "MeshForPoints.h"
#include "SizeSearch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <iterator>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// Ratios of coarse quads. Each one merges more arcs than the last. The first one merges only arcs that
/// have no blocks between them already, which makes the quads there better.
constexpr std::array<double, 8> Coarseness = { 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0 };

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
  Layout layout;
  std::vector<int> tried;
};

/// An attempt to close a layout, and what came of it.
struct Attempt
{
  bool isFromFirst = false; ///< From the layout of the start, not from the best one.
  double coarseness = 0.0;
  std::vector<int> arcs; ///< The arcs that should vanish.
  int maximumMaps = 0;   ///< The limit with which it was made.
  bool isEvaluated = false;
  int maps = 0;                    ///< Number of maps that were solved.
  LayoutSet layouts;               ///< The closed layout.
  std::optional<QuadResult> quads; ///< Absent if the layout has no quads or is that of the start.
  std::exception_ptr failure;
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
    { return MeshThroughPoints(domain, singularities, options.meshSize, progress); };
    this->Closing.sizes = options.quads.sizes;
    this->Closing.size = start.quads.size;
  }

  /// Closes for the ratio of coarse quads with an index, from the best layout and, if that fails, from
  /// the start. Returns false if what was tried failed.
  bool Try(std::size_t i, const Progress& progress)
  {
    this->Closing.coarseness = Coarseness[i];
    const bool hasTwo = this->Result.accepted;
    const Outcome outcome = this->TryFrom(false, i, progress.Part(0.0, 0.5));
    if (outcome == Outcome::Accepted)
    {
      this->Prepared.clear(); // they start from another layout
      this->Best.layout = this->Result.mesh.layouts.Single();
      this->Best.tried = FindArcsToClose(this->Best.layout.tMesh, this->Closing);
      return true;
    }
    if (outcome == Outcome::Nothing || !hasTwo)
    {
      return outcome == Outcome::Nothing;
    }
    if (this->TryFrom(true, i, progress.Part(0.5, 1.0)) == Outcome::Accepted)
    {
      this->Prepared.clear();
      this->Best = { this->Result.mesh.layouts.Single(), {} };
      return true;
    }
    return false;
  }

  CleanBlocksResult TakeResult()
  {
    this->Result.largestMove = LargestMove(
      this->First.layout.singularities, this->Result.mesh.layouts.Single().singularities);
    return std::move(this->Result);
  }

private:
  enum class Outcome
  {
    Nothing, ///< There are no other arcs than those that were tried.
    Failed,
    Accepted
  };

  ClosingStart& StartOf(bool isFromFirst) { return isFromFirst ? this->First : this->Best; }

  /// Returns the limit of maps of the next attempt.
  int MapsLeft() const
  {
    return std::min(ClosingOptions().maximumMaps, this->MaximumMaps - this->Result.maps);
  }

  Outcome TryFrom(bool isFromFirst, std::size_t i, const Progress& progress)
  {
    ClosingStart& start = this->StartOf(isFromFirst);
    Attempt attempt = this->Prepare(isFromFirst, i);
    if (attempt.arcs == start.tried || attempt.maximumMaps <= 0)
    {
      return Outcome::Nothing;
    }
    if (!attempt.isEvaluated)
    {
      attempt = this->EvaluateBatch(std::move(attempt), i, progress);
    }
    start.tried = std::move(attempt.arcs);
    if (attempt.failure)
    {
      std::rethrow_exception(attempt.failure);
    }
    this->Result.maps += attempt.maps;
    if (!attempt.quads || !IsAsGood(attempt.quads->quality, this->Start.quality) ||
      !KeepsCount(*attempt.quads, this->Start, this->Options.quads) ||
      !IsBetter(*attempt.quads, this->Result.mesh.quads))
    {
      return Outcome::Failed;
    }
    this->Result.accepted = true;
    this->Result.coarseness = attempt.coarseness;
    this->Result.mesh = { std::move(attempt.layouts), std::move(*attempt.quads) };
    return Outcome::Accepted;
  }

  /// Returns an attempt with the present limit of maps: the one that was evaluated together with an
  /// earlier attempt, if it would have the same result with this limit, or one to evaluate.
  Attempt Prepare(bool isFromFirst, std::size_t i)
  {
    const auto found = std::find_if(this->Prepared.begin(), this->Prepared.end(),
      [&](const Attempt& one)
      { return one.isFromFirst == isFromFirst && one.coarseness == Coarseness[i]; });
    if (found != this->Prepared.end())
    {
      Attempt attempt = std::move(*found);
      this->Prepared.erase(found);
      if (attempt.maps <= this->MapsLeft())
      {
        attempt.maximumMaps = this->MapsLeft();
        return attempt;
      }
    }
    Attempt attempt;
    attempt.isFromFirst = isFromFirst;
    attempt.coarseness = Coarseness[i];
    attempt.maximumMaps = this->MapsLeft();
    ClosingOptions options = this->Closing;
    options.coarseness = attempt.coarseness;
    attempt.arcs = FindArcsToClose(this->StartOf(isFromFirst).layout.tMesh, options);
    return attempt;
  }

  /// Evaluates an attempt, together with those that follow if it fails, which are kept. Returns it.
  Attempt EvaluateBatch(Attempt attempt, std::size_t i, const Progress& progress)
  {
    // Later attempts close more arcs and take longer, so with more of them at the same time the search
    // would take longer than with one thread.
    constexpr std::size_t MostAtOnce = 2;
    const std::size_t batch = std::min(MostAtOnce,
      CandidateBatch(std::max(
        this->Start.mesh.quads.size(), this->First.layout.map.topology->mesh.triangles.size())));
    this->Prepared.clear(); // made for another number of maps that are left
    std::vector<Attempt> attempts;
    std::array<std::vector<int>, 2> tried = { this->Best.tried, this->First.tried };
    const auto add = [&](Attempt one)
    {
      std::vector<int>& last = tried[one.isFromFirst ? 1 : 0];
      if (one.arcs != last && one.maximumMaps > 0 && !one.isEvaluated)
      {
        last = one.arcs;
        attempts.push_back(std::move(one));
      }
    };
    const bool fromFirst = attempt.isFromFirst;
    add(std::move(attempt));
    for (std::size_t next = i; next < Coarseness.size() && attempts.size() < batch; ++next)
    {
      for (const bool isFromFirst : { false, true })
      {
        const bool isLater = next > i || (isFromFirst && !fromFirst);
        if (isLater && (!isFromFirst || this->Result.accepted) && attempts.size() < batch)
        {
          add(this->Prepare(isFromFirst, next));
        }
      }
    }
    ProgressOfParts shared(progress);
    ForParts(attempts.size(), [&](std::size_t a) { this->Evaluate(attempts[a], shared.Get()); });
    Attempt result = std::move(attempts.front());
    this->Prepared.insert(this->Prepared.end(), std::make_move_iterator(attempts.begin() + 1),
      std::make_move_iterator(attempts.end()));
    return result;
  }

  void Evaluate(Attempt& attempt, const Progress& progress)
  {
    attempt.isEvaluated = true;
    ClosingOptions options = this->Closing;
    options.coarseness = attempt.coarseness;
    options.maximumMaps = attempt.maximumMaps;
    try
    {
      ClosingResult closed =
        CloseLayout(this->Domain, this->StartOf(attempt.isFromFirst).layout, options, progress);
      attempt.maps = closed.maps;
      attempt.layouts = LayoutSet(std::move(closed.layout), this->Result.mesh.layouts.pairs);
    }
    catch (...)
    {
      attempt.failure = std::current_exception();
      return;
    }
    try
    {
      if (attempt.maps > 0)
      {
        attempt.quads = MakeQuads(attempt.layouts, this->Options.quads);
      }
    }
    catch (const Error&)
    {
      // The layout has no quad mesh.
    }
    catch (...)
    {
      attempt.failure = std::current_exception();
    }
  }

  const PlanarDomain& Domain;
  const CleanOptions& Options;
  const int MaximumMaps;
  const QuadResult& Start;
  ClosingStart First;
  ClosingStart Best;
  ClosingOptions Closing;
  /// Attempts that follow the present one if all fail, evaluated together with it. Fewer than the
  /// threads.
  std::vector<Attempt> Prepared;
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
    const bool fails = !search.Try(i, progress.Part(done / count, (done + 1.0) / count));
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
