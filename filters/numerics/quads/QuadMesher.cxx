#include "QuadMesher.h"

#include "Chords.h"
#include "Error.h"
#include "MemoryBudget.h"
#include "QuadLayout.h"
#include "QuadSymmetry.h"
#include "SizeSearch.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace crossfield
{
namespace
{
/// Area of the map, which is the domain's.
double AreaOf(const TMesh& lines)
{
  double area = 0.0;
  for (const TPatch& face : lines.patches)
  {
    area += lines.SideLength(face, 0) * lines.SideLength(face, 1);
  }
  return area;
}

/// The outer loop first.
PlanarDomain DomainOf(const MeshTopology& topology)
{
  PlanarDomain domain;
  domain.loops = topology.AlignedLoops();
  const auto outer = std::find_if(domain.loops.begin(), domain.loops.end(),
    [](const Loop& loop) { return SignedArea(loop) > 0.0; });
  std::iter_swap(domain.loops.begin(), outer);
  return domain;
}

/// The problem of a size, of lengths for size 1.
ArcProblem ProblemOf(const TMesh& lines, std::vector<double> lengths, double size)
{
  for (double& length : lengths)
  {
    length /= size;
  }
  return MakeArcProblem(lines, std::move(lengths));
}

/// Lays, smooths and measures meshes of one T-mesh.
class Mesher
{
public:
  Mesher(const SeamlessMap& map, const QuadOptions& options, QuadResult& result)
    : Map(map)
    , Options(options)
    , Result(result)
    , Curves(*map.topology)
    , Domain(DomainOf(*map.topology))
    , Lengths(TargetLengths(result.lines, options.sizes))
    , Area(AreaOf(result.lines))
  {
  }

  /// Counts of the wanted size, or of one that gives the wanted number: that is searched for quickly.
  void Count(const Progress& progress)
  {
    const auto countsOf = [this](double size, ArcSearch search)
    {
      return CountArcs(
        this->Result.lines, ProblemOf(this->Result.lines, this->Lengths, size), search);
    };
    const bool given = this->Options.quadSize > 0.0;
    SizedCounts found = this->ForSize([&](double size)
      { return countsOf(size, given ? ArcSearch::Thorough : ArcSearch::Quick); },
      progress);
    if (!given && !found.counts.optimal)
    {
      ArcCounts best = countsOf(found.size, ArcSearch::Thorough);
      const double off = this->Off(best);
      if (off <= CountTolerance || off <= this->Off(found.counts))
      {
        found.counts = std::move(best);
      }
    }
    this->Take(found, this->Result);
  }

  void Lay(QuadResult& result) const
  {
    Stopwatch stopwatch;
    RequireMemory(
      static_cast<double>(CountQuads(result.lines, result.counts.counts)) * BytesPerQuad,
      "So many quads", "use a larger size or fewer quads");
    result.mesh = LayQuads(this->Map, result.lines, result.counts.counts, result.size);
    WantSizes(result.mesh, this->Options.sizes, this->Area);
    result.layoutSeconds += stopwatch.Lap();
  }

  void Smooth(QuadResult& result, const Progress& progress) const
  {
    Stopwatch stopwatch;
    const bool even = this->Options.sizes.sizing != Sizing::Conformal;
    result.blocks = FindBlocks(result.mesh); // of the quads alone, wherever the points go
    if (!this->Options.smooth)
    {
      result.quality = MeasureQuads(result.mesh, result.size);
      return;
    }
    result.smoothing = SmoothQuads(result.mesh, result.blocks, this->Curves, even, progress);
    result.smoothing.symmetries =
      MakeSymmetric(result.mesh, this->Curves, this->Domain, result.smoothing.released);
    result.smoothSeconds += stopwatch.Lap();
    result.quality = MeasureQuads(result.mesh, result.size);
  }

  /// Replaces the result by one with fewer blocks, the fewest that are sound.
  void Coarsen(const Progress& progress)
  {
    std::vector<QuadResult> tried = this->CoarseResults();
    std::stable_sort(tried.begin(), tried.end(),
      [](const QuadResult& a, const QuadResult& b)
      { return a.blocks.blocks.size() < b.blocks.blocks.size(); });
    const double least = SoundPart * this->Result.quality.jacobian.min;
    for (std::size_t i = 0; i < tried.size(); ++i)
    {
      if (tried[i].blocks.blocks.size() >= this->Result.blocks.blocks.size())
      {
        return;
      }
      const auto count = static_cast<double>(tried.size());
      this->Lay(tried[i]);
      this->Smooth(tried[i],
        progress.Part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
      if (tried[i].quality.inverted == 0 && tried[i].quality.jacobian.min >= least)
      {
        this->Result = std::move(tried[i]);
        return;
      }
    }
  }

private:
  /// A mesh is sound where its worst quad has this part of the scaled Jacobian of that with all blocks.
  static constexpr double SoundPart = 0.5;
  /// Points, quads, lattices, energy, corrections of four numbers a point: at a million quads 770 were measured, with even
  /// sizes 930.
  static constexpr double BytesPerQuad = 1000.0;

  SizedCounts ForSize(
    const std::function<ArcCounts(double)>& countsOf, const Progress& progress) const
  {
    if (this->Options.quadSize > 0.0)
    {
      progress.Report(0.0);
      return { this->Options.quadSize, countsOf(this->Options.quadSize), 0 };
    }
    return SearchSize(this->Result.lines, this->Options.quadCount,
      std::sqrt(this->Area / this->Options.quadCount), countsOf, progress);
  }

  /// The part by which a number of quads misses the wanted one.
  double Off(const ArcCounts& counts) const
  {
    const auto count = static_cast<double>(CountQuads(this->Result.lines, counts.counts));
    return std::abs(count / this->Options.quadCount - 1.0);
  }

  static void Take(const SizedCounts& found, QuadResult& result)
  {
    result.size = found.size;
    result.counts = found.counts;
  }

  /// Those of sizes from the wanted one to that of the domain, as far as they differ; with blocks, not smoothed.
  std::vector<QuadResult> CoarseResults() const
  {
    std::vector<QuadResult> results;
    std::vector<int> last;
    const double largest = std::sqrt(this->Area);
    for (double size = this->Result.size; size < largest; size *= std::sqrt(2.0))
    {
      const TMesh& lines = this->Result.lines;
      const ArcCounts coarse =
        CountArcs(lines, ProblemOf(lines, this->Lengths, size), ArcSearch::Quick);
      if (coarse.counts == last)
      {
        continue;
      }
      last = coarse.counts;
      const Chords chords(lines, coarse.counts);
      const SizedCounts found = this->ForSize(
        [&](double wanted)
        {
          const ArcProblem problem = ProblemOf(lines, this->Lengths, wanted);
          ArcCounts counts = coarse;
          counts.counts = chords.Refine(problem);
          counts.cost = problem.Cost(counts.counts);
          counts.bound = this->Result.counts.bound;
          counts.gap = std::max(0.0, (counts.cost - counts.bound) / (1.0 + counts.bound));
          counts.optimal = false;
          counts.seconds = this->Result.counts.seconds;
          return counts;
        },
        {});
      QuadResult result;
      result.lines = lines;
      this->Take(found, result);
      result.blocks = FindBlocks(LayQuads(this->Map, lines, result.counts.counts, result.size));
      results.push_back(std::move(result));
    }
    return results;
  }

  const SeamlessMap& Map;
  const QuadOptions& Options;
  QuadResult& Result;
  const BoundaryCurves Curves;
  const PlanarDomain Domain;
  const std::vector<double> Lengths;
  const double Area;
};
}

QuadResult MakeQuads(
  const SeamlessMap& map, TMesh lines, const QuadOptions& options, const Progress& progress)
{
  if (!(options.quadSize >= 0.0) || !std::isfinite(options.quadSize) ||
    (options.quadSize == 0.0 && options.quadCount < 1))
  {
    throw Error("The size of quads must be a positive number, or their count at least 1.");
  }
  QuadResult result;
  result.lines = std::move(lines);
  Mesher mesher(map, options, result);
  mesher.Count(progress.Part(0.0, 0.3));
  mesher.Lay(result);
  progress.Report(0.4);
  const double smoothed = options.coarse ? 0.7 : 1.0;
  mesher.Smooth(result, progress.Part(0.4, smoothed));
  if (options.coarse)
  {
    mesher.Coarsen(progress.Part(smoothed, 1.0));
  }
  progress.Report(1.0);
  return result;
}
}
