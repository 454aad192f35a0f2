#include "QuadSteps.h"

#include "Candidates.h"
#include "CleanBlocks.h"
#include "IndexSplit.h"
#include "LayerSteps.h"
#include "MeshForPoints.h"
#include "MeshRetry.h"
#include "NodePositions.h"
#include "PatternStart.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "QuadBudget.h"
#include "RequestedSingularities.h"
#include "SizingChoice.h"
#include "Stopwatch.h"
#include "TMeshPatches.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Throws Error if a singularity on the boundary makes the quarter index there 2 or more, which
/// leaves no angle for a quad. Capping changes corners of the domain only.
void RequireAngles(const PlanarDomain& domain, const Configuration& singularities,
  const std::vector<CountedCorner>& corners)
{
  const double reach = BoundaryReach * domain.Diagonal();
  for (const CountedCorner& corner : corners)
  {
    const bool isSingular = std::any_of(singularities.begin(), singularities.end(),
      [&](const Singularity& singularity)
      {
        return singularity.quarterIndex > 0 &&
          (singularity.position - corner.position).norm() <= reach;
      });
    if (isSingular && corner.quarterIndex > 1)
    {
      throw Error("With the singularities at " + Describe(corner.position) +
        ", the boundary there has quarter index " + std::to_string(corner.quarterIndex) +
        ", which leaves no angle for a quad; give singularities of index 1 inside the domain "
        "instead.");
    }
  }
}

/// Returns a layout with quads whose separatrices are merged without moving singularities.
MeshedLayout WithMergedBlocks(
  const MeshedLayout& meshed, QuadOptions options, const Progress& progress)
{
  options.coarse = true;
  MeshedLayout merged{ meshed.layout, {} };
  merged.quads = crossfield::MakeQuads(merged.layout.map, merged.layout.tMesh, options, progress);
  return merged;
}

/// The steps of MakeQuadMesh, in their order, and what they share.
class Workflow
{
public:
  Workflow(const PlanarDomain& domain, QuadRequest request)
    : Domain(domain)
    , Request(std::move(request))
    , Total(this->Request.quadCount)
  {
    RequireLayers(this->Request.layers, SidesOf(domain, this->Request).names);
    if (!this->Request.layers.empty() && this->Request.quadSize == 0.0)
    {
      this->Request.quadCount = CountBeforeLayers(domain, this->Request);
    }
    this->MapOptions.corners = CompleteCorners(domain, this->Request);
    this->MapOptions.capCorners = this->Request.capCorners;
  }

  void Choose(const Progress& progress)
  {
    if (this->Request.singularities)
    {
      this->Result.singularities = *this->Request.singularities;
      return;
    }
    AutomaticConfiguration choice = ChooseSingularities(this->Domain, this->Request, progress);
    this->Result.singularities = std::move(choice.singularities);
    this->Result.events = std::move(choice.events);
    this->Result.optimum = std::move(choice.optimum);
    this->MapOptions.corners = std::move(choice.corners);
    this->Result.seconds.choose = this->Clock.Lap();
  }

  /// Splits large quarter indices on request; otherwise throws Error for those without a node.
  void Split()
  {
    if (this->Request.split)
    {
      SplitConfiguration split =
        SplitIndices(this->Domain, this->Result.singularities, 1.5 * this->SideLength());
      this->Result.singularities = std::move(split.singularities);
      this->AddEvents(split.events);
    }
    RequireNodes(this->Domain, this->Result.singularities);
    this->Started = this->Result.singularities;
  }

  void Repair(const Progress& progress)
  {
    if (!this->Request.repairHolonomy)
    {
      return;
    }
    try
    {
      HolonomyRepair repair = RepairForMap(
        this->Domain, this->Started, this->MapOptions, this->Request.meshSize, progress);
      const double part = this->Request.repairPart;
      for (std::size_t i = 0; part < 1.0 && i < this->Started.size(); ++i)
      {
        Point& position = repair.singularities[i].position;
        position = (1.0 - part) * this->Started[i].position + part * position;
      }
      repair.largestMove *= part;
      this->UseRepair(std::move(repair));
    }
    catch (const Error& error)
    {
      if (this->Request.singularities)
      {
        throw;
      }
      this->AddEvents({ "The holonomy was not repaired. " + std::string(error.what()) });
    }
    this->Result.seconds.choose += this->Clock.Lap();
  }

