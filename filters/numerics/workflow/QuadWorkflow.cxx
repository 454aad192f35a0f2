#include "QuadWorkflow.h"

#include "CleanBlocks.h"
#include "HolePattern.h"
#include "MeshForPoints.h"
#include "MeshRetry.h"
#include "PoincareHopf.h"
#include "SizeSearch.h"
#include "Stopwatch.h"
#include "TMeshPatches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Throws Error if a domain needs more quads of a size than can be numbered, which would otherwise
/// be noticed after a long search for edge counts.
void RequireCountable(const PlanarDomain& domain, double quadSize)
{
  constexpr double MaximumQuads = std::numeric_limits<int>::max();
  const double quads = domain.Area() / quadSize / quadSize;
  if (quadSize > 0.0 && quads > MaximumQuads)
  {
    std::ostringstream text;
    text.precision(3);
    text << "The domain would need more quads of size " << quadSize
         << " than the 2 billion that can be numbered; use a larger size.";
    throw Error(text.str());
  }
}

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

  void Repair(const Progress& progress)
  {
    if (this->Request.repairHolonomy)
    {
      this->Result.repair = RepairForMap(this->Domain, this->Result.singularities, this->MapOptions,
        this->Request.meshSize, progress);
      this->Result.singularities = this->Result.repair->singularities;
    }
    this->Clock.Lap();
  }

  /// Meshes, solves for the map and traces the separatrices.
  ClosingLayout LayOut(const Progress& progress)
  {
    return RetryOnFinerMesh(
      [&](double refinement)
      {
        // A second attempt shares the part of the progress that the first one leaves.
        const Progress part = refinement == 1.0 ? progress.Part(0.0, 0.9) : progress.Part(0.9, 1.0);
        const SharedTopology topology = this->Mesh(refinement, part.Part(0.0, 0.2));
        SeamlessMap map = this->Map(topology, part.Part(0.2, 0.8));
        TMesh separatrices = this->Trace(map, part.Part(0.8, 1.0));
        return ClosingLayout{ this->Result.singularities, std::move(map), std::move(separatrices) };
      },
      this->Result.events);
  }

  /// Makes the quads of a layout, and merges blocks.
  void MakeQuads(ClosingLayout layout, const Progress& progress)
  {
    const bool clean = this->Request.merge == BlockMerge::Clean;
    const QuadOptions options = this->OptionsFor(*layout.map.topology);
    const Progress making = progress.Part(0.0, clean ? 0.2 : 1.0);
    this->Result.quads = crossfield::MakeQuads(
      layout.map, clean ? layout.tMesh : std::move(layout.tMesh), options, making);
    this->Result.blocks.none = this->Result.quads.separateBlocks;
    if (options.coarse)
    {
      this->Result.blocks.coarse = static_cast<int>(this->Result.quads.blocks.blocks.size());
    }
    if (clean)
    {
      this->Clock.Lap();
      this->Clean(
        { std::move(layout), std::move(this->Result.quads) }, options, progress.Part(0.2, 1.0));
      this->Result.seconds.clean = this->Clock.Lap();
    }
    QuadSeconds& seconds = this->Result.seconds;
    seconds.integers = this->Result.quads.counts.seconds;
    seconds.layout = this->Result.quads.layoutSeconds;
    seconds.smooth = this->Result.quads.smoothSeconds;
  }

  QuadWorkflowResult TakeResult() { return std::move(this->Result); }

