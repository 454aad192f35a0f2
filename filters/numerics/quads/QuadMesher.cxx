#include "QuadMesher.h"

#include "ArcOrbits.h"
#include "ArcSpacing.h"
#include "BoundaryOrder.h"
#include "BoundarySymmetry.h"
#include "CoarseBlocks.h"
#include "CountCheck.h"
#include "Error.h"
#include "GradedArcs.h"
#include "HeldNodes.h"
#include "MemoryBudget.h"
#include "MoveInside.h"
#include "NodePairs.h"
#include "PairedArcs.h"
#include "PrescribedSides.h"
#include "PrescribedSums.h"
#include "QuadBuilder.h"
#include "QuadSides.h"
#include "QuadSymmetry.h"
#include "Quantisation.h"
#include "SidePlacement.h"
#include "SizeSearch.h"
#include "SmoothLoops.h"
#include "SplitAtSides.h"
#include "Stopwatch.h"
#include "TargetLengths.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns the size of quads that the options ask for in a domain with an area, from which a search
/// for a number starts.
double FirstSize(const QuadOptions& options, double area)
{
  return options.quadSize > 0.0 ? options.quadSize : std::sqrt(area / options.quadCount);
}

/// Builds, smooths and measures meshes of one T-mesh.
class Mesher
{
public:
  Mesher(const SeamlessMap& map, const std::vector<PairedSides>& pairs, const MeshBoundary& curves,
    const QuadOptions& options, QuadResult& result)
    : Map(map)
    , Pairs(pairs)
    , Options(options)
    , Result(result)
    , Curves(curves)
    , HasInterfaces(std::any_of(
        pairs.begin(), pairs.end(), [](const PairedSides& pair) { return pair.isInterface; }))
    , Domain{ RequirePlanar(map.topology)->AlignedLoops() }
    , Lengths(TargetLengths(result.tMesh, options.sizes))
    , Area(AreaOf(result.tMesh))
    , Graded(map, this->Curves, options.sides, options.prescribed, result.tMesh)
    , LoopsWithoutCorners(map, this->Curves, options.sides, options.prescribed, result.tMesh)
    , Sums(SumsOf(map, pairs, curves, options, result.tMesh))
  {
  }

  /// Computes the edge counts for the given size, or for a size that gives the requested number of
  /// quads. That size is searched for with quick solutions. Counts have the symmetries of the
  /// domain, or one reflection, or none, as far as a requested number permits it.
  void ComputeCounts(const Progress& progress)
  {
    const std::vector<std::vector<Isometry>> lists = this->SymmetriesToTry();
    const auto count = static_cast<double>(lists.size());
    std::optional<EdgeCounts> best;
    const bool isField = this->Options.sizes.sizing == Sizing::Field;
    for (std::size_t i = 0; i < lists.size(); ++i)
    {
      this->Balances = isField || this->HasInterfaces;
      this->Orbits = this->FindOrbits(lists[i]);
      if (this->Orbits->CountSymmetries() == 1 && i + 1 < lists.size())
      {
        continue; // no symmetries of the T-mesh, or prescribed sums do not permit them
      }
      const auto done = static_cast<double>(i);
      EdgeCounts found = this->FindCounts(progress.Part(done / count, (done + 1.0) / count));
      if (isField && this->CountError(found) > CountTolerance)
      {
        // Any number of rows between the targets of a strip's ends will do.
        this->Balances = false;
        EdgeCounts other =
          this->FindCounts(progress.Part((done + 1.0) / count, (done + 1.0) / count));
        if (this->CountError(other) < this->CountError(found))
        {
          found = std::move(other);
        }
      }
      if (!best || this->CountError(found) < this->CountError(*best))
      {
        best = std::move(found);
      }
      if (this->CountError(*best) <= CountTolerance)
      {
        break;
      }
    }
    this->Result.size = best->size;
    this->Result.counts = std::move(*best);
  }