  /// Runs LayOut. If that fails, it is tried with the holonomy repaired: chosen singularities are
  /// used there; for given ones the error offers it.
  ClosingLayout LayOutOrAdvise(const Progress& progress)
  {
    try
    {
      return this->LayOut(progress.Part(0.0, 0.9));
    }
    catch (const CoarseMeshError& error)
    {
      std::optional<ClosingLayout> layout = this->TryRepaired(progress.Part(0.9, 1.0));
      if (!layout)
      {
        throw;
      }
      if (this->Request.singularities)
      {
        throw Error(WithAdvice(error.what(), RepairAdvice(*this->Result.repair)));
      }
      this->AddEvents({ "The singularities were moved so that grid lines close up around the inner "
                        "loops. Without this: " +
        std::string(error.what()) });
      return std::move(*layout);
    }
  }

  /// Meshes, solves for the map and traces the separatrices.
  ClosingLayout LayOut(const Progress& progress)
  {
    return RetryOnFinerMesh(
      [&](double refinement)
      {
        // A second attempt shares the part of the progress that the first one leaves.
        const Progress part = refinement == 1.0 ? progress.Part(0.0, 0.9) : progress.Part(0.9, 1.0);
        const SharedPlanarTopology topology = this->Mesh(refinement, part.Part(0.0, 0.2));
        SeamlessMap map = this->Map(topology, part.Part(0.2, 0.8));
        TMesh separatrices = this->Trace(map, part.Part(0.8, 1.0));
        return ClosingLayout{ this->Result.singularities, std::move(map), std::move(separatrices) };
      },
      this->Result.events);
  }

  /// Makes the quads of a layout, and merges blocks.
  void MakeQuads(ClosingLayout layout, const Progress& progress)
  {
    const bool coarse = this->Request.merge == BlockMerge::Coarse;
    const bool clean = coarse || this->Request.merge == BlockMerge::Clean;
    QuadOptions options = this->OptionsFor(*RequirePlanar(layout.map.topology));
    MeshedLayout meshed{ std::move(layout), {} };
    const Progress making = progress.Part(0.0, clean ? 0.2 : 1.0);
    meshed.quads =
      crossfield::MakeQuads(meshed.layout.map, meshed.layout.tMesh, options, making.Part(0.0, 0.5));
    this->Result.blocks.none = meshed.quads.separateBlocks;
    const std::optional<MeshedLayout> start = coarse ? std::make_optional(meshed) : std::nullopt;
    double moved = 0.0;
    this->Clock.Lap();
    if (clean)
    {
      moved = this->Clean(meshed, options, progress.Part(0.2, 0.8));
    }
    // Whether separatrices meet is decided with the sizes of the map, whose quads show it best.
    if (IsSizingFree(this->Request))
    {
      this->AddEvents(
        ChooseSizing(meshed, options, clean ? progress.Part(0.8, 0.9) : making.Part(0.5, 1.0)));
    }
    const auto blocks = static_cast<int>(meshed.quads.blocks.blocks.size());
    (clean ? this->Result.blocks.clean : this->Result.blocks.none) = blocks;
    if (start)
    {
      moved = this->Merge(*start, options, moved, meshed, progress.Part(0.9, 1.0));
    }
    this->Result.seconds.clean = clean ? this->Clock.Lap() : 0.0;
    if (!this->Request.layers.empty())
    {
      this->Result.layers = AddLayersForCount(this->Domain, this->Request, this->Total,
        meshed.layout.map, meshed.layout.tMesh, options, meshed.quads);
    }
    QuadSeconds& seconds = this->Result.seconds;
    seconds.integers = meshed.quads.counts.seconds;
    seconds.layout = meshed.quads.layoutSeconds;
    seconds.smooth = meshed.quads.smoothSeconds;
    NodePositions nodes = FindNodePositions(
      meshed.layout.map, meshed.quads.mesh, this->Result.singularities, this->Started);
    this->Result.singularities = std::move(nodes.singularities);
    this->Result.moved = std::max(moved, nodes.moved);
    this->Result.quads = std::move(meshed.quads);
    this->AddEvents(nodes.events);
    if (this->Result.quads.smoothing.isAsymmetric)
    {
      this->AddEvents({ "The quads have no symmetry, because the nodes of periodic sides would not "
                        "match then." });
    }
    this->AddWarnings();
  }