private:
  QuadOptions OptionsFor(const MeshTopology& topology) const
  {
    QuadOptions options;
    options.quadSize = this->Request.quadSize;
    options.quadCount = this->Request.quadCount;
    options.coarse = this->Request.merge == BlockMerge::Coarse;
    options.sizes.sizing = this->Request.sizing;
    if (this->Request.sizing == Sizing::Field)
    {
      RelativeSizes sizes = ComputeRelativeSizes(this->Request.prescribedSizes, topology);
      options.sizes.field = std::move(sizes.field);
      options.quadSize *= sizes.mean;
      RequireCountable(this->Domain, options.quadSize);
    }
    return options;
  }

  /// Moves singularities so that separatrices meet, if that gives a mesh as good with fewer blocks.
  void Clean(MeshedLayout start, const QuadOptions& quads, const Progress& progress)
  {
    CleanOptions options;
    options.map = this->MapOptions;
    options.meshSize = this->Request.meshSize;
    options.quads = quads;
    bool isPattern = false;
    if (!this->Request.singularities)
    {
      isPattern = this->StartFromPattern(start, options, progress.Part(0.0, 0.2));
    }
    CleanBlocksResult clean =
      CleanBlocks(this->Domain, std::move(start), options, progress.Part(0.2, 1.0));
    this->MapOptions = options.map;
    this->Result.blocks.clean = static_cast<int>(clean.mesh.quads.blocks.blocks.size());
    std::ostringstream text;
    text.precision(3);
    if (isPattern)
    {
      text << "Four singularities around every round hole give a mesh as good with fewer blocks. ";
    }
    if (clean.accepted)
    {
      text << "Singularities were moved by at most " << clean.largestMove
           << " so that separatrices meet. ";
    }
    if (isPattern || clean.accepted)
    {
      text << "There are " << *this->Result.blocks.clean << " blocks instead of "
           << *this->Result.blocks.none << ".";
    }
    else
    {
      text << "No mesh with fewer blocks is as good.";
    }
    this->Result.events.push_back(text.str());
    this->Result.singularities = clean.mesh.layout.singularities;
    this->Describe(clean.mesh.layout.map);
    this->Result.quads = std::move(clean.mesh.quads);
  }

  /// Tries four singularities around every round hole and the singularities of the domain with the
  /// holes filled. Replaces the start if the mesh is as good and has fewer blocks. Returns whether it
  /// did.
  bool StartFromPattern(MeshedLayout& start, CleanOptions& options, const Progress& progress) const
  {
    const std::vector<RoundHole> holes = FindRoundHoles(this->Domain);
    constexpr std::size_t Fewest = 2; // a single hole has no neighbours to line up with
    if (holes.size() < Fewest)
    {
      return false;
    }
    try
    {
      const PlanarDomain filled = FillHoles(this->Domain, holes);
      AutomaticConfiguration choice =
        ChooseSingularities(filled, this->Request, progress.Part(0.0, 0.5));
      SeamlessMapOptions map = this->MapOptions;
      map.corners = choice.corners;
      const ClosingLayout field =
        crossfield::LayOut(filled, choice.singularities, map, options.meshSize);
      Configuration singularities = PatternAroundHoles(holes, field.map);
      singularities.insert(
        singularities.end(), choice.singularities.begin(), choice.singularities.end());
      ClosingLayout layout = crossfield::LayOut(this->Domain, singularities, map, options.meshSize);
      QuadResult quads = crossfield::MakeQuads(layout.map, layout.tMesh, options.quads);
      progress.Report(1.0);
      if (IsCleaner(quads, start.quads) &&
        HasRequestedCount(this->Request, quads) >= HasRequestedCount(this->Request, start.quads))
      {
        start = { std::move(layout), std::move(quads) };
        options.map = std::move(map);
        return true;
      }
    }
    catch (const Error&)
    {
      return false; // the pattern has no layout
    }
    return false;
  }

  /// Sets what the result says about a map.
  void Describe(const SeamlessMap& map)
  {
    this->Result.holonomyDefect = map.holonomyDefect;
    this->Result.flattening = map.flattening;
    this->Result.corners.clear();
    const PlacedConfiguration placed =
      PlaceForMap(*map.topology, this->Result.singularities, this->MapOptions);
    for (const CountedCorner& corner : CountMeshQuarters(*map.topology, placed.corners).corners)
    {
      this->Result.corners.push_back({ corner.position, corner.quarterIndex });
    }
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
  const QuadRequest& Request;
  SeamlessMapOptions MapOptions;
  QuadWorkflowResult Result;
  Stopwatch Clock;
};
}

QuadWorkflowResult MakeQuadMesh(
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
  workflow.Repair(remaining.Part(0.0, 0.1));
  const double laidOut = request.merge == BlockMerge::Clean ? 0.2 : 0.6;
  ClosingLayout layout = workflow.LayOut(remaining.Part(0.1, laidOut));
  workflow.MakeQuads(std::move(layout), remaining.Part(laidOut, 0.95));
  return workflow.TakeResult();
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