  void Build(QuadResult& result) const
  {
    Stopwatch stopwatch;
    RequireMemory(
      static_cast<double>(CountQuads(result.tMesh, result.counts.counts)) * BytesPerQuad,
      "This number of quads", "use a larger size or fewer quads");
    const std::vector<int>& counts = result.counts.counts;
    const auto build = [&](const std::vector<std::vector<double>>& spacing)
    {
      return BuildQuads(
        this->Map, this->Curves, result.tMesh, counts, spacing, result.size, this->Options.sides);
    };
    result.mesh = build(EqualSpacing(result.tMesh, counts));
    const std::vector<int> prescribed = this->Graded.ArcsWithCounts();
    if (!prescribed.empty())
    {
      // If few strips take up a large change, their quads are sheared; otherwise angles are those
      // of the map, and differ by less than this.
      constexpr double LargestLoss = 0.1;
      QuadMesh gradual = build(GradualSpacing(result.tMesh, counts, prescribed));
      const QuadQuality quality = MeasureQuads(gradual, result.size);
      const QuadQuality equal = MeasureQuads(result.mesh, result.size);
      if (quality.inverted <= equal.inverted &&
        quality.jacobian.min >= equal.jacobian.min - LargestLoss)
      {
        result.mesh = std::move(gradual);
      }
    }
    SetTargetLengths(result.mesh, this->Options.sizes, this->Area);
    PlaceOnSides(this->Curves, this->Options.prescribed, this->Options.hold, result.mesh);
    this->PairNodes(result.mesh);
    PlaceNodes(this->Curves, this->Options.nodes, result.mesh);
    MatchPairs(this->Curves, result.mesh);
    this->NameEdges(result.mesh);
    result.blocks = FindBlocks(result.mesh);
    result.layoutSeconds += stopwatch.Lap();
  }

  double DomainArea() const { return this->Area; }

  void Smooth(QuadResult& result, const Progress& progress) const
  {
    Stopwatch stopwatch;
    const bool isConformal = this->Options.sizes.sizing == Sizing::Conformal &&
      std::none_of(this->Options.prescribed.begin(), this->Options.prescribed.end(),
        [](const SidePrescription& one) { return one.isGraded; });
    const std::optional<double> sizePart =
      isConformal ? std::nullopt : std::optional<double>(this->Options.sizePart);
    result.smoothing = SmoothQuads(
      result.mesh, result.blocks, { this->Curves }, sizePart, this->Options.hold, progress);
    if (this->HasInterfaces)
    {
      MatchPairs(this->Curves, result.mesh);
    }
    else
    {
      MakeSymmetricAndPeriodic(result.mesh, this->Curves, this->Domain, result.smoothing);
    }
    this->NameEdges(result.mesh);
    result.smoothSeconds += stopwatch.Lap();
    result.quality = MeasureQuads(result.mesh, result.size);
  }

  /// Replaces the result by the one with the fewest blocks whose quads are acceptable, if it has
  /// fewer.
  void Coarsen(const Progress& progress)
  {
    UseFewestBlocks(
      { [this](double size) { return this->ProblemFor(size); },
        [this](const BlockSteps::CountsOf& countsOf) { return this->SearchCountsOf(countsOf, {}); },
        [this](const QuadResult& result)
        {
          return std::make_optional(BuildQuads(this->Map, this->Curves, result.tMesh,
            result.counts.counts, EqualSpacing(result.tMesh, result.counts.counts), result.size));
        },
        [this](QuadResult& result, const Progress& part)
        {
          this->Build(result);
          this->Smooth(result, part);
        } },
      this->Area, this->Result, progress);
  }

private:
  /// Returns all sums of edge counts that the options prescribe.
  static std::vector<CountSum> SumsOf(const SeamlessMap& map, const std::vector<PairedSides>& pairs,
    const MeshBoundary& curves, const QuadOptions& options, const TMesh& tMesh)
  {
    std::vector<CountSum> sums = PairSums(map, curves, options.sides, pairs, tMesh);
    for (CountSum& sum : PrescribedSums(map, curves, options.sides, options.prescribed, tMesh))
    {
      sums.push_back(std::move(sum));
    }
    return sums;
  }

