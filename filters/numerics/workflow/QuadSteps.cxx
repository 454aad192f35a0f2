#include "QuadSteps.h"

#include "IndexSplit.h"
#include "LayerSteps.h"
#include "MergedQuads.h"
#include "MeshForPoints.h"
#include "MeshRetry.h"
#include "NodePositions.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "RequestedSingularities.h"
#include "Stopwatch.h"

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
  Layout LayOutOrAdvise(const Progress& progress)
  {
    try
    {
      return this->LayOut(progress.Part(0.0, 0.9));
    }
    catch (const CoarseMeshError& error)
    {
      std::optional<Layout> layout = this->TryRepaired(progress.Part(0.9, 1.0));
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
  Layout LayOut(const Progress& progress)
  {
    return RetryOnFinerMesh(
      [&](double refinement)
      {
        // A second attempt shares the part of the progress that the first one leaves.
        const Progress part = refinement == 1.0 ? progress.Part(0.0, 0.9) : progress.Part(0.9, 1.0);
        const Configuration& singularities = this->Result.singularities;
        const SharedPlanarTopology topology = ShareTopology(MeshThroughPoints(
          this->Domain, singularities, this->Request.meshSize, part.Part(0.0, 0.2), refinement));
        QuadSeconds& seconds = this->Result.seconds;
        seconds.mesh += this->Clock.Lap();
        RequireAngles(this->Domain, singularities, this->CornersOn(*topology));
        Layout layout = crossfield::LayOut(topology, singularities, this->MapOptions,
          this->Request.merge != BlockMerge::None, part.Part(0.2, 1.0));
        seconds.map += layout.mapSeconds;
        seconds.trace += layout.traceSeconds;
        this->Clock.Lap();
        return layout;
      },
      this->Result.events);
  }

  /// Makes the quads of a layout, merges blocks and adds layers.
  void MakeQuads(Layout layout, const Progress& progress)
  {
    MergedQuads merged =
      MakeMergedQuads(this->Domain, this->Request, std::move(layout), this->MapOptions, progress);
    this->MapOptions = std::move(merged.map);
    this->AddEvents(merged.events);
    this->Result.blocks = merged.blocks;
    const Layout& used = merged.mesh.layouts.Single();
    if (this->Request.merge != BlockMerge::None)
    {
      this->Result.singularities = this->Started = used.singularities;
    }
    this->Describe(used);
    QuadResult& quads = merged.mesh.quads;
    if (!this->Request.layers.empty())
    {
      this->Result.layers = AddLayersForCount(
        this->Domain, this->Request, this->Total, merged.mesh.layouts, merged.options, quads);
    }
    QuadSeconds& seconds = this->Result.seconds;
    seconds.clean = merged.cleanSeconds;
    seconds.integers = quads.counts.seconds;
    seconds.layout = quads.layoutSeconds;
    seconds.smooth = quads.smoothSeconds;
    NodePositions nodes =
      FindNodePositions(used.map, quads.mesh, this->Result.singularities, this->Started);
    this->Result.singularities = std::move(nodes.singularities);
    this->Result.moved = std::max(merged.moved, nodes.moved);
    this->AddEvents(nodes.events);
    if (quads.smoothing.isAsymmetric)
    {
      this->AddEvents({ "The quads have no symmetry, because the nodes of periodic sides would not "
                        "match then." });
    }
    this->Result.quads = std::move(quads);
    this->AddWarnings();
  }

  QuadWorkflowResult TakeResult() { return std::move(this->Result); }

private:
  /// Returns the corners of a mesh with their quarter indices.
  std::vector<CountedCorner> CornersOn(const PlanarTopology& topology) const
  {
    const PlacedConfiguration placed =
      PlaceForMap(topology, this->Result.singularities, this->MapOptions);
    return CountMeshQuarters(topology, placed.corners).corners;
  }

  /// Sets what the result says about a map.
  void Describe(const Layout& layout)
  {
    this->Result.holonomyDefect = layout.map.holonomyDefect;
    this->Result.flattening = layout.map.flattening;
    this->Result.corners.clear();
    for (const CountedCorner& corner : this->CornersOn(*RequirePlanar(layout.map.topology)))
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
  std::optional<Layout> TryRepaired(const Progress& progress)
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

  const PlanarDomain& Domain;
  /// The request; with layers, quadCount is the number of quads before they are added.
  QuadRequest Request;
  const int Total; ///< Requested number of quads.
  SeamlessMapOptions MapOptions;
  Configuration Started; ///< The singularities before they were repaired.
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
  Layout layout = workflow.LayOutOrAdvise(remaining.Part(0.1, laidOut));
  workflow.MakeQuads(std::move(layout), remaining.Part(laidOut, 0.95));
  return workflow.TakeResult();
}
}