  QuadWorkflowResult TakeResult() { return std::move(this->Result); }

private:
  QuadOptions OptionsFor(const PlanarTopology& topology) const
  {
    QuadOptions options;
    options.quadSize = this->Request.quadSize;
    options.quadCount = this->Request.quadCount;
    options.sizes.sizing = this->Request.sizing.value_or(Sizing::Conformal);
    options.sides = this->Request.sides;
    options.curves = this->Request.curves;
    options.prescribed = this->Request.prescribed;
    options.periodic = this->Request.periodic;
    if (this->Request.sizing == Sizing::Field)
    {
      RelativeSizes sizes = ComputeRelativeSizes(this->Request.prescribedSizes, topology);
      options.sizes.field = std::move(sizes.field);
      options.quadSize *= sizes.mean;
      RequireQuadSize(this->Domain, options.quadSize);
    }
    return options;
  }

  /// Moves singularities so that separatrices meet, if that gives a mesh as good with fewer blocks.
  /// Returns the largest move.
  double Clean(MeshedLayout& meshed, const QuadOptions& quads, const Progress& progress)
  {
    CleanOptions options;
    options.map = this->MapOptions;
    options.meshSize = this->Request.meshSize;
    options.quads = quads;
    this->FirstCorners = this->MapOptions.corners;
    // The singularities of a pattern are close to holes, and layers need room.
    const bool isPattern = !this->Request.singularities && this->Request.layers.empty() &&
      StartFromPattern(this->Domain, this->Request, meshed, options, progress.Part(0.0, 0.2));
    CleanBlocksResult clean =
      CleanBlocks(this->Domain, std::move(meshed), options, progress.Part(0.2, 1.0));
    meshed = std::move(clean.mesh);
    this->MapOptions = options.map;
    this->Result.blocks.clean = static_cast<int>(meshed.quads.blocks.blocks.size());
    this->CleanEvent = this->Result.events.size();
    this->AddEvents({ DescribeClean(clean, isPattern, this->Result.blocks) });
    this->Result.singularities = meshed.layout.singularities;
    this->Started = meshed.layout.singularities;
    this->Describe(meshed.layout.map);
    return clean.largestMove;
  }

  /// Merges separatrices without moving singularities, in the layout with the fewest blocks: in that
  /// of `clean` or, if that has more blocks, in that of `start`. Returns the largest move.
  double Merge(const MeshedLayout& start, const QuadOptions& options, double moved,
    MeshedLayout& clean, const Progress& progress)
  {
    // Layouts without moves are the same.
    const bool isMoved = clean.layout.map.topology != start.layout.map.topology;
    std::vector<MeshedLayout> results;
    ProgressOfParts shared(progress);
    AcceptFirst(
      isMoved ? 2 : 1, CandidateBatch(clean.quads.mesh.quads.size()),
      [&](std::size_t i)
      {
        const double done = isMoved ? 0.5 * static_cast<double>(i) : 0.0;
        return WithMergedBlocks(
          i == 0 ? clean : start, options, shared.Get().Part(done, isMoved ? done + 0.5 : 1.0));
      },
      [&](std::size_t, MeshedLayout result)
      {
        results.push_back(std::move(result));
        return false;
      });
    const auto isBetter = [](const QuadResult& a, const QuadResult& b)
    {
      return a.blocks.blocks.size() != b.blocks.blocks.size()
        ? a.blocks.blocks.size() < b.blocks.blocks.size()
        : a.quality.jacobian.min > b.quality.jacobian.min;
    };
    if (isBetter(results[0].quads, clean.quads))
    {
      clean.quads = std::move(results[0].quads);
    }
    if (isMoved && isBetter(results[1].quads, clean.quads))
    {
      clean = std::move(results[1]);
      moved = 0.0;
      this->MapOptions.corners = this->FirstCorners;
      this->Result.singularities = this->Started = clean.layout.singularities;
      this->Describe(clean.layout.map);
      this->Result.events[this->CleanEvent] = "Blocks were merged without moving singularities.";
    }
    this->Result.blocks.coarse = static_cast<int>(clean.quads.blocks.blocks.size());
    return moved;
  }

  /// Sets what the result says about a map.
  void Describe(const SeamlessMap& map)
  {
    this->Result.holonomyDefect = map.holonomyDefect;
    this->Result.flattening = map.flattening;
    this->Result.corners.clear();
    const SharedPlanarTopology topology = RequirePlanar(map.topology);
    const PlacedConfiguration placed =
      PlaceForMap(*topology, this->Result.singularities, this->MapOptions);
    for (const CountedCorner& corner : CountMeshQuarters(*topology, placed.corners).corners)
    {
      this->Result.corners.push_back({ corner.position, corner.quarterIndex });
    }
  }

  void AddEvents(const std::vector<std::string>& events)
  {
    this->Result.events.insert(this->Result.events.end(), events.begin(), events.end());
  }

  void UseRepair(HolonomyRepair repair)
  {
    this->Result.singularities = repair.singularities;
    this->Result.repair = std::move(repair);
  }