  /// Finds the sides and curves of boundary edges whose nodes have moved: only ends of sides are fixed, and a
  /// side may have several curves.
  void NameEdges(QuadMesh& mesh) const
  {
    if (!this->Options.curves.curves.empty())
    {
      NameBoundary(this->Options.sides, this->Curves, mesh);
    }
  }

  /// Pairs the nodes of periodic sides and moves them to positions that match.
  void PairNodes(QuadMesh& mesh) const
  {
    if (this->Pairs.empty())
    {
      return;
    }
    mesh.periodic = this->Pairs;
    const std::vector<QuadPoint> before = mesh.points;
    FindPairs(this->Curves, mesh);
    MatchPairs(this->Curves, mesh);
    // A singularity on one of the sides fixes a node of the other one, beside which others may be
    // in the wrong order.
    OrderOnBoundary(mesh, this->Curves);
    MatchPairs(this->Curves, mesh);
    MoveInside(before, this->Options.hold, mesh);
  }

  /// Makes the problem for a size.
  QuantisationProblem ProblemFor(double size) const
  {
    std::vector<double> target = this->Lengths;
    for (double& length : target)
    {
      length /= size;
    }
    this->Graded.SetTargets(target);
    QuantisationProblem problem = MakeQuantisationProblem(this->Result.tMesh, std::move(target));
    problem.sums = this->Sums;
    this->Graded.SetWeights(problem);
    if (this->Balances)
    {
      BalanceTargets(this->Result.tMesh, problem);
    }
    constexpr double WithoutEdges =
      1000.0; // factor of the cost of an edge where there should be none
    for (const std::size_t arc : this->Options.arcsWithoutEdges)
    {
      problem.target[arc] = 0.0;
      problem.weight[arc] *= WithoutEdges;
    }
    return problem;
  }

  /// Returns the counts of a problem for a size, with enough edges around smooth loops.
  EdgeCounts CountsOf(QuantisationProblem problem, double size, SearchEffort effort) const
  {
    EdgeCounts counts = Quantise(this->Result.tMesh, problem, effort);
    return this->LoopsWithoutCorners.RaiseTargets(size, counts.counts, problem)
      ? Quantise(this->Result.tMesh, problem, effort)
      : counts;
  }

  EdgeCounts QuantiseFor(double size, SearchEffort effort) const
  {
    QuantisationProblem problem = this->ProblemFor(size);
    this->Orbits->Equate(problem);
    return this->CountsOf(std::move(problem), size, effort);
  }

  /// Returns the lists of symmetries for counts, the identity first: all of the domain, two
  /// reflections, and none.
  std::vector<std::vector<Isometry>> SymmetriesToTry() const
  {
    std::vector<std::vector<Isometry>> lists = { this->HasInterfaces
        ? this->Options.symmetries // of both sides of interfaces are none
        : FindSymmetries(this->Domain).Elements() };
    if (lists[0].size() <= 1)
    {
      return lists;
    }
    // All others are images of two neighbouring ones under rotations.
    constexpr std::size_t MaximumReflections = 2;
    for (std::size_t i = 1; i < lists[0].size() && lists.size() <= MaximumReflections; ++i)
    {
      if (lists[0][i].reflects)
      {
        lists.push_back({ lists[0][0], lists[0][i] });
      }
    }
    lists.push_back({ lists[0][0] });
    return lists;
  }

  /// Returns the counts for the present orbits.
  EdgeCounts FindCounts(const Progress& progress) const
  {
    return this->SearchCountsOf(
      [&](double size, SearchEffort effort) { return this->QuantiseFor(size, effort); }, progress);
  }

  /// Finds the arcs that get equal counts by symmetries; none if prescribed sums do not permit
  /// that.
  ArcOrbits FindOrbits(const std::vector<Isometry>& symmetries) const
  {
    // Nodes are nearer to their images than this part of an edge, or the mesh does not have the
    // symmetry.
    constexpr double Near = 0.25;
    const double size = FirstSize(this->Options, this->Area);
    const QuantisationProblem problem = this->ProblemFor(size);
    const TMesh& tMesh = this->Result.tMesh;
    ArcOrbits orbits(tMesh, symmetries, problem, Near * size);
    if (orbits.CountSymmetries() == 1 || problem.sums.empty())
    {
      return orbits;
    }
    QuantisationProblem equated = problem;
    orbits.Equate(equated);
    return FindFeasibleCounts(tMesh, equated) ? orbits : ArcOrbits(tMesh, {}, problem, 0.0);
  }

