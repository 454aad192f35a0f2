#include "QuadWorkflow.h"

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
/// A seamless map and the patches between its separatrices.
struct Layout
{
  SeamlessMap map;
  TMesh separatrices;
};

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
  }

  QuadWorkflowResult TakeResult() { return std::move(this->Result); }

private:
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
  Layout layout = workflow.LayOut(remaining.Part(0.1, 0.6));
  workflow.MakeQuads(layout.map, std::move(layout.separatrices), remaining.Part(0.6, 0.95));
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

std::vector<std::string> WarningsOf(const QuadRequest& request, const QuadWorkflowResult& result)
{
  std::vector<std::string> warnings;
  if (result.optimum && !result.optimum->converged && !result.optimum->aborted)
  {
    warnings.push_back(result.optimum->reason);
  }
  if (!HasRequestedCount(request, result.quads))
  {
    warnings.push_back("No number of quads within 5 % of " + std::to_string(request.quadCount) +
      " was found for these separatrices; " + std::to_string(result.quads.mesh.quads.size()) +
      " is the nearest; request another number.");
  }
  if (result.flattening && result.flattening->PredictedStretch() > NoticeableStretch)
  {
    warnings.push_back(DescribeStretch(*result.flattening) +
      " Move singularities, or repair the holonomy, to lower it.");
  }
  const std::string worst = DescribeWorstQuad(result.quads.mesh, result.quads.quality);
  if (!worst.empty())
  {
    warnings.push_back(worst);
  }
  return warnings;
}

bool HasRequestedCount(const QuadRequest& request, const QuadResult& quads)
{
  const auto count = static_cast<double>(quads.mesh.quads.size());
  return request.quadSize != 0.0 || std::abs(count / request.quadCount - 1.0) <= CountTolerance;
}
}
