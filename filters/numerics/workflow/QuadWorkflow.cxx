#include "QuadWorkflow.h"

#include "IndexSplit.h"
#include "MeshForPoints.h"
#include "MeshRetry.h"
#include "NodePositions.h"
#include "PoincareHopf.h"
#include "QuadAdvice.h"
#include "SizeSearch.h"
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
/// A seamless map and the patches between its separatrices.
struct Layout
{
  SeamlessMap map;
  TMesh separatrices;
};

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
  Workflow(const PlanarDomain& domain, const QuadRequest& request)
    : Domain(domain)
    , Request(request)
  {
    this->MapOptions.corners = request.corners;
    this->MapOptions.capCorners = request.capCorners;
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
      this->UseRepair(RepairForMap(
        this->Domain, this->Started, this->MapOptions, this->Request.meshSize, progress));
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

  /// Lays out as LayOut does. If that fails, it is tried with the holonomy repaired: chosen
  /// singularities are used there; for given ones the error offers it.
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
        const SharedTopology topology = this->Mesh(refinement, part.Part(0.0, 0.2));
        SeamlessMap map = this->Map(topology, part.Part(0.2, 0.8));
        TMesh separatrices = this->Trace(map, part.Part(0.8, 1.0));
        return Layout{ std::move(map), std::move(separatrices) };
      },
      this->Result.events);
  }

  void MakeQuads(const SeamlessMap& map, TMesh separatrices, const Progress& progress)
  {
    QuadOptions options;
    options.quadSize = this->Request.quadSize;
    options.quadCount = this->Request.quadCount;
    options.coarse = this->Request.coarse;
    options.sizes.sizing = this->Request.sizing;
    if (this->Request.sizing == Sizing::Field)
    {
      RelativeSizes sizes = ComputeRelativeSizes(this->Request.prescribedSizes, *map.topology);
      options.sizes.field = std::move(sizes.field);
      options.quadSize *= sizes.mean;
      RequireCountable(this->Domain, options.quadSize);
    }
    this->Result.quads = crossfield::MakeQuads(map, std::move(separatrices), options, progress);
    QuadSeconds& seconds = this->Result.seconds;
    seconds.integers = this->Result.quads.counts.seconds;
    seconds.layout = this->Result.quads.layoutSeconds;
    seconds.smooth = this->Result.quads.smoothSeconds;
    NodePositions nodes =
      FindNodePositions(map, this->Result.quads.mesh, this->Result.singularities, this->Started);
    this->Result.singularities = std::move(nodes.singularities);
    this->Result.moved = nodes.moved;
    this->AddEvents(nodes.events);
    this->AddWarnings();
  }

  QuadWorkflowResult TakeResult() { return std::move(this->Result); }

private:
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

  /// Repairs the holonomy and lays out again; returns nothing if one of them fails.
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

  SharedTopology Mesh(double refinement, const Progress& progress)
  {
    SharedTopology topology = ShareTopology(MeshThroughPoints(
      this->Domain, this->Result.singularities, this->Request.meshSize, progress, refinement));
    this->Result.seconds.mesh += this->Clock.Lap();
    return topology;
  }

  SeamlessMap Map(const SharedTopology& topology, const Progress& progress)
  {
    const PlacedConfiguration placed =
      PlaceForMap(*topology, this->Result.singularities, this->MapOptions);
    const PoincareHopfCount count = CountMeshQuarters(*topology, placed.corners);
    RequireAngles(this->Domain, this->Result.singularities, count.corners);
    SeamlessMap map =
      SolveSeamlessMap(topology, this->Result.singularities, this->MapOptions, progress);
    this->Result.holonomyDefect = map.holonomyDefect;
    this->Result.flattening = map.flattening;
    this->Result.corners.clear();
    for (const CountedCorner& corner : count.corners)
    {
      this->Result.corners.push_back({ corner.position, corner.quarterIndex });
    }
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
  const QuadRequest& Request;
  SeamlessMapOptions MapOptions;
  Configuration Started; ///< The singularities before they were repaired.
  QuadWorkflowResult Result;
  Stopwatch Clock;
};
}