  /// Returns the counts for the given size, or for the one that a search finds.
  EdgeCounts SearchCountsOf(
    const std::function<EdgeCounts(double size, SearchEffort effort)>& countsOf,
    const Progress& progress) const
  {
    return SearchCounts(this->Result.tMesh, this->Options.quadSize, this->Options.quadCount,
      this->Area, countsOf, progress);
  }

  /// Returns the relative error of a requested number of quads, 0 if a size was requested.
  double CountError(const EdgeCounts& counts) const
  {
    return this->Options.quadSize > 0.0
      ? 0.0
      : crossfield::CountError(this->Result.tMesh, counts, this->Options.quadCount);
  }

  const SeamlessMap& Map;
  const std::vector<PairedSides>& Pairs;
  const QuadOptions& Options;
  QuadResult& Result;
  const MeshBoundary& Curves;
  const bool HasInterfaces;
  const PlanarDomain Domain;
  const std::vector<double> Lengths; ///< Target counts for size 1.
  const double Area;
  const GradedArcs Graded;
  const SmoothLoops LoopsWithoutCorners;
  const std::vector<CountSum> Sums; ///< Prescribed for sides of the boundary.
  bool Balances = false;            ///< Whether strips take the means of their targets.
  std::optional<ArcOrbits> Orbits;  ///< Set by ComputeCounts.
};
}

void RequireSize(double quadSize, int quadCount)
{
  if (!(quadSize >= 0.0) || !std::isfinite(quadSize) || (quadSize == 0.0 && quadCount < 1))
  {
    throw Error("The size of quads must be a positive number, or their count at least 1.");
  }
}

QuadResult MakeDraftQuads(
  const LayoutSet& layouts, const QuadOptions& options, const Progress& progress)
{
  RequireSize(options.quadSize, options.quadCount);
  const Layout& layout = layouts.Single();
  const SeamlessMap& map = layout.map;
  QuadResult result;
  result.tMesh = layout.tMesh;
  const MeshBoundary curves(*RequirePlanar(map.topology), options.curves);
  SplitAtSides(map, curves, options.sides, options.prescribed,
    FirstSize(options, AreaOf(result.tMesh)), result.tMesh);
  SplitAtPairs(map, curves, options.sides, layouts.pairs, result.tMesh);
  Mesher mesher(map, layouts.pairs, curves, options, result);
  mesher.ComputeCounts(progress);
  mesher.Build(result);
  RequireSuitableCounts(result.mesh, mesher.DomainArea(), options.sides, options.prescribed);
  result.separateBlocks = static_cast<int>(result.blocks.blocks.size());
  return result;
}

void SmoothDraftQuads(
  const LayoutSet& layouts, const QuadOptions& options, QuadResult& quads, const Progress& progress)
{
  const SeamlessMap& map = layouts.Single().map;
  const MeshBoundary curves(*RequirePlanar(map.topology), options.curves);
  Mesher mesher(map, layouts.pairs, curves, options, quads);
  const double smoothed = options.coarse ? 0.5 : 1.0;
  mesher.Smooth(quads, progress.Part(0.0, smoothed));
  if (options.coarse)
  {
    mesher.Coarsen(progress.Part(smoothed, 1.0));
  }
  progress.Report(1.0);
}

QuadResult MakeQuads(const LayoutSet& layouts, const QuadOptions& options, const Progress& progress)
{
  QuadResult result = MakeDraftQuads(layouts, options, progress.Part(0.0, 0.4));
  if (options.smooth)
  {
    SmoothDraftQuads(layouts, options, result, progress.Part(0.4, 1.0));
  }
  else
  {
    result.quality = MeasureQuads(result.mesh, result.size);
  }
  return result;
}
}
