#include "QuadWorkflow.h"

#include "MeshForPoints.h"
#include "PoincareHopf.h"
#include "SizeSearch.h"
#include "Stopwatch.h"
#include "TMeshPatches.h"

#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
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

  SharedTopology Mesh(const Progress& progress)
  {
    const SharedTopology topology = ShareTopology(MeshThroughPoints(
      this->Domain, this->Result.singularities, this->Request.meshSize, progress));
    this->Result.seconds.mesh = this->Clock.Lap();
    return topology;
  }

  SeamlessMap Map(const SharedTopology& topology, const Progress& progress)
  {
    SeamlessMap map =
      SolveSeamlessMap(topology, this->Result.singularities, this->MapOptions, progress);
    this->Result.holonomyDefect = map.holonomyDefect;
    const PlacedConfiguration placed =
      PlaceForMap(*topology, this->Result.singularities, this->MapOptions);
    for (const CountedCorner& corner : CountMeshQuarters(*topology, placed.corners).corners)
    {
      this->Result.corners.push_back({ corner.position, corner.quarterIndex });
    }
    this->Result.seconds.map = this->Clock.Lap();
    return map;
  }

  TMesh Trace(const SeamlessMap& map, const Progress& progress)
  {
    TMesh separatrices = MakeTMesh(map, TraceSeparatrices(map, progress));
    this->Result.seconds.trace = this->Clock.Lap();
    return separatrices;
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
    }
    this->Result.quads = crossfield::MakeQuads(map, std::move(separatrices), options, progress);
    QuadSeconds& seconds = this->Result.seconds;
    seconds.integers = this->Result.quads.counts.seconds;
    seconds.layout = this->Result.quads.layoutSeconds;
    seconds.smooth = this->Result.quads.smoothSeconds;
  }

  QuadWorkflowResult TakeResult() { return std::move(this->Result); }

private:
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
  const double chosen = request.singularities ? 0.0 : 0.5;
  const Progress remaining = progress.Part(chosen, 1.0);
  Workflow workflow(domain, request);
  workflow.Choose(progress.Part(0.0, chosen));
  workflow.Repair(remaining.Part(0.0, 0.1));
  const SharedTopology topology = workflow.Mesh(remaining.Part(0.1, 0.2));
  const SeamlessMap map = workflow.Map(topology, remaining.Part(0.2, 0.5));
  TMesh separatrices = workflow.Trace(map, remaining.Part(0.5, 0.6));
  workflow.MakeQuads(map, std::move(separatrices), remaining.Part(0.6, 0.95));
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