namespace
{
/// Runs the steps of MakeQuadMesh once.
QuadWorkflowResult RunSteps(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  if (request.sizing != Sizing::Field) // whose sizes are factors
  {
    RequireCountable(domain, request.quadSize);
  }
  const double chosen = request.singularities ? 0.0 : 0.5;
  const Progress remaining = progress.Part(chosen, 1.0);
  Workflow workflow(domain, request);
  workflow.Choose(progress.Part(0.0, chosen));
  workflow.Split();
  workflow.Repair(remaining.Part(0.0, 0.1));
  Layout layout = workflow.LayOutOrAdvise(remaining.Part(0.1, 0.6));
  workflow.MakeQuads(layout.map, std::move(layout.separatrices), remaining.Part(0.6, 0.95));
  return workflow.TakeResult();
}

/// Adds warnings about the choice, the number of quads and nearly degenerate quads.
void AddWarnings(const QuadRequest& request, QuadWorkflowResult& result)
{
  if (result.optimum && !result.optimum->converged && !result.optimum->aborted)
  {
    result.warnings.push_back(result.optimum->reason);
  }
  if (!HasRequestedCount(request, result.quads))
  {
    result.warnings.push_back("No number of quads within 5 % of " +
      std::to_string(request.quadCount) + " was found for these separatrices; " +
      std::to_string(result.quads.mesh.quads.size()) + " is the nearest; request another number.");
  }
  const std::string worst = DescribeWorstQuad(result.quads.mesh, result.quads.quality);
  if (!worst.empty())
  {
    result.warnings.push_back(worst);
  }
}
}

QuadWorkflowResult MakeQuadMesh(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  const Progress trial = progress.Part(1.0, 1.0);
  QuadWorkflowResult result;
  try
  {
    result = RunSteps(domain, request, progress);
  }
  catch (const CoarseMeshError& error)
  {
    // Its remedy, a finer mesh, was tried.
    const double length = FindSmoothing(domain, request.corners,
      [&](const PlanarDomain& smooth) { RunSteps(smooth, request, trial); });
    throw Error(WithAdvice(
      WithoutRemedy(error.what()), SmoothingAdvice(length, request.singularities.has_value())));
  }
  if (result.quads.quality.inverted > 0 && DescribeFlatNodes(domain, result.singularities).empty())
  {
    std::optional<SmallerSize> smaller;
    if (request.sizing != Sizing::Field) // whose sizes are factors
    {
      smaller = FindSmallerSize(result.quads,
        [&](double size)
        {
          QuadRequest other = request;
          other.quadSize = size;
          return RunSteps(domain, other, trial).quads;
        });
    }
    result.warnings.push_back(DescribeInverted(result.quads.quality, smaller));
  }
  AddWarnings(request, result);
  return result;
}

AutomaticConfiguration ChooseSingularities(
  const PlanarDomain& domain, const QuadRequest& request, const Progress& progress)
{
  AutomaticOptions options;
  options.proposal.corners = request.corners;
  if (request.capCorners)
  {
    CapCorners(domain, options);
  }
  options.optimizer.meshSize = request.meshSize;
  options.optimizer.clearance = request.clearance;
  options.optimizer.pairs = request.pairs;
  options.optimizer.sizes.sizing = request.sizing;
  options.quadSize = request.quadSize;
  options.quadCount = request.quadCount;
  if (request.sizing == Sizing::Field)
  {
    RelativeSizes sizes = ComputeRelativeSizes(request.prescribedSizes, domain, request.meshSize);
    options.optimizer.sizes.field = std::move(sizes.field);
    options.quadSize *= sizes.mean;
  }
  return ChooseConfiguration(domain, options, progress);
}

HolonomyRepair RepairForMap(const PlanarDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double meshSize, const Progress& progress)
{
  std::vector<CornerChoice> corners = options.corners;
  if (options.capCorners)
  {
    corners = CapCorners(CountQuarters(domain.loops, 0, DefaultCornerAngle, corners), corners);
  }
  return RepairHolonomy(domain, singularities, corners, meshSize, progress);
}

bool HasRequestedCount(const QuadRequest& request, const QuadResult& quads)
{
  const auto count = static_cast<double>(quads.mesh.quads.size());
  return request.quadSize != 0.0 || std::abs(count / request.quadCount - 1.0) <= CountTolerance;
}
}