  /// Returns a repair of the holonomy that was not requested; none if there is nothing to repair or
  /// it is impossible.
  std::optional<HolonomyRepair> FindRepair() const
  {
    if (this->Result.repair || this->Domain.loops.size() < 2)
    {
      return std::nullopt;
    }
    try
    {
      HolonomyRepair repair =
        RepairForMap(this->Domain, this->Started, this->MapOptions, this->Request.meshSize);
      if (std::any_of(repair.before.begin(), repair.before.end(),
            [](double defect) { return std::abs(defect) > NoticeableDefect; }))
      {
        return repair;
      }
    }
    catch (const Error&)
    {
      // No repair exists.
    }
    return std::nullopt;
  }

  /// Repairs the holonomy and runs LayOut again; returns nothing if one of them fails.
  std::optional<ClosingLayout> TryRepaired(const Progress& progress)
  {
    try
    {
      if (std::optional<HolonomyRepair> repair = this->FindRepair())
      {
        this->UseRepair(std::move(*repair));
        return this->LayOut(progress);
      }
    }
    catch (const Error&)
    {
      // The repair does not help.
    }
    return std::nullopt;
  }

  void AddWarnings()
  {
    QuadWorkflowResult& result = this->Result;
    result.warnings = DescribeFlatNodes(this->Domain, result.singularities);
    if (!this->Request.split)
    {
      this->AddEvents(DescribeCrowdedNodes(this->Domain, result.singularities));
    }
    if (result.flattening && result.flattening->PredictedStretch() > NoticeableStretch)
    {
      const std::optional<HolonomyRepair> repair = this->FindRepair();
      result.warnings.push_back(WithAdvice(
        DescribeStretch(*result.flattening), repair ? RepairAdvice(*repair) : std::string()));
    }
  }

  /// Returns the side length of quads that the request asks for.
  double SideLength() const
  {
    return this->Request.quadSize > 0.0 && this->Request.sizing != Sizing::Field
      ? this->Request.quadSize
      : std::sqrt(this->Domain.Area() / this->Request.quadCount);
  }

  SharedPlanarTopology Mesh(double refinement, const Progress& progress)
  {
    SharedPlanarTopology topology = ShareTopology(MeshThroughPoints(
      this->Domain, this->Result.singularities, this->Request.meshSize, progress, refinement));
    this->Result.seconds.mesh += this->Clock.Lap();
    return topology;
  }

  SeamlessMap Map(const SharedPlanarTopology& topology, const Progress& progress)
  {
    const PlacedConfiguration placed =
      PlaceForMap(*topology, this->Result.singularities, this->MapOptions);
    const PoincareHopfCount count = CountMeshQuarters(*topology, placed.corners);
    RequireAngles(this->Domain, this->Result.singularities, count.corners);
    SeamlessMap map =
      SolveSeamlessMap(topology, this->Result.singularities, this->MapOptions, progress);
    this->Describe(map);
    this->Result.seconds.map += this->Clock.Lap();
    return map;
  }

  TMesh Trace(const SeamlessMap& map, const Progress& progress)
  {
    TMesh separatrices = MakeTMesh(map, TraceSeparatrices(map, progress));
    this->Result.seconds.trace += this->Clock.Lap();
    return separatrices;
  }

  const PlanarDomain& Domain;
  /// The request; with layers, quadCount is the number of quads before they are added.
  QuadRequest Request;
  const int Total; ///< Requested number of quads.
  SeamlessMapOptions MapOptions;
  std::vector<CornerChoice> FirstCorners; ///< Corners of MapOptions before blocks were merged.
  std::size_t CleanEvent = 0;             ///< Index of the event about merged blocks.
  Configuration Started;                  ///< The singularities before they were repaired.
  QuadWorkflowResult Result;
  Stopwatch Clock;
};
}

QuadWorkflowResult RunQuadSteps(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  const double chosen = request.singularities ? 0.0 : 0.5;
  const Progress remaining = progress.Part(chosen, 1.0);
  Workflow workflow(domain, request);
  workflow.Choose(progress.Part(0.0, chosen));
  workflow.Split();
  workflow.Repair(remaining.Part(0.0, 0.1));
  const double laidOut = request.merge == BlockMerge::None ? 0.6 : 0.2;
  ClosingLayout layout = workflow.LayOutOrAdvise(remaining.Part(0.1, laidOut));
  workflow.MakeQuads(std::move(layout), remaining.Part(laidOut, 0.95));
  return workflow.TakeResult();
}
}
